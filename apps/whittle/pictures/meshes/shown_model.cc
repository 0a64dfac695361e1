#include "pictures/meshes/shown_model.hh"

namespace whittle::app {

const ShownDeviations* ShownModel::deviations(const std::string& colour) const {
  for (const ShownDeviations& one : surface->deviations) {
    const char* const name = one.kind == AttributeKind::texcoord ? "texcoord"
                             : one.kind == AttributeKind::color  ? "colour"
                                                                 : "normal";
    if (colour == name) return &one;
  }
  return nullptr;
}

bool ShownModel::has(const std::string& colour) const {
  if (colour == "material") return has_materials();
  if (colour == "colours") return has_colors();
  if (colour == "normals") return has_normals();
  return colour == "none" || colour == "valence" || colour == "shape" || range(colour).has_value();
}

std::optional<ShownModel::Range> ShownModel::range(const std::string& colour) const {
  if (colour == "error" && surface->distances) return Range{surface->distances->max, surface->distances->usual};
  if (const ShownDeviations* const found = deviations(colour)) return Range{found->max, found->usual};
  return std::nullopt;
}

}  // namespace whittle::app
