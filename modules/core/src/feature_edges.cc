#include "whittle/core/feature_edges.hh"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "whittle/core/detail/checks.hh"
#include "whittle/core/frame.hh"

namespace whittle {
namespace {

/// An edge as one of its faces has it.
struct FaceEdge {
  VertexPair ends;  ///< lower first
  Index face;
  bool is_turned;  ///< whether the face has the higher one first

  bool operator<(const FaceEdge& other) const { return std::tie(ends, face) < std::tie(other.ends, other.face); }
};

std::vector<FaceEdge> sorted_face_edges(const IndexedMesh& mesh) {
  std::vector<FaceEdge> edges;
  edges.reserve(3 * mesh.faces.size());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Triangle& face = mesh.faces[f];
    if (!has_three_corners(face)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = face[i];
      const Index to = face[(i + 1) % 3];
      edges.push_back({{std::min(from, to), std::max(from, to)}, f, from > to});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

std::vector<VertexPair> feature_edges(const IndexedMesh& mesh, double angle_deg) {
  if (!(angle_deg >= 0 && angle_deg <= 180)) throw std::invalid_argument("feature_edges: angle_deg is not in [0, 180]");
  check_corners(mesh.positions.size(), mesh.faces);
  const Frame frame = Frame::of_points(mesh.positions);  // whose numbers neither over- nor underflow
  const auto normal = [&](const FaceEdge& edge) -> Vec3 {
    const auto [a, b, c] = mesh.faces[edge.face];
    const Vec3 p = frame.to_frame(mesh.positions[a]);
    return (frame.to_frame(mesh.positions[b]) - p).cross(frame.to_frame(mesh.positions[c]) - p);
  };
  const double least_cosine = std::cos(angle_deg * std::numbers::pi / 180);
  const auto is_sharp = [&](const FaceEdge& first, const FaceEdge& second) {
    const Vec3 n = normal(first);
    const Vec3 m = first.is_turned == second.is_turned ? Vec3(-normal(second)) : normal(second);
    return n.dot(m) < least_cosine * n.norm() * m.norm();
  };
  const std::vector<FaceEdge> edges = sorted_face_edges(mesh);
  std::vector<VertexPair> features;
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last =
        std::find_if(first, edges.end(), [first](const FaceEdge& edge) { return edge.ends != first->ends; });
    if (last - first == 2 && is_sharp(first[0], first[1])) features.push_back(first->ends);
    first = last;
  }
  return features;
}

}  // namespace whittle
