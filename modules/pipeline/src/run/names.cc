#include "run/names.hh"

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

}  // namespace

void check_names(const Names& names, const Scene& scene, const std::vector<Attribute>& attributes,
                 const std::string& what, const std::string& option) {
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

void take_categories(const CategoryNames& names, Scene& scene) {
  std::vector<Attribute> numbers;
  for (const Attribute& attribute : scene.read.mesh.attributes) {
    const bool are_numbers = attribute.kind == AttributeKind::scalar || attribute.kind == AttributeKind::category;
    if (are_numbers) numbers.push_back(attribute.without_values());
  }
  check_names(names, scene, numbers, "vertices have no numbers", "--categories");
  set_categories(scene.read.mesh, names);
}

}  // namespace whittle
