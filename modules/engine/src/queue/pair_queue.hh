#pragma once

#include <optional>

#include "cost/pair_cost.hh"

namespace whittle {

/// A pair whose turn has come, with its rank as it is now.
struct RankedPair {
  Pair pair;
  PairEvaluation rank;
};

/// The queue of pairs: by cost; ties by the lower, then the higher original vertex number.
class PairQueue {
 public:
  virtual ~PairQueue() = default;

  /// Takes the next pair out; nullopt when there is none.
  virtual std::optional<RankedPair> next() = 0;

  /// Puts in a pair that has been taken out, or was never in. The lower original vertex comes first.
  virtual void add(const Pair& pair) = 0;

  /// Puts the pair just taken out in again under a higher cost. False if others whose turn it is cost no less: then the
  /// pair stays out.
  virtual bool postpone(const Pair& pair, double cost) = 0;

  /// Told after each contraction, and after the cost.
  virtual void note(const Change& change) = 0;
};

/// A queued pair, under a cost that it had.
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
