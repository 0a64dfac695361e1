#include "pictures/compare_pictures.hh"

#include <optional>
#include <stdexcept>
#include <utility>

#include "pictures/read_scene.hh"
#include "whittle/render/compare.hh"

namespace whittle::app {

void require_pictures() {
  if (const std::optional<std::string> why = render::why_nothing_can_be_drawn()) throw std::runtime_error(*why);
}

PictureErrors compare_pictures(const Scene& original, const Scene& simplified, const PictureOptions& options) {
  const ReadScene before = read_scene(original);
  const ReadScene after = read_scene(simplified);
  PictureErrors errors;
  for (const auto& [input, scene] : {std::pair(&original, &before), std::pair(&simplified, &after)}) {
    for (const std::string& warning : scene->warnings) errors.warnings.push_back(about(input->name, warning));
  }
  render::Comparison comparison =
      render::compare(before.scene, after.scene,
                      {.n_views = options.n_views, .threads = options.threads, .progress = options.progress});
  errors.n_views = comparison.views.size();
  errors.mean_psnr = comparison.mean_psnr;
  errors.pooled_psnr = comparison.pooled_psnr;
  errors.worst_psnr = comparison.worst_psnr;
  errors.mean_flip = comparison.mean_flip;
  errors.worst_flip = comparison.worst_flip;
  errors.worst_png = std::move(comparison.worst_png);
  return errors;
}

}  // namespace whittle::app
