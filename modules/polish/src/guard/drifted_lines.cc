#include "guard/drifted_lines.hh"

#include <algorithm>
#include <array>
#include <limits>

namespace whittle::polishing {
namespace {

std::vector<double> limits_of(const MeshLines& lines, const std::vector<double>& distances, double feature_tolerance) {
  constexpr double rounding = 1e-9;
  const auto kind_of = [&lines](Index e) { return static_cast<std::size_t>(lines.edges()[e].kind); };
  std::array<double, n_line_kinds> most{};
  for (Index v = 0; v < distances.size(); ++v) {
    for (const Index e : lines.at(v)) most[kind_of(e)] = std::max(most[kind_of(e)], distances[v]);
  }
  double& most_of_features = most[static_cast<std::size_t>(LineKind::feature)];
  most_of_features = std::min(most_of_features, feature_tolerance);
  std::vector<double> limits(distances.size(), std::numeric_limits<double>::infinity());
  for (Index v = 0; v < distances.size(); ++v) {
    for (const Index e : lines.at(v)) limits[v] = std::min(limits[v], most[kind_of(e)]);
    limits[v] = (1 + rounding) * std::max(limits[v], distances[v]);
  }
  return limits;
}

}  // namespace

DriftedLines::DriftedLines(const Surface& before, const MeshLines& lines, LineSamples& samples,
                           double feature_tolerance)
    : before_(before), lines_(lines), samples_(samples) {
  if (!lines.empty()) limits_ = limits_of(lines, samples.distances(lines, before.positions), feature_tolerance);
}

std::vector<Index> DriftedLines::take_back(std::vector<Vec3>& positions, const detail::Workers& workers) {
  std::vector<Index> taken_back;
  for (bool is_done = limits_.empty(); !is_done;) {
    is_done = true;
    samples_.find_closest_points(lines_, {before_.faces, before_.corners, positions}, workers);
    const std::vector<double> now = samples_.distances(lines_, positions);
    for (Index v = 0; v < now.size(); ++v) {
      if (!(now[v] > limits_[v])) continue;
      for (const Index u : moved_at(v, positions)) {
        positions[u] = before_.positions[u];
        taken_back.push_back(u);
        is_done = false;
      }
    }
  }
  return taken_back;
}

/// The vertices to put back where a vertex' lines drift: itself, or if it hasn't moved, its neighbours along features.
std::vector<Index> DriftedLines::moved_at(Index v, const std::vector<Vec3>& positions) const {
  const auto is_moved = [&](Index u) { return positions[u] != before_.positions[u]; };
  if (is_moved(v)) return {v};
  std::vector<Index> moved;
  for (const Index e : lines_.at(v)) {
    const auto& [from, to, kind] = lines_.edges()[e];
    const Index other = from == v ? to : from;
    if (kind == LineKind::feature && is_moved(other)) moved.push_back(other);
  }
  return moved;
}

}  // namespace whittle::polishing
