#include "whittle/core/two_sided.hh"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <tuple>
#include <utility>

#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle {
namespace {

Triangle in_ascending_order(Triangle corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Whether the corners are in ascending order, but for where they begin.
bool is_ascending(const Triangle& face) { return (face[0] < face[1]) + (face[1] < face[2]) + (face[2] < face[0]) == 2; }

/// The same for all faces on the same vertices, seldom for others. \param n_bits of it. [1, 32]
std::uint32_t hash_of(const Triangle& face, int n_bits) {
  const auto [a, b, c] = std::array<std::uint64_t, 3>{face[0], face[1], face[2]};
  const std::uint64_t sums = (a + b + c) * 0x9e3779b97f4a7c15U + (a * a + b * b + c * c) * 0xbf58476d1ce4e5b9U;
  return static_cast<std::uint32_t>(((sums ^ (sums >> 29)) * 0x94d049bb133111ebU) >> (64 - n_bits));
}

/// Faces with a hash that another face has, too: all that share their vertices with one, and few others.
std::vector<Index> faces_that_may_coincide(std::span<const Triangle> faces) {
  constexpr std::size_t slots_per_face = 16;
  const int n_bits = std::clamp(static_cast<int>(std::bit_width(slots_per_face * faces.size())), 6, 32);
  struct Slots {  // 64 of them: the hashes of one face and more, and of two and more
    std::uint64_t once = 0;
    std::uint64_t twice = 0;
  };
  std::vector<Slots> slots((std::size_t{1} << n_bits) / 64);
  std::vector<std::uint32_t> hashes(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::uint32_t hash = hash_of(faces[f], n_bits);
    hashes[f] = hash;
    auto& [once, twice] = slots[hash / 64];
    const std::uint64_t bit = std::uint64_t{1} << (hash % 64);
    twice |= once & bit;
    once |= bit;
  }
  std::vector<Index> found;
  for (Index f = 0; f < faces.size(); ++f) {
    const std::uint32_t hash = hashes[f];
    if (((slots[hash / 64].twice >> (hash % 64)) & 1U) != 0 && has_three_corners(faces[f])) found.push_back(f);
  }
  return found;
}

/// Two faces on the same vertices, with opposite orientation.
struct FacePair {
  Index front, back;
};

/// Pairs of faces, by their fronts, ascending.
std::vector<FacePair> find_pairs(std::span<const Triangle> faces) {
  std::vector<std::pair<Triangle, Index>> some;
  for (const Index f : faces_that_may_coincide(faces)) some.emplace_back(in_ascending_order(faces[f]), f);
  std::sort(some.begin(), some.end());
  std::vector<FacePair> pairs;
  for (auto begin = some.begin(), end = begin; begin != some.end(); begin = end) {
    end = std::find_if(begin, some.end(), [&](const auto& other) { return other.first != begin->first; });
    if (end - begin != 2) continue;
    const FacePair pair{begin[0].second, begin[1].second};
    if (is_ascending(faces[pair.front]) != is_ascending(faces[pair.back])) pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end(), [](const FacePair& a, const FacePair& b) { return a.front < b.front; });
  return pairs;
}

/// An edge of a face, and the pair that the face belongs to, if any.
struct EdgeOfPair {
  VertexPair edge;
  Index pair;
  bool operator<(const EdgeOfPair& other) const { return std::tie(edge, pair) < std::tie(other.edge, other.pair); }
};

/// The edges of all faces but backs, where a pair has such an edge, in order.
std::vector<EdgeOfPair> edges_at_pairs(std::span<const Triangle> faces, std::span<const FacePair> pairs) {
  std::vector<Index> pair_of(faces.size(), invalid_index);
  std::vector<std::uint8_t> is_back(faces.size());
  for (Index i = 0; i < pairs.size(); ++i) {
    pair_of[pairs[i].front] = i;
    is_back[pairs[i].back] = 1;
  }
  std::vector<EdgeOfPair> edges;
  for (Index f = 0; f < faces.size(); ++f) {
    if (is_back[f] != 0 || !has_three_corners(faces[f])) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(faces[f][k], faces[f][(k + 1) % 3]);
      edges.push_back({{low, high}, pair_of[f]});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Pairs that are connected over edges.
class PairSets {
 public:
  PairSets(std::span<const Triangle> faces, std::span<const FacePair> pairs)
      : sets_(pairs.size()), traits_(pairs.size()) {
    const std::vector<EdgeOfPair> edges = edges_at_pairs(faces, pairs);
    for_each_edge(edges, [&](std::span<const Index> at_edge, std::size_t) {
      for (const Index pair : at_edge) sets_.join(at_edge.front(), pair);
    });
    for (Index i = 0; i < pairs.size(); ++i) ++traits_[sets_.find(i)].n_pairs;
    for_each_edge(edges, [&](std::span<const Index> at_edge, std::size_t n_others) {
      Traits& traits = traits_[sets_.find(at_edge.front())];
      if (n_others >= 2) traits.ends_at_bodies = true;
      if (n_others == 1 || at_edge.size() + n_others == 1) traits.ends_elsewhere = true;
    });
  }

  bool is_in_sheet(Index pair) {
    const Traits& traits = traits_[sets_.find(pair)];
    return traits.n_pairs >= 2 && (traits.ends_elsewhere || !traits.ends_at_bodies);
  }

 private:
  struct Traits {
    std::size_t n_pairs = 0;
    bool ends_at_bodies = false;  ///< at an edge of two other faces or more
    bool ends_elsewhere = false;  ///< at an edge of one other face or none
  };

  /// Calls visit(pairs at an edge, number of other faces there) for each edge of a pair.
  template <class Visit>
  static void for_each_edge(const std::vector<EdgeOfPair>& edges, const Visit& visit) {
    std::vector<Index> at_edge;
    for (auto begin = edges.begin(), end = begin; begin != edges.end(); begin = end) {
      end = std::find_if(begin, edges.end(), [&](const EdgeOfPair& other) { return other.edge != begin->edge; });
      at_edge.clear();
      for (auto edge = begin; edge != end && edge->pair != invalid_index; ++edge) at_edge.push_back(edge->pair);
      if (!at_edge.empty())
        visit(std::span<const Index>(at_edge), static_cast<std::size_t>(end - begin) - at_edge.size());
    }
  }

  detail::DisjointSets<Index> sets_;
  std::vector<Traits> traits_;  ///< of each set, by the pair that names it
};

}  // namespace

std::vector<Index> fronts_of_backs(std::span<const Triangle> faces) {
  std::vector<Index> fronts;
  const std::vector<FacePair> pairs = find_pairs(faces);
  if (pairs.size() < 2) return fronts;
  PairSets sets(faces, pairs);
  for (Index i = 0; i < pairs.size(); ++i) {
    if (!sets.is_in_sheet(i)) continue;
    fronts.resize(faces.size(), invalid_index);
    fronts[pairs[i].back] = pairs[i].front;
  }
  return fronts;
}

std::vector<Index> faces_without_backs(std::span<const Triangle> faces) {
  const std::vector<Index> fronts = fronts_of_backs(faces);
  std::vector<Index> numbers;
  for (Index f = 0; f < faces.size(); ++f) {
    if (fronts.empty() || fronts[f] == invalid_index) numbers.push_back(f);
  }
  return numbers;
}

}  // namespace whittle
