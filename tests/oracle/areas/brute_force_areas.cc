#include "oracle/areas/brute_force_areas.hh"

#include <algorithm>
#include <set>
#include <utility>

#include "whittle/core/wedges.hh"

namespace whittle::test {

BruteForceAreas::BruteForceAreas(const IndexedMesh& mesh, const DecimateOptions& options) {
  const std::vector<VertexPair> seams = seam_edges(mesh, face_regions(mesh, options.regions));
  const std::size_t n = mesh.faces.size();
  const auto has = [&](Index f, Index v) { return std::ranges::find(mesh.faces[f], v) != mesh.faces[f].end(); };
  std::vector<Index> area(n, invalid_index);
  for (Index first = 0; first < n; ++first) {
    if (area[first] != invalid_index) continue;
    bool has_seam = false;
    std::vector<Index> found{first};
    area[first] = first;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Triangle& face = mesh.faces[found[i]];
      for (std::size_t k = 0; k < 3 && has_three_corners(face); ++k) {
        const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
        const bool is_seam = std::ranges::find(seams, VertexPair{low, high}) != seams.end();
        has_seam = has_seam || is_seam;
        for (Index g = 0; g < n && !is_seam; ++g) {
          if (area[g] != invalid_index || !has(g, low) || !has(g, high) || !has_three_corners(mesh.faces[g])) continue;
          area[g] = first;
          found.push_back(g);
        }
      }
    }
    for (const Index f : has_seam ? found : std::vector<Index>{}) {
      faces_.push_back(mesh.faces[f]);
      areas_.push_back(first);
    }
  }
}

bool BruteForceAreas::keep_faces_without(Index a, Index b) const {
  std::set<Index> before;
  std::set<Index> after;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Triangle& face = faces_[i];
    if (!has_three_corners(face)) continue;
    before.insert(areas_[i]);
    const bool vanishes = std::ranges::find(face, a) != face.end() && std::ranges::find(face, b) != face.end();
    if (!vanishes) after.insert(areas_[i]);
  }
  return before == after;
}

void BruteForceAreas::contract(Index survivor, Index removed) {
  for (Triangle& face : faces_) std::ranges::replace(face, removed, survivor);
}

bool BruteForceAreas::give_up() {
  areas_.clear();
  return !std::exchange(faces_, {}).empty();
}

}  // namespace whittle::test
