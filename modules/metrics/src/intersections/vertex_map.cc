#include "intersections/vertex_map.hh"

#include <algorithm>
#include <stdexcept>

namespace whittle::metrics {

void check_vertex_map(std::span<const Index> vertex_map, const IndexedMesh& before, const IndexedMesh& after) {
  if (vertex_map.size() != before.positions.size()) {
    throw std::invalid_argument("the vertex map has another length than the vertices");
  }
  const auto is_valid = [&](Index v) { return v == invalid_index || v < after.positions.size(); };
  if (!std::all_of(vertex_map.begin(), vertex_map.end(), is_valid)) {
    throw std::invalid_argument("the vertex map has a vertex number out of range");
  }
}

}  // namespace whittle::metrics
