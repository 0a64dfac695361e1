#include "pictures/compare_pictures.hh"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "pictures/read_scene.hh"
#include "terminal/table.hh"
#include "whittle/render/compare.hh"

namespace whittle::app {
namespace {

/// Of equal pictures the PSNR is infinite, for which JSON has no number.
Json decibels_json(double psnr) { return std::isfinite(psnr) ? Json(psnr) : Json(nullptr); }

std::string decibels_text(double psnr) { return std::isfinite(psnr) ? significant(psnr) : "infinite"; }

Json json_of(const render::Comparison& comparison) {
  Json json;
  json["views"] = comparison.views.size();
  json["psnr"] = {{"mean", decibels_json(comparison.mean_psnr)},
                  {"pooled", decibels_json(comparison.pooled_psnr)},
                  {"worst", decibels_json(comparison.worst_psnr)}};
  json["flip"] = {{"mean", comparison.mean_flip}, {"worst", comparison.worst_flip}};
  return json;
}

std::string text_of(const render::Comparison& comparison) {
  Table table;
  table.add({"", "mean", "all views as one", "worst view"});
  table.add({"PSNR, dB", decibels_text(comparison.mean_psnr), decibels_text(comparison.pooled_psnr),
             decibels_text(comparison.worst_psnr)});
  table.add({"FLIP", significant(comparison.mean_flip), "", significant(comparison.worst_flip)});
  return table.text();
}

}  // namespace

void require_pictures() {
  if (const std::optional<std::string> why = render::why_nothing_can_be_drawn()) throw std::runtime_error(*why);
}

PictureErrors compare_pictures(const Input& original, const Input& simplified, const PictureOptions& options) {
  const ReadScene before = read_scene(original);
  const ReadScene after = read_scene(simplified);
  PictureErrors errors;
  for (const auto& [input, scene] : {std::pair(&original, &before), std::pair(&simplified, &after)}) {
    for (const std::string& warning : scene->warnings) errors.warnings.push_back(about(input->name, warning));
  }
  render::Comparison comparison =
      render::compare(before.scene, after.scene,
                      {.n_views = options.n_views, .threads = options.threads, .progress = options.progress});
  errors.json = json_of(comparison);
  errors.json["warnings"] = errors.warnings;
  errors.text = text_of(comparison);
  errors.worst_png = std::move(comparison.worst_png);
  return errors;
}

}  // namespace whittle::app
