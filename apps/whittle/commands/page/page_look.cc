#include "commands/page/page_look.hh"

#include <algorithm>
#include <memory>
#include <utility>

#include "whittle/scene/gltf_file.hh"
#include "files/materials.hh"

namespace whittle::app {
namespace {

/// The images that a page shows, by their numbers; null where it is another one, with a warning.
std::vector<std::shared_ptr<const std::string>> shown_images(const std::vector<MaterialImage>& images,
                                                             const std::string& name,
                                                             std::vector<std::string>& warnings) {
  std::vector<std::shared_ptr<const std::string>> shown;
  for (const MaterialImage& image : images) {
    const bool is_shown = image.bytes && report::is_page_image(*image.bytes);
    shown.push_back(is_shown ? image.bytes : nullptr);
    if (is_shown) continue;
    const std::string problem = image.bytes ? "it is neither PNG nor JPEG nor WebP" : image.problem;
    warnings.push_back(about(name, image.name + " is not shown: " + problem));
  }
  return shown;
}

report::PageMaterial shown(const FileMaterial& material, std::shared_ptr<const std::string> image) {
  report::PageMaterial to;
  to.base_color = image ? material.base_color : material.imageless_color;
  to.image = std::move(image);
  to.texcoord = material.texcoord;
  to.texcoord_transform = material.texcoord_transform;
  to.wrap = {wrap_as<report::PageWrap>(material.wrap[0]), wrap_as<report::PageWrap>(material.wrap[1])};
  to.alpha = alpha_as<report::PageAlpha>(material.alpha_mode);
  to.alpha_cutoff = material.alpha_cutoff;
  return to;
}

}  // namespace

PageLook::PageLook(const Scene& input, std::vector<std::string>& warnings) {
  const FileMaterials materials = read_materials(input);
  for (const std::string& warning : materials.warnings) warnings.push_back(about(input.name, warning));
  if (!materials.are_told) return;
  const auto images = shown_images(materials.images, input.name, warnings);
  const std::vector<std::string>& groups = input.read.mesh.group_names;
  const auto add = [&](const FileMaterial& material) {
    materials_.push_back(shown(material, material.image ? images[*material.image] : nullptr));
    if (materials_.size() <= groups.size()) materials_.back().name = groups[materials_.size() - 1];
  };
  if (input.gltf) {
    for (const auto& [mesh, primitive] : input.gltf->groups()) add(materials.of_meshes[mesh][primitive]);
    colors_ = report::PageColors::linear;
  } else {
    for (const FileMaterial& material : materials.of_meshes[0]) add(material);
  }
}

void PageLook::dress(report::PageSurface& surface) const {
  surface.materials = materials_;
  surface.colors = colors_;
}

}  // namespace whittle::app
