#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>
#include <utility>

#include "complex/triangle_complex.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/detail/select.hh"
#include "whittle/core/geometry/space_filling_curve.hh"

// How a complex comes to be. Its stars are listed twice in the same place: first the two other corners of each face, in
// the input's order of faces, so that sums over them do not depend on the numbering in here; then the neighbours.

namespace whittle {
namespace {

/// A face as one of its corners v sees it: (v, next, previous) is counter-clockwise.
struct Corner {
  Index next, previous;
};
Spoke as_spoke(const Corner& corner) { return {corner.next, corner.previous}; }
Corner as_corner(const Spoke& spoke) { return {spoke.vertex, spoke.edge}; }

constexpr Index few_edges = 8;  ///< so many are searched one by one

/// Calls `use(spoke)` for those for which `is_chosen(spoke)`. As that can't be foretold, short lists are sifted first,
/// without a branch.
template <class IsChosen, class Use>
void for_each_chosen(std::span<Spoke> list, const IsChosen& is_chosen, const Use& use) {
  constexpr std::size_t few = 16;
  if (list.size() > few) {
    for (Spoke& spoke : list) {
      if (is_chosen(spoke)) use(spoke);
    }
    return;
  }
  std::array<Spoke*, few> chosen;
  std::size_t n = 0;
  for (Spoke& spoke : list) {
    chosen[n] = &spoke;
    n += static_cast<std::size_t>(is_chosen(spoke));
  }
  for (std::size_t i = 0; i < n; ++i) use(*chosen[i]);
}

/// Puts the corners of a closed fan in its order, without a branch that can't be foretold: each names the one after it,
/// which is looked up by the low bits of its number.
class FanSorter {
 public:
  static constexpr std::size_t max_corners = 12;

  /// Writes the neighbours in the fan's order to `ring`. False if the corners, up to `max_corners`, are not one closed
  /// fan, each neighbour once, all of one orientation; or if the low bits of two neighbours are the same.
  bool sort(std::span<const Spoke> corners, std::span<Index> ring) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) place(as_corner(corners[i]).next) = static_cast<std::uint8_t>(i);
    bool is_ring = true;
    for (std::size_t i = 0; i < n; ++i) is_ring &= place(as_corner(corners[i]).next) == i;
    std::size_t at = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Corner here = as_corner(corners[at]);
      ring[i] = here.next;
      at = std::min<std::size_t>(place(here.previous), n - 1);
      is_ring &= as_corner(corners[at]).next == here.previous;
      is_ring &= (at == 0) == (i + 1 == n);
    }
    return is_ring;
  }

 private:
  std::uint8_t& place(Index v) { return places_[v % places_.size()]; }

  std::array<std::uint8_t, 256> places_{};  ///< right only if the corner there is the one sought
};

}  // namespace

TriangleComplex::TriangleComplex(std::span<const Vec3> positions, std::span<const Triangle> faces,
                                 std::span<const VertexPair> threshold_pairs, const Frame& frame,
                                 const QuadricOptions& quadric, unsigned threads) {
  std::vector<Index> number_of;
  number_vertices(positions, frame, number_of, threads);
  list_faces(faces, number_of);
  if (threshold_pairs.empty()) number_of = {};
  points_.resize(threshold_pairs.empty() ? 0 : positions.size());
  point_weight_ = quadric.point_weight;
  set_up_stars(quadric, threads);
  number_edges(threads);
  if (!threshold_pairs.empty()) add_threshold_pairs(threshold_pairs, number_of);
}

void TriangleComplex::number_vertices(std::span<const Vec3> positions, const Frame& frame,
                                      std::vector<Index>& number_of, unsigned threads) {
  const std::vector<Index> order = morton_order(positions, frame, threads);
  number_of.resize(positions.size());
  vertices_.resize(positions.size());
  parents_.resize(positions.size());
  quadrics_.resize(positions.size());
  stars_.assign(positions.size(), {});
  for_each_range(order.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      number_of[order[v]] = v;
      vertices_[v] = {frame.to_frame(positions[order[v]]), order[v]};
      parents_[v] = v;
    }
  });
}

/// Lists each vertex's faces, as corners.
void TriangleComplex::list_faces(std::span<const Triangle> faces, const std::vector<Index>& number_of) {
  const auto for_each_corner = [&](const auto& use) {
    for (const Triangle& face : faces) {
      const auto [a, b, c] = Triangle{number_of[face[0]], number_of[face[1]], number_of[face[2]]};
      if (a == b || b == c || c == a) continue;
      use(a, Corner{b, c});
      use(b, Corner{c, a});
      use(c, Corner{a, b});
    }
  };
  std::size_t n_corners = 0;
  for_each_corner([&](Index v, const Corner&) {
    ++stars_[v].spokes.capacity;
    ++n_corners;
  });
  n_faces_ = n_corners / 3;
  n_degenerate_faces_ = faces.size() - n_faces_;
  spoke_lists_ = SpokeLists(n_corners, vertices_.size());
  for (Star& star : stars_) {
    star.spokes = spoke_lists_.allocate(star.spokes.capacity);
    n_vertices_ += star.spokes.capacity > 0 ? 1 : 0;
  }
  for_each_corner([&](Index v, const Corner& corner) { spoke_lists_.push_back(stars_[v].spokes, as_spoke(corner)); });
}

