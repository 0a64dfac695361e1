#include "cost/lindstrom_turk/lindstrom_turk_cost.hh"

#include <algorithm>
#include <numeric>
#include <utility>

#include "complex/face_walk.hh"
#include "whittle/core/detail/lanes.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/detail/select.hh"
#include "whittle/engine/formula/volume_placement.hh"

namespace whittle {
namespace {

/// The coordinates, and the last one again.
[[gnu::always_inline]] inline Double4 side_by_side(const Vec3& p) { return Double4{p.x(), p.y(), p.z(), p.z()}; }

/// From the second coordinate on.
[[gnu::always_inline]] inline Double4 turned(const Double4& v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }

}  // namespace

void LindstromTurkCost::start(unsigned threads) {
  stars_.resize(complex_.n_vertex_slots());
  for_each_range(stars_.size(), threads, [this](std::size_t begin, std::size_t end) {
    std::vector<Index> vertices(end - begin);
    std::iota(vertices.begin(), vertices.end(), static_cast<Index>(begin));
    sum_around(vertices);
  });
}

/// Counter-clockwise from the lowest original number on.
[[gnu::always_inline]] inline void LindstromTurkCost::sum_around_ring(Index v) {
  const std::span<const Neighbour> ring = complex_.neighbours(v);
  const Double4 p = side_by_side(complex_.position(v));
  const std::size_t first = lowest_place(complex_, ring);
  Double4 normal{};
  Double4 squares{};
  Double4 products{};  // xz, xy, yz
  Double4 link{};
  Double4 to_x = side_by_side(complex_.position(ring[first].vertex)) - p;
  std::size_t place = first;
  do {
    place = place + 1 < ring.size() ? place + 1 : 0;
    const Double4 to_y = side_by_side(complex_.position(ring[place].vertex)) - p;
    const Double4 n_from_z = to_x * turned(to_y) - turned(to_x) * to_y;
    const Double4 n = turned(n_from_z);
    normal += n;
    squares += n * n;
    products += n * n_from_z;
    link += to_y;
    to_x = to_y;
  } while (place != first);
  stars_[v] = {{squares[0], products[1], products[0], squares[1], products[2], squares[2], normal[0], normal[1],
                normal[2], p[0], p[1], p[2], link[0], link[1], link[2], static_cast<double>(ring.size())}};
}

[[gnu::always_inline]] inline void LindstromTurkCost::sum_around_each(std::span<const Index> vertices) {
  for (const Index v : vertices) {
    if (complex_.is_ring(v) && complex_.has_faces(v)) {
      sum_around_ring(v);
    } else {
      sum_around_irregular(v);
    }
  }
}

WHITTLE_DOUBLE4 void LindstromTurkCost::sum_around_with_double4(std::span<const Index> vertices) {
  sum_around_each(vertices);
}

void LindstromTurkCost::sum_around(std::span<const Index> vertices) {
  if (has_double4) {
    sum_around_with_double4(vertices);
  } else {
    sum_around_each(vertices);
  }
}

void LindstromTurkCost::sum_around_irregular(Index v) {
  VolumeSums star;
  NeighbourSums link;
  const Vec3& p = complex_.position(v);
  for_each_face(complex_, v, [&](Index x, Index y) {
    const Vec3 n = (complex_.position(x) - p).cross(complex_.position(y) - p);
    star.normal += n;
    star.squares.a += SymmetricMatrix::outer(n, 1);
  });
  for (const Index w : ordered_neighbours(complex_, v)) link.add(complex_.position(w) - p);
  const auto& [xx, xy, xz, yy, yz, zz] = star.squares.a;
  const auto& n = star.normal;
  const auto& [sum, n_neighbours] = link;
  stars_[v] = {{xx, xy, xz, yy, yz, zz, n.x(), n.y(), n.z(), p.x(), p.y(), p.z(), sum.x(), sum.y(), sum.z(),
                static_cast<double>(n_neighbours)}};
}

/// The two corners opposite to an edge inside the surface, by their original numbers.
struct LindstromTurkCost::Sides {
  std::size_t place;  ///< of the pair among those to be evaluated
  Index a, b;
  std::array<Index, 2> corners;
  double turn;  ///< 1 where the first one is ahead of b around a, -1 where it is behind
};

bool LindstromTurkCost::find_sides(const Pair& pair, Sides& sides) const {
  const std::span<const Neighbour> ring = complex_.neighbours(pair.a);
  std::size_t place = 0;
  while (place < ring.size() && ring[place].vertex != pair.b) ++place;
  if (place == ring.size() || ring.size() == 2) return false;
  const Index behind = ring[place == 0 ? ring.size() - 1 : place - 1].vertex;
  const Index ahead = ring[place + 1 == ring.size() ? 0 : place + 1].vertex;
  sides.a = pair.a;
  sides.b = pair.b;
  const bool behind_is_first = complex_.origin(behind) < complex_.origin(ahead);
  sides.corners = {select(behind_is_first, behind, ahead), select(behind_is_first, ahead, behind)};
  sides.turn = behind_is_first ? -1 : 1;
  return true;
}

/// Pairs of a group as seen from their first vertices.
template <class Real>
struct LindstromTurkCost::GroupShape {
  PointLanes<Real> d;  ///< the second vertex
  std::array<PointLanes<Real>, 2> corners;
};

/// As the one for a single pair does it, to the bit.
template <class Real>
[[gnu::always_inline]] inline NeighbourLanes<Real> LindstromTurkCost::neighbours_of(
    const std::array<Sides, n_lanes<Real>>& group, const GroupShape<Real>& shape) const {
  const auto [x_a, y_a, z_a, n_a] =
      transposed_lanes<Real>([&](std::size_t lane) { return &stars_[group[lane].a].values[12]; });
  const auto [x_b, y_b, z_b, n_b] =
      transposed_lanes<Real>([&](std::size_t lane) { return &stars_[group[lane].b].values[12]; });
  const auto& [d, corners] = shape;
  const PointLanes<Real> of_b{x_b + n_b * d.x, y_b + n_b * d.y, z_b + n_b * d.z};
  const PointLanes<Real> of_a{x_a, y_a, z_a};
  return {of_a + of_b - d - corners[0] - corners[1], n_a + n_b - 4};
}

/// As `volume_of` and `LindstromTurk` do it, to the bit.
template <class Real>
[[gnu::always_inline]] inline void LindstromTurkCost::rank_group(const std::array<Sides, n_lanes<Real>>& group,
                                                                 std::span<const Pair> pairs,
                                                                 std::span<PairEvaluation> ranks) const {
  const auto load = [&](const auto& vertex, std::size_t first) __attribute__((always_inline)) {
    return transposed_lanes<Real>([&](std::size_t lane) { return &stars_[vertex(group[lane])].values[first]; });
  };
  const auto a = [](const Sides& sides) { return sides.a; };
  const auto b = [](const Sides& sides) { return sides.b; };
  const auto [xx_a, xy_a, xz_a, yy_a] = load(a, 0);
  const auto [yz_a, zz_a, nx_a, ny_a] = load(a, 4);
  const auto [nz_a, x_a, y_a, z_a] = load(a, 8);
  const auto [xx_b, xy_b, xz_b, yy_b] = load(b, 0);
  const auto [yz_b, zz_b, nx_b, ny_b] = load(b, 4);
  const auto [nz_b, x_b, y_b, z_b] = load(b, 8);
  const PointLanes<Real> origin{x_a, y_a, z_a};
  const PointLanes<Real> d = PointLanes<Real>{x_b, y_b, z_b} - origin;
  Real turn;
  fill_lanes(turn, [&](std::size_t lane) { return group[lane].turn; });

  const VolumeLanes<Real> of_b{{nx_b, ny_b, nz_b}, Real{}, xx_b, xy_b, xz_b, yy_b, yz_b, zz_b, {}, Real{}};
  const PointLanes<Real> slope = of_b.times(d);
  VolumeLanes<Real> sums{{nx_a + nx_b, ny_a + ny_b, nz_a + nz_b},
                         of_b.normal.dot(d),
                         xx_a + xx_b,
                         xy_a + xy_b,
                         xz_a + xz_b,
                         yy_a + yy_b,
                         yz_a + yz_b,
                         zz_a + zz_b,
                         {-slope.x, -slope.y, -slope.z},
                         d.dot(slope)};
  GroupShape<Real> shape{d, {}};
  for (std::size_t side = 0; side < 2; ++side) {
    const auto corner = load([side](const Sides& sides) { return sides.corners[side]; }, 8);
    shape.corners[side] = PointLanes<Real>{corner.second, corner.third, corner.fourth} - origin;
    const auto cross = d.cross(shape.corners[side]);
    const Real sign = side == 0 ? turn : -turn;
    const PointLanes<Real> n{sign * cross.x, sign * cross.y, sign * cross.z};
    sums.remove(n);
  }
  VolumeConstraints<Real> constraints = volume_constraints(sums);
  if (any(constraints.has_third == 0)) add_neighbours(constraints, neighbours_of(group, shape));
  const VolumePlacement<Real> placement = place_by_volume(constraints, sums, PointLanes<Real>{}, d);
  const PointLanes<Real> middle{0.5 * d.x, 0.5 * d.y, 0.5 * d.z};
  const PointLanes<Real> offset = placement.position - middle;
  const auto is_near = offset.dot(offset) <= (max_placement_reach * max_placement_reach) * d.dot(d);
  const auto is_placed = constraints.has_normal & is_near;
  for (std::size_t lane = 0; lane < n_lanes<Real>; ++lane) {
    const std::size_t i = group[lane].place;
    if (is_placed[lane] == 0) {
      ranks[i] = rank_one(pairs[i]);
      continue;
    }
    const Vec3 position(placement.position.x[lane] + origin.x[lane], placement.position.y[lane] + origin.y[lane],
                        placement.position.z[lane] + origin.z[lane]);
    ranks[i] = {placement.cost[lane], placement.cost[lane], position, false};
  }
}

template <class Real>
[[gnu::always_inline]] inline void LindstromTurkCost::rank_in_lanes(std::span<const Pair> pairs,
                                                                    std::span<PairEvaluation> ranks) const {
  std::array<Sides, n_lanes<Real>> group;
  std::size_t n = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [id, a, b] = pairs[i];
    const bool is_inside = complex_.is_ring(a) && complex_.is_ring(b) && restraints_.pinned(pairs[i]) == Pinned::none;
    if (is_inside && find_sides(pairs[i], group[n])) {
      group[n].place = i;
      if (++n == group.size()) {
        rank_group<Real>(group, pairs, ranks);
        n = 0;
      }
    } else {
      ranks[i] = rank_one(pairs[i]);
    }
  }
  if (n == 0) return;
  std::fill(group.begin() + static_cast<std::ptrdiff_t>(n), group.end(), group[n - 1]);
  rank_group<Real>(group, pairs, ranks);
}

