#include "brute_force_pairs.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "whittle/core/parts.hh"

namespace whittle::test {

BruteForcePairs::BruteForcePairs(const IndexedMesh& mesh, double threshold, bool across_walls)
    : mesh_(mesh), normals_(mesh.positions.size(), Vec3::Zero()), partners_(mesh.positions.size()) {
  std::set<Index> used;
  std::set<VertexPair> neighbours;
  for (const Triangle& face : mesh.faces) {
    if (!has_three_corners(face)) continue;
    const Vec3& p = mesh.positions[face[0]];
    const Vec3 normal = (mesh.positions[face[1]] - p).cross(mesh.positions[face[2]] - p);
    for (const Index v : face) {
      used.insert(v);
      normals_[v] += normal;
      for (const Index w : face) neighbours.insert({v, w});  // includes v itself
    }
  }
  for (const Index v : used) {
    for (const Index w : used) {
      if (!is_near(v, w, threshold) || neighbours.count({v, w}) > 0) continue;
      if (across_walls || !is_across_wall(v, w)) partners_[v].push_back({distance_sq(v, w), w});
    }
    std::sort(partners_[v].begin(), partners_[v].end());
  }
}

ThresholdPairs BruteForcePairs::pairs(std::size_t max_pairs) const {
  std::set<VertexPair> pairs;
  bool capped = false;
  for (Index v = 0; v < partners_.size(); ++v) {
    const std::size_t n = partners_[v].size();
    capped = capped || (max_pairs > 0 && n > max_pairs);
    for (std::size_t i = 0; i < (max_pairs > 0 ? std::min(n, max_pairs) : n); ++i) {
      const Index w = partners_[v][i].second;
      pairs.insert({std::min(v, w), std::max(v, w)});
    }
  }
  return {{pairs.begin(), pairs.end()}, capped};
}

bool BruteForcePairs::is_near(Index v, Index w, double threshold) const {
  if (mesh_.positions[v] == mesh_.positions[w]) return 0 < threshold;  // a tiny threshold's square may underflow to 0
  return distance_sq(v, w) < threshold * threshold;
}

bool BruteForcePairs::is_across_wall(Index v, Index w) const {
  const Vec3 way = mesh_.positions[w] - mesh_.positions[v];
  return normals_[v].dot(way) < 0 && normals_[w].dot(way) > 0 && normals_[v].dot(normals_[w]) < 0;
}

std::vector<double> gaps_by_brute_force(const IndexedMesh& mesh) {
  const Parts parts = find_parts(mesh.positions.size(), mesh.faces);
  std::vector<double> gaps_sq(parts.count, std::numeric_limits<double>::infinity());
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    for (Index w = 0; w < mesh.positions.size(); ++w) {
      const Index part = parts.part_of[v];
      const Index other = parts.part_of[w];
      if (part == invalid_index || other == invalid_index || part == other) continue;
      gaps_sq[part] = std::min(gaps_sq[part], (mesh.positions[v] - mesh.positions[w]).squaredNorm());
    }
  }
  for (double& gap : gaps_sq) gap = std::sqrt(gap);
  return gaps_sq;
}

}  // namespace whittle::test
