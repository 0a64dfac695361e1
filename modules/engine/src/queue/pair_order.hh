#pragma once

#include <optional>

#include "cost/pair_cost.hh"

namespace whittle {

/// A pair whose turn it is, and what it would cost now.
struct Turn {
  Pair pair;
  PairEvaluation evaluation;
};

/// The order in which pairs have their turns: by cost; ties by the lower, then the higher original vertex number.
class PairOrder {
 public:
  virtual ~PairOrder() = default;

  /// Takes the next pair out; nullopt when there is none.
  virtual std::optional<Turn> next() = 0;

  /// Puts in a pair that has been taken out, or was never in. The lower original vertex first.
  virtual void add(const Pair& pair) = 0;

  /// Puts the pair just taken out in again under a higher cost, unless that is no more than what others cost whose turn
  /// it is: then false.
  virtual bool postpone(const Pair& pair, double cost) = 0;

  /// Told after each contraction. \param changed as `PairCost::note_contraction`
  virtual void note_contraction(Index survivor, Index removed, std::span<const Index> changed) = 0;
};

/// One of the queued, under a cost it had.
struct Candidate {
  double cost;
  std::uint64_t tie;  ///< the lower, then the higher original number of the two vertices
  Pair pair;
  Index placement = invalid_index;  ///< of its evaluation among those remembered, if there

  friend bool is_before(const Candidate& x, const Candidate& y) {
    return x.cost != y.cost ? x.cost < y.cost : x.tie < y.tie;
  }
};
struct IsAfter {
  bool operator()(const Candidate& x, const Candidate& y) const { return is_before(y, x); }
};

inline Candidate candidate(const TriangleComplex& complex, const Pair& pair, double cost) {
  return {cost, std::uint64_t{complex.origin(pair.a)} << 32 | complex.origin(pair.b), pair};
}

/// The vertex of the lower original number first.
inline Pair in_order(const TriangleComplex& complex, const Pair& pair) {
  const bool is_a_first = complex.origin(pair.a) < complex.origin(pair.b);
  return {pair.id, select(is_a_first, pair.a, pair.b), select(is_a_first, pair.b, pair.a)};
}
/// With what its ends have become.
inline Pair pair_now(TriangleComplex& complex, Index id) {
  const auto [a, b] = complex.ends(id);
  return in_order(complex, {id, a, b});
}

}  // namespace whittle
