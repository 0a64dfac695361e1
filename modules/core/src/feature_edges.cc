#include "whittle/core/feature_edges.hh"

#include <stdexcept>

#include "whittle/core/detail/checks.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/detail/portable_math.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle {
std::vector<VertexPair> feature_edges(const IndexedMesh& mesh, double angle_deg) {
  if (!(angle_deg >= 0 && angle_deg <= 180)) throw std::invalid_argument("feature_edges: angle_deg is not in [0, 180]");
  check_corners(mesh.positions.size(), mesh.faces);
  const Frame frame = Frame::of_points(mesh.positions);  // in its coordinates no product over- or underflows
  const auto normal = [&](Index side) -> Vec3 {
    const auto [a, b, c] = mesh.faces[detail::face_of(side)];
    return reliable_normal(frame.to_frame(mesh.positions[a]), frame.to_frame(mesh.positions[b]),
                           frame.to_frame(mesh.positions[c]));
  };
  const double least_cosine = detail::cosine_of_deg(angle_deg);
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  const auto is_sharp = [&](std::size_t edge) {
    const std::span<const Index> sides = edges.sides(edge);
    if (sides.size() != 2) return false;
    const Vec3 n = normal(sides[0]);
    const Vec3 m = edges.is_regular(edge, mesh.faces) ? normal(sides[1]) : Vec3(-normal(sides[1]));
    return n.dot(m) < least_cosine * n.norm() * m.norm();
  };
  std::vector<VertexPair> features;
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    if (is_sharp(edge)) features.push_back(edges[edge]);
  }
  return features;
}

}  // namespace whittle
