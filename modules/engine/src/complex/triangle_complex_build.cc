#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>
#include <utility>

#include "complex/fan_sorter.hh"
#include "complex/triangle_complex.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/space_filling_curve.hh"

// How a complex comes to be. Its stars are listed twice in the same memory: first the two other corners of each face,
// in the input's order of faces, so that sums over them do not depend on the numbering in here; then the neighbours.

namespace whittle {
namespace {

constexpr Index few_edges = 8;  ///< so many are searched one by one

/// Calls `use(neighbour)` for those for which `is_chosen(neighbour)`. That is unpredictable, so short lists are sifted
/// first, branch-free.
template <class IsChosen, class Use>
void for_each_chosen(std::span<Neighbour> list, const IsChosen& is_chosen, const Use& use) {
  constexpr std::size_t few = 16;
  if (list.size() > few) {
    for (Neighbour& neighbour : list) {
      if (is_chosen(neighbour)) use(neighbour);
    }
    return;
  }
  std::array<Neighbour*, few> chosen;
  std::size_t n = 0;
  for (Neighbour& neighbour : list) {
    chosen[n] = &neighbour;
    n += static_cast<std::size_t>(is_chosen(neighbour));
  }
  for (std::size_t i = 0; i < n; ++i) use(*chosen[i]);
}

}  // namespace

TriangleComplex::TriangleComplex(std::span<const Vec3> positions, std::span<const Triangle> faces, const Frame& frame,
                                 unsigned threads) {
  const std::vector<Index> number_of = number_vertices(positions, frame, threads);
  list_faces(faces, number_of);
}

/// \return by number in the input, the number in here
std::vector<Index> TriangleComplex::number_vertices(std::span<const Vec3> positions, const Frame& frame,
                                                    unsigned threads) {
  const std::vector<Index> order = morton_order(positions, frame, threads);
  std::vector<Index> number_of(positions.size());
  vertices_.resize(positions.size());
  parents_.resize(positions.size());
  stars_.assign(positions.size(), {});
  for_each_range(order.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      number_of[order[v]] = v;
      vertices_[v] = {frame.to_frame(positions[order[v]]), order[v], 0};
      parents_[v] = v;
    }
  });
  return number_of;
}

void TriangleComplex::list_faces(std::span<const Triangle> faces, const std::vector<Index>& number_of) {
  const auto for_each_corner = [&](const auto& use) {
    for (const Triangle& face : faces) {
      const auto [a, b, c] = Triangle{number_of[face[0]], number_of[face[1]], number_of[face[2]]};
      if (a == b || b == c || c == a) continue;
      use(a, LinkEdge{b, c});
      use(b, LinkEdge{c, a});
      use(c, LinkEdge{a, b});
    }
  };
  std::size_t n_corners = 0;
  for_each_corner([&](Index v, const LinkEdge&) {
    ++stars_[v].list.capacity;
    ++n_corners;
  });
  n_faces_ = n_corners / 3;
  n_degenerate_faces_ = faces.size() - n_faces_;
  neighbour_lists_ = NeighbourLists(n_corners, vertices_.size());
  for (Star& star : stars_) {
    star.list = neighbour_lists_.allocate(star.list.capacity);
    n_vertices_ += star.list.capacity > 0 ? 1 : 0;
  }
  for_each_corner([&](Index v, const LinkEdge& face) { neighbour_lists_.push_back(stars_[v].list, as_listed(face)); });
}

void TriangleComplex::freeze(std::span<const std::uint8_t> frozen) {
  has_frozen_vertices_ = true;
  for (Index v = 0; v < vertices_.size(); ++v) stars_[v].is_frozen = frozen[origin(v)] != 0;
}

void TriangleComplex::connect(std::span<const VertexPair> threshold_pairs, unsigned threads) {
  for_each_range(vertices_.size(), threads,
                 [this](std::size_t begin, std::size_t end) { find_small_rings(begin, end); });
  link_ = Link(vertices_.size());
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (is_frozen(v)) {
      stars_[v].kind = VertexKind::junction;  // nobody asks
      make_pairs(v);
    } else if (!is_ring(v)) {
      connect_by_link(v);
    }
  }
  number_edges(threads);
  if (!threshold_pairs.empty()) add_threshold_pairs(threshold_pairs);
}

void TriangleComplex::find_small_rings(std::size_t begin, std::size_t end) {
  FanSorter sorter;
  std::array<Index, FanSorter::max_faces> ring;
  for (auto v = static_cast<Index>(begin); v < end; ++v) {
    const std::span<Neighbour> list = neighbour_lists_.of(stars_[v].list);
    const bool may_be_ring = list.size() >= 3 && list.size() <= ring.size() && !is_frozen(v);
    const bool is_small_ring = may_be_ring && sorter.sort(list, ring);
    stars_[v].is_ring = is_small_ring;
    if (!is_small_ring) continue;
    for (std::size_t i = 0; i < list.size(); ++i) list[i].vertex = ring[i];
  }
}

/// For a vertex that is no small ring.
void TriangleComplex::connect_by_link(Index v) {
  Star& star = stars_[v];
  const std::span<Neighbour> list = neighbour_lists_.of(star.list);
  std::vector<LinkEdge> faces;
  faces.reserve(list.size());
  for (const Neighbour& listed : list) faces.push_back(as_face(listed));
  link_.gather(faces);
  star.kind = link_.kind();
  star.is_ring = star.kind == VertexKind::regular && link_.is_oriented();
  if (star.is_ring) {
    Index slot = 0;
    for (Neighbour& neighbour : list) neighbour.vertex = link_.step(slot);
  } else {
    if (star.kind != VertexKind::regular) irregular_.push_back(v);
    make_pairs(v);
  }
}

