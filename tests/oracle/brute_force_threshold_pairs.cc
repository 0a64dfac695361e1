#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "oracle/brute_force.hh"
#include "support/face_list.hh"

namespace whittle::test {

void BruteForceDecimater::find_threshold_pairs(const PairOptions& options) {
  const double threshold = options.threshold.value() * frame_.scale;
  const double threshold_sq = std::max(threshold * threshold, std::numeric_limits<double>::denorm_min());
  std::vector<std::vector<std::pair<double, Index>>> nearby(positions_.size());
  const std::map<Edge, int> edges = count_edge_faces(faces_);
  const auto is_used = [&](Index v) {
    return std::ranges::any_of(faces_, [v](const Triangle& f) { return has(f, v); });
  };
  const auto normal = [&](Index v) {
    Vec3 sum = Vec3::Zero();
    for (const Triangle& f : faces_) {
      if (has(f, v)) sum += (positions_[f[1]] - positions_[f[0]]).cross(positions_[f[2]] - positions_[f[0]]);
    }
    return sum;
  };
  const auto is_across_wall = [&](Index a, Index b) {
    const Vec3 way = positions_[b] - positions_[a];
    return normal(a).dot(way) < 0 && normal(b).dot(way) > 0 && normal(a).dot(normal(b)) < 0;
  };
  for (Index a = 0; a < positions_.size(); ++a) {
    if (!is_used(a)) continue;
    for (Index b = 0; b < positions_.size(); ++b) {
      if (b == a || !is_used(b) || edges.contains(edge(a, b))) continue;
      const double distance_sq = (positions_[b] - positions_[a]).squaredNorm();
      if (!(distance_sq < threshold_sq)) continue;
      if (!options.across_walls && is_across_wall(a, b)) continue;
      nearby[a].emplace_back(distance_sq, b);
    }
    std::ranges::sort(nearby[a]);
    if (options.max_pairs && nearby[a].size() > *options.max_pairs) nearby[a].resize(*options.max_pairs);
    for (const auto& [distance_sq, b] : nearby[a]) threshold_pairs_.insert(edge(a, b));
  }
}

}  // namespace whittle::test
