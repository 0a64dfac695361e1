#include "whittle/metrics/lines.hh"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "edge_normals.hh"
#include "whittle/core/geometry/bounds.hh"
#include "working_scale.hh"

namespace whittle::metrics {

namespace {

Segment segment_of(const IndexedMesh& mesh, const VertexPair& edge) {
  return {mesh.positions[edge.a], mesh.positions[edge.b]};
}

}  // namespace

std::vector<Segment> border_lines(const IndexedMesh& mesh) {
  bounds_of(mesh);  // for its checks
  std::vector<Segment> lines;
  for (const VertexPair& edge : detail::border_edges(mesh.faces, mesh.positions.size())) {
    lines.push_back(segment_of(mesh, edge));
  }
  return lines;
}

std::vector<Segment> feature_lines(const IndexedMesh& mesh, double angle_deg) {
  if (!(angle_deg > 0.0 && angle_deg < 180.0)) {
    throw std::invalid_argument("feature angle is to be in (0, 180) degrees, not " + std::to_string(angle_deg));
  }
  const double scale = working_scale({bounds_of(mesh)});
  const IndexedMesh& seen = scale == 1.0 ? mesh : scaled(mesh, scale);
  const double angle = angle_deg * (std::numbers::pi / 180.0);
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  std::vector<Segment> lines;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto normals = normals_at(seen, edges, e);
    if (!normals) continue;
    const auto& [a, b] = *normals;
    if (std::atan2(a.cross(b).norm(), a.dot(b)) > angle) lines.push_back(segment_of(mesh, edges[e]));
  }
  return lines;
}

}  // namespace whittle::metrics
