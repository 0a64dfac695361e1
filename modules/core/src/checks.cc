#include "whittle/core/detail/checks.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace whittle {
namespace {

/// \throw std::invalid_argument
[[noreturn]] void refuse(const char* caller, const std::string& what) {
  throw std::invalid_argument(std::string(caller) + ": " + what);
}

/// \return W \pre corners are right
std::size_t check_wedges(const IndexedMesh& mesh, const char* caller) {
  const std::size_t n_corners = 3 * mesh.faces.size();
  if (mesh.wedges.empty()) return mesh.positions.size();
  if (mesh.wedges.size() != n_corners) {
    refuse(caller, "wedges has " + std::to_string(mesh.wedges.size()) + " entries, not " + std::to_string(n_corners));
  }
  std::vector<Index> vertex_of;
  for (std::size_t corner = 0; corner < n_corners; ++corner) {
    const Index w = mesh.wedges[corner];
    const Index v = mesh.faces[corner / 3][corner % 3];
    if (w >= n_corners) refuse(caller, "wedge " + std::to_string(w) + " is above the number of corners");
    if (w >= vertex_of.size()) vertex_of.resize(std::size_t{w} + 1, invalid_index);
    if (vertex_of[w] != invalid_index && vertex_of[w] != v) {
      refuse(caller, "wedge " + std::to_string(w) + " is at two vertices");
    }
    vertex_of[w] = v;
  }
  return vertex_of.size();
}

/// Scalars and categories may be NaN: scanners write it for missing measurements.
void check_finite(const Attribute& attribute, const char* caller) {
  if (attribute.kind == AttributeKind::scalar || attribute.kind == AttributeKind::category) return;
  const auto found =
      std::find_if(attribute.values.begin(), attribute.values.end(), [](double x) { return !std::isfinite(x); });
  if (found == attribute.values.end()) return;
  const auto at = static_cast<std::size_t>(found - attribute.values.begin());
  refuse(caller,
         "value " + std::to_string(at / attribute.n_components) + " of attribute " + attribute.name + " is not finite");
}

void check_finite(const std::vector<std::array<float, 3>>& normals, const char* caller) {
  const auto is_finite = [](const std::array<float, 3>& normal) {
    return std::isfinite(normal[0]) && std::isfinite(normal[1]) && std::isfinite(normal[2]);
  };
  const auto found = std::find_if_not(normals.begin(), normals.end(), is_finite);
  if (found != normals.end()) refuse(caller, "normal " + std::to_string(found - normals.begin()) + " is not finite");
}

}  // namespace

void check_attributes(const IndexedMesh& mesh, const char* caller) {
  const auto check = [caller](const std::string& name, std::size_t length, std::size_t expected) {
    if (length == 0 || length == expected) return;
    refuse(caller, name + " has " + std::to_string(length) + " entries, not " + std::to_string(expected));
  };
  const auto check_all = [&](const std::vector<Attribute>& attributes, std::size_t n) {
    for (const Attribute& attribute : attributes) {
      if (attribute.n_components == 0) refuse(caller, "attribute " + attribute.name + " has no components");
      if (attribute.values.size() != n * attribute.n_components) {
        refuse(caller, "attribute " + attribute.name + " has " + std::to_string(attribute.values.size()) +
                           " values, not " + std::to_string(n * attribute.n_components));
      }
      check_finite(attribute, caller);
    }
  };
  const std::size_t n_wedges = check_wedges(mesh, caller);
  check("normals", mesh.normals.size(), n_wedges);
  check_finite(mesh.normals, caller);
  check("colors", mesh.colors.size(), n_wedges);
  check_all(mesh.attributes, n_wedges);
  check("origins", mesh.origins.size(), mesh.positions.size());
  check_all(mesh.face_attributes, mesh.faces.size());
  check("face_groups", mesh.face_groups.size(), mesh.faces.size());
}

}  // namespace whittle
