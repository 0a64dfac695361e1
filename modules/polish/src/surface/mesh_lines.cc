#include "surface/mesh_lines.hh"

#include <algorithm>
#include <cstdint>

namespace whittle {

std::vector<VertexPair> border_edges(std::span<const Triangle> faces, std::size_t n_vertices) {
  // Around a vertex that isn't on the border each neighbour comes up twice, and nothing is left. Spread over 64 bits,
  // as numbers themselves may cancel where two borders touch.
  std::vector<std::uint64_t> left(n_vertices);
  const auto spread = [](Index v) { return (v + std::uint64_t{1}) * 0x9e3779b97f4a7c15; };
  for (const auto& [a, b, c] : faces) {
    const std::uint64_t at_a = spread(a);
    const std::uint64_t at_b = spread(b);
    const std::uint64_t at_c = spread(c);
    left[a] ^= at_b ^ at_c;
    left[b] ^= at_c ^ at_a;
    left[c] ^= at_a ^ at_b;
  }
  std::vector<VertexPair> sides;
  for (const Triangle& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [low, high] = std::minmax(face[i], face[(i + 1) % 3]);
      if (left[low] != 0 && left[high] != 0) sides.push_back({low, high});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<VertexPair> borders;
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(), [first](const VertexPair& side) { return side != *first; });
    if (last - first == 1) borders.push_back(*first);
    first = last;
  }
  return borders;
}

MeshLines::MeshLines(std::span<const VertexPair> borders, std::span<const VertexPair> features,
                     std::size_t n_vertices) {
  for (const auto& [from, to] : borders) edges_.push_back({from, to, true});
  for (const auto& [from, to] : features) edges_.push_back({from, to, false});
  edges_at_ = {n_vertices, [this](const auto& add) {
                 for (Index e = 0; e < edges_.size(); ++e) {
                   add(edges_[e].from, e);
                   add(edges_[e].to, e);
                 }
               }};
}

}  // namespace whittle
