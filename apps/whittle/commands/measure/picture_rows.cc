#include "commands/measure/picture_rows.hh"

#include <cmath>

#include "terminal/table.hh"

namespace whittle::app {
namespace {

/// Null for equal pictures: their PSNR is infinite, which JSON can't express.
Json decibels_json(double psnr) { return std::isfinite(psnr) ? Json(psnr) : Json(nullptr); }

std::string decibels_text(double psnr) { return std::isfinite(psnr) ? significant(psnr) : "infinite"; }

}  // namespace

Json pictures_json(const PictureErrors& errors) {
  Json json;
  json["views"] = errors.n_views;
  json["psnr"] = {{"mean", decibels_json(errors.mean_psnr)},
                  {"pooled", decibels_json(errors.pooled_psnr)},
                  {"worst", decibels_json(errors.worst_psnr)}};
  json["flip"] = {{"mean", errors.mean_flip}, {"worst", errors.worst_flip}};
  json["warnings"] = errors.warnings;
  return json;
}

std::string pictures_table(const PictureErrors& errors) {
  Table table;
  table.add({"", "mean", "all views as one", "worst view"});
  table.add({"PSNR, dB", decibels_text(errors.mean_psnr), decibels_text(errors.pooled_psnr),
             decibels_text(errors.worst_psnr)});
  table.add({"FLIP", significant(errors.mean_flip), "", significant(errors.worst_flip)});
  return table.text();
}

}  // namespace whittle::app
