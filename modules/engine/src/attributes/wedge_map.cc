#include "attributes/wedge_map.hh"

#include <algorithm>
#include <utility>

#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/wedges.hh"
#include "whittle/engine/attributes.hh"

namespace whittle {
namespace {

using Sets = detail::DisjointSets<Index>;

/// Joins the wedges that a contracted edge of some face connects.
Sets joined_wedges(const IndexedMesh& input, std::span<const Index> vertex_map) {
  Sets sets(n_wedges(input));
  for (std::size_t f = 0; f < input.faces.size(); ++f) {
    const Triangle& face = input.faces[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Index v = vertex_map[face[k]];
      if (v != invalid_index && v == vertex_map[face[next]]) sets.join(input.wedge(f, k), input.wedge(f, next));
    }
  }
  return sets;
}

WedgeMap one_a_vertex(std::span<const Index> vertex_map) {
  WedgeMap map;
  map.of_input.assign(vertex_map.begin(), vertex_map.end());
  return map;
}

}  // namespace

WedgeMap map_wedges(const IndexedMesh& input, std::span<const Index> vertex_map, std::span<const Index> face_origins) {
  if (input.wedges.empty()) return one_a_vertex(vertex_map);
  Sets sets = joined_wedges(input, vertex_map);
  std::vector<std::pair<Index, Index>> used;  // vertex of the result, least wedge of the input
  for (const Index f : face_origins) {
    for (std::size_t k = 0; k < 3; ++k) {
      used.emplace_back(vertex_map[input.faces[f][k]], sets.find(input.wedge(f, k)));
    }
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<Index> numbers(n_wedges(input), invalid_index);
  WedgeMap map;
  for (const auto& [vertex, wedge] : used) {
    numbers[wedge] = static_cast<Index>(map.vertex_of.size());
    map.vertex_of.push_back(vertex);
  }
  map.of_input.resize(numbers.size());
  for (Index w = 0; w < numbers.size(); ++w) map.of_input[w] = numbers[sets.find(w)];
  for (const Index f : face_origins) {
    for (std::size_t k = 0; k < 3; ++k) map.of_corners.push_back(map.of_input[input.wedge(f, k)]);
  }
  return map;
}

std::vector<Index> wedge_map(const IndexedMesh& input, std::span<const Index> vertex_map,
                             std::span<const Index> face_origins) {
  return map_wedges(input, vertex_map, face_origins).of_input;
}

}  // namespace whittle
