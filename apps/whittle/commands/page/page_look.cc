#include "commands/page/page_look.hh"

#include <set>
#include <utility>

#include "whittle/scene/materials.hh"

namespace whittle::app {
namespace {

/// A line for each image that a page doesn't show.
void warn_of_hidden_images(const SceneMaterials& materials, const std::string& name,
                           std::vector<std::string>& warnings) {
  std::set<const Image*> seen;
  for (const Material& material : materials.of_groups) {
    if (!material.base_color_texture) continue;
    const Image& image = *material.base_color_texture->image;
    if (!seen.insert(&image).second || !media_type(image.bytes).empty()) continue;
    const std::string problem = image.problem.empty() ? "it is neither PNG nor JPEG nor WebP" : image.problem;
    warnings.push_back(about(name, image.name + " is not shown: " + problem));
  }
}

}  // namespace

PageLook::PageLook(const Scene& input, std::vector<std::string>& warnings) {
  SceneMaterials materials = read_materials(input);
  for (const std::string& warning : materials.warnings) warnings.push_back(about(input.name, warning));
  if (!materials.are_told) return;
  warn_of_hidden_images(materials, input.name, warnings);
  materials_ = std::move(materials.of_groups);
  colors_ = materials.colors;
}

void PageLook::dress(report::PageSurface& surface) const {
  surface.materials = materials_;
  surface.colors = colors_;
}

}  // namespace whittle::app
