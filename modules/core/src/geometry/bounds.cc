#include "whittle/core/geometry/bounds.hh"

#include <stdexcept>
#include <string>

#include "whittle/core/detail/checks.hh"

namespace whittle {

Box bounds_of(const IndexedMesh& mesh) {
  if (mesh.faces.empty()) throw std::invalid_argument("mesh has no faces");
  check_corners(mesh.positions.size(), mesh.faces);
  std::vector<std::uint8_t> has_face(mesh.positions.size());
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) has_face[v] = 1;
  }
  Box box;
  for (Index v = 0; v < has_face.size(); ++v) {
    if (has_face[v] == 0) continue;
    const Vec3& position = mesh.positions[v];
    if (!is_in_range(position)) {
      throw std::invalid_argument("position of vertex " + std::to_string(v) + " is not finite, or above 3e150");
    }
    box.extend(position);
  }
  return box;
}

}  // namespace whittle
