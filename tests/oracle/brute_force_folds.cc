#include "oracle/brute_force_folds.hh"

#include <Eigen/Geometry>
#include <map>
#include <utility>
#include <vector>

namespace whittle::test {

std::set<Edge> brute_force_folds(std::span<const Vec3> positions, std::span<const Triangle> faces,
                                 const DecimateOptions& options) {
  if (!options.hold_folds.value_or(false) || options.quadric.boundary_weight == 0) return {};
  std::map<Edge, std::vector<std::pair<bool, Vec3>>> sides;
  for (const Triangle& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = edge(f[k], f[(k + 1) % 3]);
      const auto line = Eigen::ParametrizedLine<double, 3>::Through(positions[a], positions[b]);
      const Vec3& third = positions[f[(k + 2) % 3]];
      sides[{a, b}].push_back({f[k] == a, (third - line.projection(third)).stableNormalized()});
    }
  }
  std::set<Edge> folds;
  for (const auto& [ends, of_faces] : sides) {
    if (of_faces.size() != 2 || of_faces[0].first == of_faces[1].first) continue;
    if (of_faces[0].second.dot(of_faces[1].second) > 1 - 1e-6) folds.insert(ends);
  }
  return folds;
}

}  // namespace whittle::test