/// The quadrics of a vertex a lane, each summed over its faces in their order.
template <class Real>
[[gnu::always_inline]] inline void TriangleComplex::sum_planes_in_lanes(Index first, const QuadricOptions& options) {
  std::array<std::span<const Spoke>, n_lanes<Real>> lists;
  std::size_t n_corners = 0;
  for (Index i = 0; i < lists.size(); ++i) {
    lists[i] = neighbours(first + i);
    n_corners = std::max(n_corners, lists[i].size());
  }
  const auto vertex = [&](std::size_t i) { return first + static_cast<Index>(i); };
  const auto center = point_lanes<Real>([&](std::size_t i) -> const Vec3& { return position(vertex(i)); });
  SymmetricLanes<Real> sum;
  for (std::size_t k = 0; k < n_corners; ++k) {
    const auto corner = [&](std::size_t i) {  // where there are no more, one without area
      return k < lists[i].size() ? as_corner(lists[i][k]) : Corner{vertex(i), vertex(i)};
    };
    sum += corner_quadrics(
        center, point_lanes<Real>([&](std::size_t i) -> const Vec3& { return position(corner(i).next); }),
        point_lanes<Real>([&](std::size_t i) -> const Vec3& { return position(corner(i).previous); }), options);
  }
  for (std::size_t i = 0; i < lists.size(); ++i) {
    quadrics_[vertex(i)] = {
        {lane(sum.xx, i), lane(sum.xy, i), lane(sum.xz, i), lane(sum.yy, i), lane(sum.yz, i), lane(sum.zz, i)},
        0,
        invalid_index,
        0};
  }
}

template <class Real>
[[gnu::always_inline]] inline void TriangleComplex::sum_planes_in_lanes(std::size_t begin, std::size_t end,
                                                                        const QuadricOptions& options) {
  auto v = static_cast<Index>(begin);
  for (; v + n_lanes<Real> <= end; v += n_lanes<Real>) sum_planes_in_lanes<Real>(v, options);
  for (; v < end; ++v) sum_planes_in_lanes<double>(v, options);
}

WHITTLE_DOUBLE4 void TriangleComplex::sum_planes_of_four(std::size_t begin, std::size_t end,
                                                         const QuadricOptions& options) {
  sum_planes_in_lanes<Double4>(begin, end, options);
}

void TriangleComplex::sum_planes(std::size_t begin, std::size_t end, const QuadricOptions& options) {
  if (has_double4) {
    sum_planes_of_four(begin, end, options);
  } else {
    sum_planes_in_lanes<Double2>(begin, end, options);
  }
}

/// Sums each vertex's quadric over its faces and turns its list of corners into one of neighbours.
void TriangleComplex::set_up_stars(const QuadricOptions& options, unsigned threads) {
  for_each_range(vertices_.size(), threads, [&](std::size_t begin, std::size_t end) {
    sum_planes(begin, end, options);
    if (!points_.empty()) set_points(begin, end, options);
    FanSorter sorter;
    std::array<Index, FanSorter::max_corners> ring;
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<Index>(i);
      const std::span<Spoke> list = spoke_lists_.of(stars_[v].spokes);
      const bool is_small_ring = list.size() >= 3 && list.size() <= ring.size() && sorter.sort(list, ring);
      stars_[v].is_ring = is_small_ring;
      if (!is_small_ring) continue;  // the others are looked at more closely below
      for (std::size_t k = 0; k < list.size(); ++k) list[k].vertex = ring[k];
    }
  });
  link_place_.resize(vertices_.size());
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (is_ring(v)) continue;
    const std::span<Spoke> list = spoke_lists_.of(stars_[v].spokes);
    faces_.clear();
    for (const Spoke& spoke : list) faces_.push_back({as_corner(spoke).next, as_corner(spoke).previous});
    gather_link(faces_);
    stars_[v].order = order_of_link();
    stars_[v].is_ring = stars_[v].order == VertexOrder::regular && is_link_oriented();
    if (is_ring(v)) {
      Index place = 0;
      for (Spoke& spoke : list) spoke.vertex = step_along_link(place);
    } else {
      if (stars_[v].order != VertexOrder::regular) irregular_.push_back(v);
      quadrics_[v].a = with_border_planes(quadrics_[v].a, v, options);
      make_pairs(v);
    }
  }
}

/// \pre the vertices' quadrics are those of their faces alone.
void TriangleComplex::set_points(std::size_t begin, std::size_t end, const QuadricOptions& options) {
  const double share = 1 / (1 + 3 * options.regularization);  // of a plane's weight in the trace of its quadric
  for (auto v = static_cast<Index>(begin); v < end; ++v) {
    points_[v] = {position(v), share * quadrics_[v].a.trace(), 0};
  }
}

