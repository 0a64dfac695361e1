#include "plan/names.hh"

#include <algorithm>

#include "whittle/core/regions.hh"
#include "whittle/scene/errors.hh"

namespace whittle {
namespace {

/// The names of attributes, with commas between.
std::string names_in(const std::vector<Attribute>& attributes) {
  std::string text;
  for (const Attribute& attribute : attributes) text += (text.empty() ? "" : ", ") + attribute.name;
  return text;
}

/// \param names empty: those that are found \param attributes of the scene
/// \param what text for the message: "faces have no property"
/// \throw UnsupportedMesh if none of the attributes has one of the names
void check_names(const std::optional<std::vector<std::string>>& names, const Scene& scene,
                 const std::vector<Attribute>& attributes, const std::string& what, const std::string& option) {
  if (!names) return;
  for (const std::string& name : *names) {
    if (std::any_of(attributes.begin(), attributes.end(), [&](const Attribute& a) { return has_name(a, name); })) {
      continue;
    }
    std::string problem = scene.name;
    problem.append(": ").append(what).append(" '").append(name).append("' for ").append(option);
    problem.append("; they have ").append(attributes.empty() ? "none" : names_in(attributes));
    throw UnsupportedMesh(problem);
  }
}

}  // namespace

void take_categories(const CategoryNames& names, Scene& scene) {
  std::vector<Attribute> numbers;
  for (const Attribute& attribute : scene.read.mesh.attributes) {
    const bool are_numbers = attribute.kind == AttributeKind::scalar || attribute.kind == AttributeKind::category;
    if (are_numbers) numbers.push_back(attribute.without_values());
  }
  check_names(names, scene, numbers, "vertices have no numbers", "--categories");
  set_categories(scene.read.mesh, names);
}

void check_regions(const RegionNames& names, const Scene& scene) {
  check_names(names, scene, scene.read.mesh.face_attributes, "faces have no property", "--regions");
}

}  // namespace whittle
