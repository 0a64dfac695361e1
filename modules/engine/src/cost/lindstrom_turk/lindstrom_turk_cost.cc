#include "cost/lindstrom_turk/lindstrom_turk_cost.hh"

#include <algorithm>
#include <numeric>
#include <utility>

#include "complex/face_walk.hh"
#include "whittle/core/detail/lanes.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/detail/select.hh"
#include "whittle/engine/formula/volume_sums.hh"

namespace whittle {
void LindstromTurkCost::start(CostState&& /*before*/, unsigned threads) {
  stars_.resize(complex_.n_vertex_slots());
  for_each_range(stars_.size(), threads, [this](std::size_t begin, std::size_t end) {
    std::vector<Index> vertices(end - begin);
    std::iota(vertices.begin(), vertices.end(), static_cast<Index>(begin));
    sum_around(vertices);
  });
}

/// Counter-clockwise from the lowest original number on.
WHITTLE_INLINE void LindstromTurkCost::sum_around_ring(Index v) {
  const std::span<const Neighbour> ring = complex_.neighbours(v);
  const Double4 p = side_by_side(complex_.position(v));
  const std::size_t first = lowest_place(complex_, ring);
  StarAdder star;
  Double4 to_x = side_by_side(complex_.position(ring[first].vertex)) - p;
  std::size_t place = first;
  do {
    place = place + 1 < ring.size() ? place + 1 : 0;
    const Double4 to_y = side_by_side(complex_.position(ring[place].vertex)) - p;
    star.add_face(to_x, to_y);
    star.add_neighbour(to_y);
    to_x = to_y;
  } while (place != first);
  stars_[v] = star.sums(p, ring.size());
}

WHITTLE_INLINE void LindstromTurkCost::sum_around_each(std::span<const Index> vertices) {
  for (const Index v : vertices) {
    if (complex_.is_ring(v) && complex_.has_faces(v)) {
      sum_around_ring(v);
    } else {
      sum_around_irregular(v);
    }
  }
}

WHITTLE_AVX2 void LindstromTurkCost::sum_around_with_double4(std::span<const Index> vertices) {
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
  std::vector<LinkEdgePoints> faces;
  std::vector<Vec3> neighbours;
  for (const auto& [x, y] : ordered_corners(complex_, v)) {
    faces.push_back({complex_.position(x), complex_.position(y)});
  }
  for (const Index w : ordered_neighbours(complex_, v)) neighbours.push_back(complex_.position(w));
  stars_[v] = sum_star(complex_.position(v), faces, neighbours);
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
  sides.corners = {select_branch_free(behind_is_first, behind, ahead),
                   select_branch_free(behind_is_first, ahead, behind)};
  sides.turn = behind_is_first ? -1 : 1;
  return true;
}

template <class Real>
WHITTLE_INLINE void LindstromTurkCost::rank_group(const std::array<Sides, n_lanes<Real>>& group,
                                                  std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const {
  const auto star_a = [&](std::size_t lane) -> const StarSums& { return stars_[group[lane].a]; };
  const auto star_b = [&](std::size_t lane) -> const StarSums& { return stars_[group[lane].b]; };
  const StarLanes<Real> a = star_lanes<Real>(star_a);
  const StarLanes<Real> b = star_lanes<Real>(star_b);
  const PointLanes<Real>& origin = a.position;
  const PointLanes<Real> d = b.position - origin;
  const auto corner = [&](std::size_t side) WHITTLE_INLINE_LAMBDA {
    const auto star = [&](std::size_t lane) -> const StarSums& { return stars_[group[lane].corners[side]]; };
    return star_positions<Real>(star) - origin;
  };
  Real turn;
  fill_lanes(turn, [&](std::size_t lane) { return group[lane].turn; });
  const std::array<CommonFaceLanes<Real>, 2> common{{{corner(0), turn}, {corner(1), -turn}}};

  const VolumeLanes<Real> sums = pair_volume(a, b, d, common);
  VolumeConstraints<Real> constraints = volume_constraints(sums);
  if (any_lane(constraints.has_third == 0)) {
    const NeighbourLanes<Real> of_a = neighbour_lanes<Real>(star_a);
    const NeighbourLanes<Real> of_b = neighbour_lanes<Real>(star_b);
    add_neighbours(constraints, pair_neighbours(of_a, of_b, d, common));
  }
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
WHITTLE_INLINE void LindstromTurkCost::rank_in_lanes(std::span<const Pair> pairs,
                                                     std::span<PairEvaluation> ranks) const {
  std::array<Sides, n_lanes<Real>> group;
  std::size_t n = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [id, a, b] = pairs[i];
    const bool is_inside =
        complex_.is_ring(a) && complex_.is_ring(b) && constraints_.of(pairs[i]) == PairConstraint::none;
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

WHITTLE_AVX2 void LindstromTurkCost::rank_four_at_once(std::span<const Pair> pairs,
                                                       std::span<PairEvaluation> ranks) const {
  rank_in_lanes<Double4>(pairs, ranks);
}

/// Pairs inside the surface several at once.
void LindstromTurkCost::rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double /*enough*/) const {
  if (has_double4) {
    rank_four_at_once(pairs, ranks);
  } else {
    rank_in_lanes<Double2>(pairs, ranks);
  }
}

PairEvaluation LindstromTurkCost::rank_one(const Pair& pair) const {
  std::vector<CommonFace> common;
  for_each_common_face(complex_, pair.a, pair.b, [&](Index c, int turn) {
    common.push_back({c, complex_.position(c), turn});
  });
  std::vector<BorderEdge> border;
  add_border_at(pair.a, invalid_index, border);
  add_border_at(pair.b, pair.a, border);
  const PairConstraint constraint = constraints_.of(pair).value_or(PairConstraint::first);
  return evaluate_lindstrom_turk(stars_[pair.a], stars_[pair.b], common, border, constraint);
}

/// The border edges at v but for the one to `but`, by the original number of the other end.
void LindstromTurkCost::add_border_at(Index v, Index but, std::vector<BorderEdge>& border) const {
  if (complex_.is_ring(v)) return;
  std::vector<std::pair<Index, bool>> ends;  // of v's edges, as often as they have faces; whether the face leaves v
  for (const auto& [x, y] : sorted_corners(complex_, v)) {
    ends.emplace_back(x, true);
    ends.emplace_back(y, false);
  }
  const auto origin_of = [&](const auto& end) { return complex_.origin(end.first); };
  std::sort(ends.begin(), ends.end(), [&](const auto& x, const auto& y) { return origin_of(x) < origin_of(y); });
  const Vec3& here = complex_.position(v);
  for (auto first = ends.begin(); first != ends.end();) {
    const auto last = std::find_if(first, ends.end(), [first](const auto& end) { return end.first != first->first; });
    const auto [w, leaves] = *first;
    const bool is_border = last - first == 1 && w != but;
    first = last;
    if (!is_border) continue;
    const Vec3& there = complex_.position(w);
    border.push_back(leaves ? BorderEdge{here, there} : BorderEdge{there, here});
  }
}

void LindstromTurkCost::merge(ContractionProfile& /*profile*/, const PairEvaluation& /*ranked*/, const Change& change) {
  sum_around(change.touched);
}

}  // namespace whittle
