#include "whittle/engine/parts.hh"

#include <algorithm>
#include <numeric>

namespace whittle {
Parts find_parts(std::size_t n_vertices, std::span<const Triangle> faces) {
  std::vector<Index> leader(n_vertices);  // towards the lowest vertex of the part
  std::iota(leader.begin(), leader.end(), Index{0});
  const auto find = [&leader](Index v) {
    while (leader[v] != v) v = leader[v] = leader[leader[v]];
    return v;
  };
  std::vector<bool> has_face(n_vertices);
  for (const Triangle& face : faces) {
    if (!has_three_corners(face)) continue;
    const Index first = find(face[0]);
    const Index second = find(face[1]);
    const Index third = find(face[2]);
    const Index lowest = std::min({first, second, third});
    for (const Index v : {first, second, third}) leader[v] = lowest;
    for (const Index v : face) has_face[v] = true;
  }
  Parts parts;
  parts.part_of.assign(n_vertices, invalid_index);
  for (Index v = 0; v < n_vertices; ++v) {
    if (!has_face[v]) continue;
    const Index lowest = find(v);
    if (lowest == v) parts.part_of[v] = static_cast<Index>(parts.count++);
    parts.part_of[v] = parts.part_of[lowest];
  }
  return parts;
}

}  // namespace whittle
