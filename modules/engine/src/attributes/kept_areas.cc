#include "attributes/kept_areas.hh"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "whittle/core/geometry/triangle.hh"

namespace whittle {
namespace {

/// Of the target, for each area that is kept.
constexpr std::uint64_t faces_per_area = 8;

}  // namespace

KeptAreas::KeptAreas(const IndexedMesh& mesh, const std::vector<Index>& areas) : ranks_(areas) {
  std::vector<double> sizes(areas.size());  // by area; those are named by a face
  for (std::size_t f = 0; f < areas.size(); ++f) {
    if (areas[f] != invalid_index) sizes[areas[f]] += area_of(mesh.positions, mesh.faces[f]);
  }
  std::vector<Index> order(areas.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return sizes[a] > sizes[b]; });
  std::vector<Index> rank(areas.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<Index>(i);
  for (Index& area : ranks_) {
    if (area != invalid_index) area = rank[area];
  }
}

std::vector<Index> KeptAreas::of(const DecimateTarget& target) const {
  if (!target.n_faces() && !target.n_vertices()) return ranks_;
  const std::uint64_t n_faces = std::max(target.n_faces().value_or(0), 2 * target.n_vertices().value_or(0));
  std::vector<Index> kept = ranks_;
  for (Index& area : kept) {
    if (area >= n_faces / faces_per_area) area = invalid_index;
  }
  return kept;
}

}  // namespace whittle