/// Takes the list's room for one twice as long. Faces keep their order.
void TriangleComplex::make_pairs(Index v) {
  stars_[v].is_ring = false;
  NeighbourLists::List& list = stars_[v].list;
  const NeighbourLists::List faces = list;
  list = neighbour_lists_.allocate(2 * faces.size);
  list.size = 2 * faces.size;
  const std::span<Neighbour> pairs = neighbour_lists_.of(list);
  Index n = 0;
  for (const Neighbour& listed : neighbour_lists_.of(faces)) {
    const auto [x, y] = as_face(listed);
    pairs[n++] = {x, invalid_index};
    pairs[n++] = {y, invalid_index};
  }
  neighbour_lists_.release(faces);
}

/// Numbers the edges by their lower vertex, then tells the higher one.
void TriangleComplex::number_edges(unsigned threads) {
  pairs_.reserve(n_faces_ + n_faces_ / 2 + 16);
  std::vector<Index> starts(vertices_.size() + 1);
  std::size_t n = 0;
  for (Index v = 0; v < vertices_.size(); ++v) {
    const std::size_t first = n;
    const std::span<Neighbour> list = neighbour_lists_.of(stars_[v].list);
    if (pairs_.size() < n + list.size()) pairs_.resize(std::max(n + list.size(), pairs_.capacity()));
    for (Neighbour& neighbour : list) {
      pairs_[n] = {v, neighbour.vertex};
      neighbour.edge = static_cast<Index>(n);
      n += static_cast<std::size_t>(neighbour.vertex > v);
    }
    if (!is_ring(v) || n - first > few_edges) n = sort_edges(v, first, n);
    if (n >= invalid_index) throw std::length_error("decimate: more than 2^32 - 2 edges");
    starts[v + 1] = static_cast<Index>(n);
  }
  pairs_.resize(n);
  n_edges_ = n;
  pair_alive_.assign(pairs_.size(), true);

  for_each_range(vertices_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      for_each_chosen(
          neighbour_lists_.of(stars_[v].list), [v](const Neighbour& neighbour) { return neighbour.vertex < v; },
          [&](Neighbour& neighbour) {
            neighbour.edge = find_edge({neighbour.vertex, v}, starts[neighbour.vertex], starts[neighbour.vertex + 1]);
          });
    }
  });
}

/// Sorts edges first … end, all of v, by the other vertex, and leaves each there once. \return where they end then
std::size_t TriangleComplex::sort_edges(Index v, std::size_t first, std::size_t end) {
  const auto at = [this](std::size_t e) { return pairs_.begin() + static_cast<std::ptrdiff_t>(e); };
  std::sort(at(first), at(end), [](const Ends& x, const Ends& y) { return x.second < y.second; });
  const auto last = std::unique(at(first), at(end), [](const Ends& x, const Ends& y) { return x.second == y.second; });
  end = static_cast<std::size_t>(last - pairs_.begin());
  for (Neighbour& neighbour : neighbour_lists_.of(stars_[v].list)) {
    if (neighbour.vertex > v) {
      neighbour.edge = find_edge({v, neighbour.vertex}, static_cast<Index>(first), static_cast<Index>(end));
    }
  }
  return end;
}

/// \param begin, end those of the edges with the same lower vertex
Index TriangleComplex::find_edge(const Ends& edge, Index begin, Index end) const {
  if (end - begin > few_edges) {
    const auto first = pairs_.begin() + begin;
    const auto place = std::lower_bound(first, pairs_.begin() + end, edge.second,
                                        [](const Ends& e, Index sought) { return e.second < sought; });
    return static_cast<Index>(place - pairs_.begin());
  }
  // Where it is, is unpredictable; hence the first ones are searched branch-free. What comes after the end is not this
  // edge, or is overruled by the one before.
  constexpr Index n_first = 4;
  const auto key = std::bit_cast<std::uint64_t>(edge);
  const auto is_sought = [&](Index e) { return std::bit_cast<std::uint64_t>(pairs_[e]) == key; };
  Index found = invalid_index;
  if (begin + n_first <= pairs_.size()) {
    for (Index e = begin + n_first; e-- > begin;) found = select_branch_free(is_sought(e), e, found);
    begin += n_first;
  }
  for (Index e = begin; found == invalid_index; ++e) found = select_branch_free(is_sought(e), e, found);
  return found;
}

/// In the order of their lower vertices, as the edges are.
void TriangleComplex::add_threshold_pairs(std::span<const VertexPair> pairs) {
  if (n_edges_ + pairs.size() >= invalid_index) throw std::length_error("decimate: more than 2^32 - 2 pairs");
  std::vector<Index> number_of(vertices_.size());
  for (Index v = 0; v < vertices_.size(); ++v) number_of[origin(v)] = v;
  const auto numbered = [&](const VertexPair& pair) {
    const auto [first, second] = std::minmax(number_of[pair.a], number_of[pair.b]);
    return Ends{first, second};
  };
  std::vector<std::size_t> slots(vertices_.size() + 1);
  slots[0] = n_edges_;
  for (const VertexPair& pair : pairs) ++slots[numbered(pair).first + 1];
  for (std::size_t v = 1; v < slots.size(); ++v) slots[v] += slots[v - 1];
  pairs_.resize(n_edges_ + pairs.size());
  for (const VertexPair& pair : pairs) pairs_[slots[numbered(pair).first]++] = numbered(pair);
  pair_alive_.assign(pairs_.size(), true);
}

}  // namespace whittle