/// \pre v's link is gathered.
SymmetricMatrix TriangleComplex::with_border_planes(SymmetricMatrix sum, Index v, const QuadricOptions& options) {
  if (options.boundary_weight == 0) return sum;
  const auto is_border = [this](Index w) { return link_[place_in_link(w)].n_faces[0] == 1; };
  for (const Spoke& spoke : neighbours(v)) {
    const auto [next, previous] = as_corner(spoke);
    if (is_border(next)) sum += border_quadric(position(v), position(next), position(previous), options);
    if (is_border(previous)) sum += border_quadric(position(previous), position(v), position(next), options);
  }
  return sum;
}

/// Takes the list's room for one twice as long.
void TriangleComplex::make_pairs(Index v) {
  SpokeLists::List& list = stars_[v].spokes;
  std::vector<Spoke> pairs;
  for (const Spoke& spoke : neighbours(v)) {
    const auto [next, previous] = as_corner(spoke);
    pairs.push_back({next, invalid_index});
    pairs.push_back({previous, invalid_index});
  }
  spoke_lists_.release(list);
  list = spoke_lists_.allocate(static_cast<Index>(pairs.size()));
  list.size = static_cast<Index>(pairs.size());
  std::copy(pairs.begin(), pairs.end(), spoke_lists_.of(list).begin());
}

/// Numbers the edges by their lower vertex, then tells the higher one.
void TriangleComplex::number_edges(unsigned threads) {
  pairs_.reserve(n_faces_ + n_faces_ / 2 + 16);
  std::vector<Index> starts(vertices_.size() + 1);
  std::size_t n = 0;
  for (Index v = 0; v < vertices_.size(); ++v) {
    const std::size_t first = n;
    const std::span<Spoke> list = spoke_lists_.of(stars_[v].spokes);
    if (pairs_.size() < n + list.size()) pairs_.resize(std::max(n + list.size(), pairs_.capacity()));
    for (Spoke& spoke : list) {
      pairs_[n] = {v, spoke.vertex};
      spoke.edge = static_cast<Index>(n);
      n += static_cast<std::size_t>(spoke.vertex > v);
    }
    if (!is_ring(v) || n - first > few_edges) n = sort_edges(v, first, n);
    if (n >= invalid_index) throw std::length_error("decimate: more than 2^32 - 2 edges");
    starts[v + 1] = static_cast<Index>(n);
  }
  pairs_.resize(n);
  n_edges_ = n;
  pair_alive_.assign(pairs_.size() / 64 + 1, ~std::uint64_t{0});

  for_each_range(vertices_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      for_each_chosen(
          spoke_lists_.of(stars_[v].spokes), [v](const Spoke& spoke) { return spoke.vertex < v; },
          [&](Spoke& spoke) {
            spoke.edge = find_edge({spoke.vertex, v}, starts[spoke.vertex], starts[spoke.vertex + 1]);
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
  for (Spoke& spoke : spoke_lists_.of(stars_[v].spokes)) {
    if (spoke.vertex > v) {
      spoke.edge = find_edge({v, spoke.vertex}, static_cast<Index>(first), static_cast<Index>(end));
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
  // The first ones without a branch: where it is can't be foretold. What comes after the end is not this edge, or
  // overruled by the one before.
  constexpr Index n_first = 4;
  const auto key = std::bit_cast<std::uint64_t>(edge);
  const auto is_sought = [&](Index e) { return std::bit_cast<std::uint64_t>(pairs_[e]) == key; };
  Index found = invalid_index;
  if (begin + n_first <= pairs_.size()) {
    for (Index e = begin + n_first; e-- > begin;) found = select(is_sought(e), e, found);
    begin += n_first;
  }
  for (Index e = begin; found == invalid_index; ++e) found = select(is_sought(e), e, found);
  return found;
}

/// In the order of their lower vertices, as the edges are.
void TriangleComplex::add_threshold_pairs(std::span<const VertexPair> pairs, const std::vector<Index>& number_of) {
  if (n_edges_ + pairs.size() >= invalid_index) throw std::length_error("decimate: more than 2^32 - 2 pairs");
  const auto numbered = [&](const VertexPair& pair) {
    const auto [first, second] = std::minmax(number_of[pair.a], number_of[pair.b]);
    return Ends{first, second};
  };
  std::vector<std::size_t> places(vertices_.size() + 1);
  places[0] = n_edges_;
  for (const VertexPair& pair : pairs) ++places[numbered(pair).first + 1];
  for (std::size_t v = 1; v < places.size(); ++v) places[v] += places[v - 1];
  pairs_.resize(n_edges_ + pairs.size());
  for (const VertexPair& pair : pairs) pairs_[places[numbered(pair).first]++] = numbered(pair);
  pair_alive_.assign(pairs_.size() / 64 + 1, ~std::uint64_t{0});
}

}  // namespace whittle