WHITTLE_DOUBLE4 void LindstromTurkCost::rank_four_at_once(std::span<const Pair> pairs,
                                                          std::span<PairEvaluation> ranks) const {
  rank_in_lanes<Double4>(pairs, ranks);
}

/// Pairs inside the surface several at once.
void LindstromTurkCost::rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const {
  if (has_double4) {
    rank_four_at_once(pairs, ranks);
  } else {
    rank_in_lanes<Double2>(pairs, ranks);
  }
}

/// About its first vertex.
PairEvaluation LindstromTurkCost::rank_one(const Pair& pair) const {
  const Vec3& origin = complex_.position(pair.a);
  LindstromTurk term(volume_of(pair), border_of(pair), Vec3::Zero(), complex_.position(pair.b) - origin);
  if (!term.is_determined()) term.add_neighbours(neighbours_of(pair));
  const PairEvaluation evaluation = term.evaluate(restraints_.pinned(pair).value_or(Pinned::first));
  return in_frame(evaluation, origin, complex_.position(pair.b));
}

/// Of the planes of the second vertex's faces, those of faces with the first one pass through the origin, too.
VolumeSums LindstromTurkCost::volume_of(const Pair& pair) const {
  const Vec3& origin = complex_.position(pair.a);
  const Vec3 d = complex_.position(pair.b) - origin;
  VolumeSums sums{stars_[pair.a].normal(), 0, {stars_[pair.a].squares()}};
  sums += VolumeSums{stars_[pair.b].normal(), 0, {stars_[pair.b].squares()}}.about(-d);
  for_each_common_face(complex_, pair.a, pair.b,
                       [&](Index c, int turn) { sums.remove(turn * d.cross(complex_.position(c) - origin)); });
  return sums;
}

