#include "whittle/core/two_sided.hh"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <tuple>
#include <utility>

#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle {
namespace {

Triangle in_ascending_order(Triangle corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Whether the corners are in ascending order, but for where they begin.
bool is_ascending(const Triangle& face) { return (face[0] < face[1]) + (face[1] < face[2]) + (face[2] < face[0]) == 2; }

/// One bit of 64, the same for all faces on the same vertices.
std::uint64_t mark_of(const Triangle& face) {
  const std::uint64_t all = std::uint64_t{face[0]} + face[1] + face[2];
  return std::uint64_t{1} << (all * 0x9e3779b97f4a7c15U >> 58);  // Fibonacci hashing (Knuth, TAOCP 3, 6.4)
}

/// Two faces on the same vertices, with opposite orientation.
struct FacePair {
  Index front, back;
};

/// Pairs of faces, by their fronts, ascending.
std::vector<FacePair> find_pairs(const IndexedMesh& mesh, unsigned threads) {
  const std::vector<Triangle>& faces = mesh.faces;
  std::vector<std::pair<Triangle, Index>> some;
  for (const Index f : faces_that_may_coincide(faces, mesh.positions.size(), threads))
    some.emplace_back(in_ascending_order(faces[f]), f);
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

/// Each vertex has the marks of faces whose lowest corner it is.
std::vector<Index> faces_that_may_coincide(std::span<const Triangle> faces, std::size_t n_vertices, unsigned threads) {
  LargeArray<std::uint64_t> marks(n_vertices, 0);
  std::vector<std::uint8_t> has_equal_marks(n_vertices);
  const bool is_alone = n_threads(threads) == 1;
  const auto add_mark = [&](std::uint64_t& all, std::uint64_t mark) {
    return is_alone ? std::exchange(all, all | mark) : std::atomic_ref(all).fetch_or(mark, std::memory_order_relaxed);
  };
  const auto lowest_of = [](const Triangle& face) { return std::min({face[0], face[1], face[2]}); };
  for_each_range(faces.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (const Triangle& face : faces.subspan(begin, end - begin)) {
      const Index lowest = lowest_of(face);
      if (lowest >= n_vertices || !has_three_corners(face)) continue;
      const std::uint64_t mark = mark_of(face);
      if ((add_mark(marks[lowest], mark) & mark) != 0) {
        std::atomic_ref(has_equal_marks[lowest]).store(1, std::memory_order_relaxed);
      }
    }
  });
  std::vector<std::vector<Index>> found((faces.size() + range_length - 1) / range_length);
  for_each_range(faces.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<Index>(begin); f < end; ++f) {
      const Index lowest = lowest_of(faces[f]);
      if (lowest >= n_vertices || has_equal_marks[lowest] == 0 || !has_three_corners(faces[f])) continue;
      found[begin / range_length].push_back(f);
    }
  });
  std::vector<Index> all;
  for (const std::vector<Index>& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

std::vector<Index> fronts_of_backs(const IndexedMesh& mesh, unsigned threads) {
  std::vector<Index> fronts;
  const std::vector<FacePair> pairs = find_pairs(mesh, threads);
  if (pairs.size() < 2) return fronts;
  PairSets sets(mesh.faces, pairs);
  for (Index i = 0; i < pairs.size(); ++i) {
    if (!sets.is_in_sheet(i)) continue;
    fronts.resize(mesh.faces.size(), invalid_index);
    fronts[pairs[i].back] = pairs[i].front;
  }
  return fronts;
}

std::vector<Index> faces_without_backs(const IndexedMesh& mesh, unsigned threads) {
  const std::vector<Index> fronts = fronts_of_backs(mesh, threads);
  std::vector<Index> numbers;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (fronts.empty() || fronts[f] == invalid_index) numbers.push_back(f);
  }
  return numbers;
}

}  // namespace whittle
