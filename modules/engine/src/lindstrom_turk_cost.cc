#include "lindstrom_turk_cost.hh"

#include <algorithm>
#include <utility>

#include "face_walk.hh"
#include "whittle/engine/parallel.hh"

namespace whittle {
LindstromTurkCost::LindstromTurkCost(const TriangleComplex& complex, const Restraints& restraints, unsigned threads)
    : complex_(complex), restraints_(restraints) {
  stars_.resize(complex.n_vertex_slots());
  for_each_range(stars_.size(), threads, [this](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) stars_[v] = sum_star(v);
  });
}

LindstromTurkCost::StarSums LindstromTurkCost::sum_star(Index v) const {
  StarSums sums{{}, Vec3::Zero()};
  const Vec3& p = complex_.position(v);
  for_each_face(complex_, v, [&](Index x, Index y) {
    const Vec3 normal = (complex_.position(x) - p).cross(complex_.position(y) - p);
    sums.normal += normal;
    sums.squares += SymmetricMatrix::outer(normal, 1);
  });
  return sums;
}

void LindstromTurkCost::evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const {
  std::transform(pairs.begin(), pairs.end(), evaluations.begin(),
                 [this](const Pair& pair) { return evaluate_one(pair); });
}

/// About its first vertex.
PairEvaluation LindstromTurkCost::evaluate_one(const Pair& pair) const {
  const Vec3& origin = complex_.position(pair.a);
  LindstromTurk term(volume_of(pair), border_of(pair), Vec3::Zero(), complex_.position(pair.b) - origin);
  if (!term.is_determined()) term.add_neighbours(neighbours_of(pair));
  PairEvaluation evaluation = term.evaluate(restraints_.pinned(pair).value_or(Pinned::first));
  evaluation.position += origin;
  return evaluation;
}

/// Of the planes of the second vertex's faces, those of faces with the first one pass through the origin, too.
VolumeSums LindstromTurkCost::volume_of(const Pair& pair) const {
  const Vec3& origin = complex_.position(pair.a);
  const Vec3 d = complex_.position(pair.b) - origin;
  VolumeSums sums{stars_[pair.a].normal, 0, {stars_[pair.a].squares}};
  sums += VolumeSums{stars_[pair.b].normal, 0, {stars_[pair.b].squares}}.about(-d);
  for_each_common_face(complex_, pair.a, pair.b, [&](Index c, int turn) {
    const Vec3 normal = turn * d.cross(complex_.position(c) - origin);
    sums.normal -= normal;
    sums.squares.a += SymmetricMatrix::outer(normal, -1);
  });
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

/// By their original numbers.
NeighbourSums LindstromTurkCost::neighbours_of(const Pair& pair) const {
  std::vector<Index> neighbours;
  for (const Index v : {pair.a, pair.b}) {
    for (const Spoke& spoke : complex_.neighbours(v)) neighbours.push_back(spoke.vertex);
  }
  const auto is_before = [this](Index v, Index w) { return complex_.origin(v) < complex_.origin(w); };
  std::sort(neighbours.begin(), neighbours.end(), is_before);
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  NeighbourSums sums;
  for (const Index v : neighbours) {
    if (v != pair.a && v != pair.b) sums.add(complex_.position(v) - complex_.position(pair.a));
  }
  return sums;
}

PlacedQuadric LindstromTurkCost::merged(const Pair&, const PairEvaluation& evaluation) const {
  return {evaluation.position, {}};
}

void LindstromTurkCost::note_contraction(std::span<const Index> changed) {
  for (const Index v : changed) stars_[v] = sum_star(v);
}

}  // namespace whittle