/// The border edges at either vertex, by the original number of the other end, those of the first vertex first.
BorderSums LindstromTurkCost::border_of(const Pair& pair) const {
  BorderSums sums;
  const auto add_at = [&](Index v, Index but) {
    if (complex_.is_ring(v)) return;
    const std::vector<OtherCorners> corners = sorted_corners(complex_, v);
    std::vector<std::pair<Index, bool>> ends;  // of v's edges, as often as they have faces; whether the face leaves v
    for (const auto& [x, y] : corners) {
      ends.emplace_back(x, true);
      ends.emplace_back(y, false);
    }
    const auto origin_of = [&](const auto& end) { return complex_.origin(end.first); };
    std::sort(ends.begin(), ends.end(), [&](const auto& x, const auto& y) { return origin_of(x) < origin_of(y); });
    const Vec3& origin = complex_.position(pair.a);
    for (auto first = ends.begin(); first != ends.end();) {
      const auto last = std::find_if(first, ends.end(), [first](const auto& end) { return end.first != first->first; });
      const auto [w, leaves] = *first;
      const bool is_border = last - first == 1 && w != but;
      first = last;
      if (!is_border) continue;
      const Vec3 from = complex_.position(v) - origin;
      const Vec3 to = complex_.position(w) - origin;
      leaves ? sums.add(from, to) : sums.add(to, from);
    }
  };
  add_at(pair.a, invalid_index);
  add_at(pair.b, pair.a);
  return sums;
}

NeighbourSums LindstromTurkCost::neighbours_of(const Pair& pair) const {
  const Vec3& origin = complex_.position(pair.a);
  const Vec3 d = complex_.position(pair.b) - origin;
  NeighbourSums sums = stars_[pair.a].neighbours();
  sums += stars_[pair.b].neighbours().about(-d);
  sums.remove(d);
  sums.remove(Vec3::Zero());
  Index last = invalid_index;
  for_each_common_face(complex_, pair.a, pair.b, [&](Index c, int) {
    if (c != last) sums.remove(complex_.position(c) - origin);
    last = c;
  });
  return sums;
}

void LindstromTurkCost::merge(ContractionProfile& /*profile*/, const PairEvaluation& /*ranked*/, const Change& change) {
  sum_around(change.touched);
}

}  // namespace whittle
