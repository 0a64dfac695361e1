#include "whittle/core/detail/edge_table.hh"

#include <algorithm>
#include <stdexcept>

#include "whittle/core/detail/index_lists.hh"

namespace whittle::detail {
namespace {

/// A side in the list of its lower vertex: the higher vertex, then the side's number. Sorted keys group sides by edge.
using SideKey = std::uint64_t;

SideKey side_key(Index higher, Index side) { return SideKey{higher} << 32 | side; }
Index higher_of(SideKey key) { return static_cast<Index>(key >> 32); }
Index side_of(SideKey key) { return static_cast<Index>(key); }

void check_size(std::span<const Triangle> faces) {
  if (faces.size() >= invalid_index / 3) throw std::length_error("more than 2^32 / 3 faces");
}

/// Calls `use(from, to, number)` for each side of the faces.
template <class Use>
void for_each_side(std::span<const Triangle> faces, const Use& use) {
  Index first = 0;
  for (const Triangle& face : faces) {
    if (has_three_corners(face)) {
      for (Index i = 0; i < 3; ++i) use(face[i], face[(i + 1) % 3], first + i);
    }
    first += 3;
  }
}

/// Per vertex, a sum of its neighbours that is zero where each neighbour comes up an even number of times: at every
/// vertex that is not on a border. Numbers are spread over 64 bits, since small ones may cancel where borders touch.
std::vector<std::uint64_t> neighbor_sums(std::span<const Triangle> faces, std::size_t n_vertices) {
  std::vector<std::uint64_t> sums(n_vertices);
  const auto spread = [](Index v) { return (v + std::uint64_t{1}) * 0x9e3779b97f4a7c15; };
  for (const Triangle& face : faces) {
    if (!has_three_corners(face)) continue;
    const auto& [a, b, c] = face;
    const std::uint64_t at_a = spread(a);
    const std::uint64_t at_b = spread(b);
    const std::uint64_t at_c = spread(c);
    sums[a] ^= at_b ^ at_c;
    sums[b] ^= at_c ^ at_a;
    sums[c] ^= at_a ^ at_b;
  }
  return sums;
}

std::vector<std::uint8_t> face_counts_up_to_two(std::span<const Triangle> faces, std::size_t n_vertices) {
  std::vector<std::uint8_t> counts(n_vertices);
  for_each_side(faces, [&counts](Index from, Index /*to*/, Index /*number*/) {
    if (counts[from] < 2) ++counts[from];
  });
  return counts;
}

}  // namespace

EdgeTable::EdgeTable(std::span<const Triangle> faces, std::size_t n_vertices, std::span<const std::uint8_t> is_chosen) {
  check_size(faces);
  if (is_chosen.empty()) {
    build(n_vertices, [faces](const auto& use) { for_each_side(faces, use); });
    return;
  }
  build(n_vertices, [faces, is_chosen](const auto& use) {
    for_each_side(faces, [&](Index from, Index to, Index side) {
      if (is_chosen[face_of(side)] != 0) use(from, to, side);
    });
  });
}

template <class ForEachSide>
void EdgeTable::build(std::size_t n_vertices, const ForEachSide& for_each_own_side) {
  IndexLists<SideKey> keys(n_vertices, [&](const auto& add) {
    for_each_own_side(
        [&add](Index from, Index to, Index number) { add(std::min(from, to), side_key(std::max(from, to), number)); });
  });
  sides_.resize(keys.n_values());
  edges_.clear();
  edges_.reserve(keys.n_values() / 2 + 1);
  Index n_sides = 0;
  for (Index v = 0; v < n_vertices; ++v) {
    const std::span<SideKey> list = keys.of(v);
    std::sort(list.begin(), list.end());
    Index previous = invalid_index;
    for (const SideKey key : list) {
      const Index higher = higher_of(key);
      if (higher != previous) edges_.push_back({{v, higher}, n_sides});
      previous = higher;
      sides_[n_sides++] = side_of(key);
    }
  }
  edges_.push_back({{invalid_index, invalid_index}, n_sides});
}

template <class IsCandidate>
std::vector<VertexPair> EdgeTable::border_edges_among(std::span<const Triangle> faces, std::size_t n_vertices,
                                                      const IsCandidate& is_candidate) {
  struct Side {
    Index from, to, number;
  };
  std::vector<Side> candidates;
  for_each_side(faces, [&](Index from, Index to, Index number) {
    if (is_candidate(from, to)) candidates.push_back({from, to, number});
  });
  std::vector<VertexPair> borders;
  if (candidates.empty()) return borders;
  EdgeTable edges;
  edges.build(n_vertices, [&candidates](const auto& use) {
    for (const auto& [from, to, number] : candidates) use(from, to, number);
  });
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.sides(e).size() == 1) borders.push_back(edges[e]);
  }
  return borders;
}

std::vector<VertexPair> border_edges(std::span<const Triangle> faces, std::size_t n_vertices) {
  check_size(faces);
  const std::vector<std::uint64_t> sums = neighbor_sums(faces, n_vertices);
  return EdgeTable::border_edges_among(faces, n_vertices,
                                       [&sums](Index from, Index to) { return sums[from] != 0 && sums[to] != 0; });
}

std::vector<std::uint8_t> border_vertices(std::span<const Triangle> faces, std::size_t n_vertices) {
  check_size(faces);
  const std::vector<std::uint64_t> sums = neighbor_sums(faces, n_vertices);
  const std::vector<std::uint8_t> n_faces = face_counts_up_to_two(faces, n_vertices);
  std::vector<std::uint8_t> is_at_border(n_vertices);
  const auto mark = [&](Index a, Index b) { is_at_border[a] = is_at_border[b] = 1; };
  // An edge has two faces only if both its ends have. A soup has no such edge.
  for_each_side(faces, [&](Index from, Index to, Index /*number*/) {
    if (n_faces[from] == 1 || n_faces[to] == 1) mark(from, to);
  });
  const auto is_undecided = [&](Index from, Index to) {
    return sums[from] != 0 && sums[to] != 0 && !(is_at_border[from] != 0 && is_at_border[to] != 0);
  };
  for (const auto& [a, b] : EdgeTable::border_edges_among(faces, n_vertices, is_undecided)) mark(a, b);
  return is_at_border;
}

}  // namespace whittle::detail
