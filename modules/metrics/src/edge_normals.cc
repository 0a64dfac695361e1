#include "edge_normals.hh"

#include <span>

#include "whittle/core/geometry/triangle.hh"

namespace whittle::metrics {

std::optional<std::array<Vec3, 2>> normals_at(const IndexedMesh& mesh, const detail::EdgeTable& edges,
                                              std::size_t edge) {
  const std::span<const Index> sides = edges.sides(edge);
  if (sides.size() != 2) return std::nullopt;
  std::array<Vec3, 2> normals;
  for (std::size_t i = 0; i < 2; ++i) {
    const Triangle& face = mesh.faces[detail::face_of(sides[i])];
    normals[i] =
        trusted_normal(mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]).stableNormalized();
    if (normals[i].isZero(0.0)) return std::nullopt;
    // Seen along the edge from its lower to its higher vertex, one face is on the left and one on the right.
    const bool runs_up = detail::start_of(sides[i], mesh.faces) == edges[edge].a;
    if (runs_up != (i == 0)) normals[i] = -normals[i];
  }
  return normals;
}

}  // namespace whittle::metrics
