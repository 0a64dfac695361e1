#include "whittle/core/detail/edge_table.hh"

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/detail/item_groups.hh"

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

/// Calls `use(from, to, number)` for each side of some faces.
template <class Use>
void for_each_side(std::span<const Triangle> faces, std::size_t begin, std::size_t end, const Use& use) {
  for (auto f = static_cast<Index>(begin); f < end; ++f) {
    const Triangle& face = faces[f];
    if (!has_three_corners(face)) continue;
    for (Index i = 0; i < 3; ++i) use(face[i], face[(i + 1) % 3], 3 * f + i);
  }
}

/// A test for border vertices by the faces around a vertex.
///
/// The upper bits are a sum of its neighbours that is zero if each neighbour occurs an even number of times, as at
/// every vertex that is not on a border. Numbers are spread over many bits, since small ones may cancel where borders
/// touch. The lowest two bits count its faces, up to two.
class VertexStar {
 public:
  /// \param neighbors sum of the spread numbers of the face's other corners
  void add_face(std::uint64_t neighbors) {
    bits_ = ((bits_ ^ neighbors) & ~count_bits) | std::min<std::uint64_t>((bits_ & count_bits) + 1, 2);
  }
  bool may_be_at_border() const { return (bits_ & ~count_bits) != 0; }
  bool has_one_face() const { return (bits_ & count_bits) == 1; }

  static std::uint64_t spread(Index v) { return (v + std::uint64_t{1}) * 0x9e3779b97f4a7c15; }

 private:
  static constexpr std::uint64_t count_bits = 3;
  std::uint64_t bits_ = 0;
};

LargeArray<VertexStar> look_around(std::span<const Triangle> faces, std::size_t n_vertices, unsigned threads) {
  LargeArray<VertexStar> stars(n_vertices);
  for_each_vertex_range(faces, n_vertices, threads, [&](Index begin, Index end, const auto& for_each_face) {
    for_each_face([&](Index f) {
      if (!has_three_corners(faces[f])) return;
      const auto& [a, b, c] = faces[f];
      const std::uint64_t at_a = VertexStar::spread(a);
      const std::uint64_t at_b = VertexStar::spread(b);
      const std::uint64_t at_c = VertexStar::spread(c);
      if (a >= begin && a < end) stars[a].add_face(at_b ^ at_c);
      if (b >= begin && b < end) stars[b].add_face(at_c ^ at_a);
      if (c >= begin && c < end) stars[c].add_face(at_a ^ at_b);
    });
  });
  return stars;
}

}  // namespace

EdgeTable::EdgeTable(std::span<const Triangle> faces, std::size_t n_vertices, std::span<const std::uint8_t> is_chosen) {
  check_size(faces);
  if (is_chosen.empty()) {
    build(n_vertices, [faces](const auto& use) { for_each_side(faces, 0, faces.size(), use); });
    return;
  }
  std::vector<Index> chosen;
  for (Index f = 0; f < faces.size(); ++f) {
    if (is_chosen[f] != 0) chosen.push_back(f);
  }
  build(n_vertices, [faces, &chosen](const auto& use) {
    for (const Index f : chosen) for_each_side(faces, f, f + 1, use);
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
                                                      unsigned threads, const IsCandidate& is_candidate) {
  struct Side {
    Index from, to, number;
  };
  std::vector<std::vector<Side>> candidates((faces.size() + range_length - 1) / range_length);
  for_each_range(faces.size(), threads, [&](std::size_t begin, std::size_t end) {
    for_each_side(faces, begin, end, [&](Index from, Index to, Index number) {
      if (is_candidate(from, to)) candidates[begin / range_length].push_back({from, to, number});
    });
  });
  std::vector<VertexPair> borders;
  if (std::all_of(candidates.begin(), candidates.end(), [](const auto& part) { return part.empty(); })) return borders;
  EdgeTable edges;
  edges.build(n_vertices, [&candidates](const auto& use) {
    for (const std::vector<Side>& part : candidates) {
      for (const auto& [from, to, number] : part) use(from, to, number);
    }
  });
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.sides(e).size() == 1) borders.push_back(edges[e]);
  }
  return borders;
}

std::vector<VertexPair> border_edges(std::span<const Triangle> faces, std::size_t n_vertices, unsigned threads) {
  check_size(faces);
  const LargeArray<VertexStar> stars = look_around(faces, n_vertices, threads);
  return EdgeTable::border_edges_among(faces, n_vertices, threads, [&stars](Index from, Index to) {
    return stars[from].may_be_at_border() && stars[to].may_be_at_border();
  });
}

std::vector<std::uint8_t> border_vertices(std::span<const Triangle> faces, std::size_t n_vertices, unsigned threads) {
  check_size(faces);
  const LargeArray<VertexStar> stars = look_around(faces, n_vertices, threads);
  std::vector<std::uint8_t> is_at_border(n_vertices);
  const auto mark = [&](Index v) { std::atomic_ref(is_at_border[v]).store(1, std::memory_order_relaxed); };
  // An edge has two faces only if both its ends have. A soup has no such edge.
  for_each_range(faces.size(), threads, [&](std::size_t begin, std::size_t end) {
    for_each_side(faces, begin, end, [&](Index from, Index to, Index /*number*/) {
      if (!stars[from].has_one_face() && !stars[to].has_one_face()) return;
      mark(from);
      mark(to);
    });
  });
  const auto is_undecided = [&](Index from, Index to) {
    return stars[from].may_be_at_border() && stars[to].may_be_at_border() &&
           !(is_at_border[from] != 0 && is_at_border[to] != 0);
  };
  for (const auto& [a, b] : EdgeTable::border_edges_among(faces, n_vertices, threads, is_undecided)) {
    is_at_border[a] = is_at_border[b] = 1;
  }
  return is_at_border;
}

}  // namespace whittle::detail
