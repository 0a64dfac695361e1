#include "cost/attributes/attribute_quadrics.hh"

#include <algorithm>
#include <array>

namespace whittle {
namespace {

/// The number of wedges at a vertex that can be told apart; those beyond join none.
constexpr std::size_t most_matched = 64;

}  // namespace

PairEvaluation evaluate_with_attributes(const PlacedQuadric& v0, const PlacedQuadric& v1,
                                        const PairAttributes& attributes, Placement placement,
                                        PairConstraint constraint) {
  PlacedQuadric all = v0;
  all.quadric += attributes.quadric;
  PairEvaluation evaluation = evaluate_pair(all, v1, placement, constraint);
  if (!(attributes.quadric(evaluation.position - v0.position) <= attributes.most)) {
    evaluation = evaluate_pair(v0, v1, placement, constraint);
    evaluation.cost += attributes.most;
  }
  return evaluation;
}

AttributeQuadrics::AttributeQuadrics(SurfaceAttributes attributes, std::size_t n_vertices)
    : wedges_(std::move(attributes.wedges)),
      farthest_(attributes.farthest),
      first_(n_vertices, invalid_index),
      next_(attributes.vertex_of.size()) {
  for (auto w = static_cast<Index>(next_.size()); w-- > 0;) {
    Index& first = first_[attributes.vertex_of[w]];
    next_[w] = first;
    first = w;
  }
}

/// The wedge at the vertex `many`, of those not used, that `wedge`, which is at the other end, should join.
/// \pre there is one
AttributeQuadrics::Match AttributeQuadrics::best_match(Index wedge, const Vec3& to_middle, Index many,
                                                       std::uint64_t used) const {
  Match best{invalid_index, 0};
  double least = 0;
  std::size_t place = 0;
  for (Index w = first_[many]; w != invalid_index && place < most_matched; w = next_[w], ++place) {
    if ((used >> place & 1U) != 0) continue;
    const double error = wedges_.error_between(wedge, w, to_middle, -to_middle);
    if (best.wedge != invalid_index && !(error < least)) continue;
    best = {w, place};
    least = error;
  }
  return best;
}

std::size_t AttributeQuadrics::n_wedges_at(Index v) const {
  std::size_t n = 0;
  for (Index w = first_[v]; w != invalid_index; w = next_[w]) ++n;
  return n;
}

template <class Joined, class Alone>
void AttributeQuadrics::match(const Pair& pair, bool is_edge, const Vec3& a_to_b, const Joined& joined,
                              const Alone& alone) const {
  if (is_edge && has_one(pair.a) && has_one(pair.b)) return joined(first_[pair.a], first_[pair.b]);
  Index few = pair.a;
  Index many = pair.b;
  if (n_wedges_at(few) > n_wedges_at(many)) std::swap(few, many);
  const Vec3 to_middle = (few == pair.a ? 0.5 : -0.5) * a_to_b;
  std::uint64_t used = 0;
  std::size_t n_left = is_edge ? std::min(most_matched, n_wedges_at(few)) : 0;
  for (Index w = first_[few]; w != invalid_index; w = next_[w]) {
    if (n_left == 0) {
      alone(few, w);
      continue;
    }
    --n_left;
    const auto [best, place] = best_match(w, to_middle, many, used);
    used |= std::uint64_t{1} << place;
    if (few == pair.a) {
      joined(w, best);
    } else {
      joined(best, w);
    }
  }
  std::size_t place = 0;
  for (Index w = first_[many]; w != invalid_index; w = next_[w], ++place) {
    const bool is_used = place < most_matched && (used >> place & 1U) != 0;
    if (!is_used) alone(many, w);
  }
}

PairAttributes AttributeQuadrics::of(const Pair& pair, bool is_edge, const Vec3& a_to_b) const {
  PairAttributes sum;
  if (is_edge && has_one(pair.a) && has_one(pair.b)) {
    const Index a = first_[pair.a];
    const Index b = first_[pair.b];
    return {wedges_.quadric_of_both(a, b, a_to_b), farthest_ * farthest_ * (wedges_.weight(a) + wedges_.weight(b)),
            true};
  }
  sum.never_falls = false;
  const auto joined = [&](Index at_a, Index at_b) {
    sum.quadric += wedges_.quadric_of_both(at_a, at_b, a_to_b);
    sum.most += farthest_ * farthest_ * (wedges_.weight(at_a) + wedges_.weight(at_b));
  };
  const auto alone = [&](Index vertex, Index wedge) {
    sum.quadric += vertex == pair.a ? wedges_.quadric(wedge) : wedges_.quadric(wedge).about(-a_to_b);
    sum.most += farthest_ * farthest_ * wedges_.weight(wedge);
  };
  match(pair, is_edge, a_to_b, joined, alone);
  return sum;
}

void AttributeQuadrics::merge(const Change& change, bool is_edge) {
  const std::array ends{change.pair.a, change.pair.b};
  kept_.clear();
  joined_.clear();
  const auto join = [this](Index at_a, Index at_b) {
    kept_.push_back(at_a);
    joined_.emplace_back(at_a, at_b);
  };
  match(change.pair, is_edge, change.before[1] - change.before[0], join,
        [this](Index /*vertex*/, Index wedge) { kept_.push_back(wedge); });
  for (std::size_t end = 0; end < 2; ++end) {
    for (Index w = first_[ends[end]]; w != invalid_index; w = next_[w]) {
      wedges_.move_origin(w, change.position - change.before[end]);
    }
  }
  for (const auto& [at_a, at_b] : joined_) wedges_.join(at_a, at_b);
  std::sort(kept_.begin(), kept_.end());
  first_[change.removed] = invalid_index;
  Index* last = &first_[change.survivor];
  for (const Index w : kept_) {
    *last = w;
    last = &next_[w];
  }
  *last = invalid_index;
}

SurfaceAttributes AttributeQuadrics::at(std::span<const Index> vertices) const {
  SurfaceAttributes some;
  if (!any()) return some;
  std::vector<Index> wedges;
  for (Index i = 0; i < vertices.size(); ++i) {
    for (Index w = first_[vertices[i]]; w != invalid_index; w = next_[w]) {
      wedges.push_back(w);
      some.vertex_of.push_back(i);
    }
  }
  some.wedges = wedges_.gathered(wedges);
  some.farthest = farthest_;
  return some;
}

}  // namespace whittle
