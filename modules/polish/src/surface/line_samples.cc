#include "surface/line_samples.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace whittle::polishing {
namespace {

/// Positions of the two samples of an edge. They integrate the square of a linear function exactly (Gauss).
const std::array<double, 2> shares{0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};

constexpr double least_way_agreement = 0.5;  ///< cosine between the lines of a sample and of its closest point

/// Limit for a search; far fewer steps are enough from a start that is near.
constexpr std::size_t most_steps = 16;

bool has_lines(const MeshLines& lines, Index v, LineKind kind) {
  const std::span<const Index> edges = lines.at(v);
  return std::any_of(edges.begin(), edges.end(), [&](Index e) { return lines.edges()[e].kind == kind; });
}

/// The vertex if it has lines of this kind, else the nearest of its neighbours that has some.
Index nearest_start(Index v, const Vec3& point, LineKind kind, const MeshLines& lines, const Surface& mesh) {
  if (has_lines(lines, v, kind)) return v;
  Index nearest = invalid_index;
  double least = std::numeric_limits<double>::infinity();
  for (const Corner& corner : mesh.corners.of(v)) {
    for (const Index u : mesh.faces[corner.face]) {
      const double distance_sq = (mesh.positions[u] - point).squaredNorm();
      if (!(distance_sq < least) || !has_lines(lines, u, kind)) continue;
      least = distance_sq;
      nearest = u;
    }
  }
  return nearest;
}

struct EdgePoint {
  double share;  ///< where on the edge, 0 … 1
  Vec3 offset;   ///< from there to the sample
};

EdgePoint nearest_on_edge(const Vec3& point, const Vec3& from, const Vec3& way) {
  const Vec3 offset = point - from;
  const double share = std::clamp(offset.dot(way) / way.squaredNorm(), 0.0, 1.0);
  return {share, offset - share * way};
}

}  // namespace

LineSamples::LineSamples(const MeshLines& lines, std::span<const Vec3> positions, std::span<const Index> vertex_map) {
  for (const auto& [from, to, kind] : lines.edges()) {
    const Vec3 way = positions[to] - positions[from];
    const double length = way.norm();
    if (!(length > 0)) continue;
    const std::array<Index, 2> ends{from, to};
    for (std::size_t i = 0; i < 2; ++i) {
      const Index start = vertex_map[ends[i]];
      if (start == invalid_index) continue;
      samples_.push_back({positions[from], way, shares[i], start, kind, 0.5 * length});
      // No point of an edge is further from a straight line than its ends: so these show whether a tolerance is kept.
      if (kind == LineKind::feature) samples_.push_back({positions[from], way, static_cast<double>(i), start, kind, 0});
    }
  }
  closest_points_.resize(samples_.size());
}

void LineSamples::find_closest_points(const MeshLines& lines, const Surface& mesh, const detail::Workers& workers) {
  for_each_range(samples_.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) closest_points_[i] = find(samples_[i], lines, mesh);
  });
}

std::vector<double> LineSamples::distances(const MeshLines& lines, std::span<const Vec3> positions) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> of_points(positions.size());
  std::vector<double> of_vertex(positions.size(), infinity);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (closest_points_[i].edge == invalid_index) continue;
    const MeshLines::Edge& edge = lines.edges()[closest_points_[i].edge];
    for (const Index v : {edge.from, edge.to}) {
      of_points[v] = std::max(of_points[v], closest_points_[i].offset.norm());
      of_vertex[v] =
          std::min(of_vertex[v], nearest_on_edge(positions[v], samples_[i].from, samples_[i].way).offset.norm());
    }
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (of_vertex[v] < infinity) of_points[v] = std::max(of_points[v], of_vertex[v]);
  }
  return of_points;
}

/// Walks along the lines: from the edges at one vertex to the edges at the other end of the nearest edge so far.
ClosestLinePoint LineSamples::find(const LineSample& sample, const MeshLines& lines, const Surface& mesh) {
  ClosestLinePoint closest;
  double least = std::numeric_limits<double>::infinity();
  std::array<Index, most_steps> seen;
  std::size_t n_seen = 0;
  const auto is_seen = [&](Index v) {
    return std::find(seen.begin(), seen.begin() + n_seen, v) != seen.begin() + n_seen;
  };
  Index v = nearest_start(sample.start, sample.position(), sample.kind, lines, mesh);
  while (v != invalid_index && n_seen < most_steps) {
    seen[n_seen++] = v;
    for (const Index e : lines.at(v)) {
      const auto& [from, to, kind] = lines.edges()[e];
      const Vec3 way = mesh.positions[to] - mesh.positions[from];
      const double least_along = least_way_agreement * way.norm() * sample.way.norm();
      if (kind != sample.kind || !(std::abs(way.dot(sample.way)) > least_along)) continue;
      const auto [share, offset] = nearest_on_edge(sample.position(), mesh.positions[from], way);
      if (!(offset.squaredNorm() < least)) continue;
      least = offset.squaredNorm();
      closest = {e, share, offset};
    }
    if (closest.edge == invalid_index) break;
    const auto& [from, to, kind] = lines.edges()[closest.edge];
    v = !is_seen(from) ? from : !is_seen(to) ? to : invalid_index;
  }
  return closest;
}

}  // namespace whittle::polishing
