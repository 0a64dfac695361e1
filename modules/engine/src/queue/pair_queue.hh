#pragma once

#include <optional>
#include <vector>

#include "queue/pair_ranks.hh"

namespace whittle {

/// A pair whose turn has come, with its rank as it is now.
struct RankedPair {
  Pair pair;
  PairEvaluation rank;
};

/// Pairs in order of cost; ties by the lower, then the higher origin.
class PairQueue {
 public:
  virtual ~PairQueue() = default;

  /// Takes the next pair out; nullopt when there is none.
  virtual std::optional<RankedPair> next() = 0;

  /// Puts in a pair that isn't queued. \pre `pair.a` has the lower origin
  virtual void add(const Pair& pair) = 0;

  /// Queues the pair just taken out again, under a higher cost. False if the pairs whose turn it is cost no less: then
  /// it stays out.
  virtual bool postpone(const Pair& pair, double cost) = 0;

  /// Adds to `ids` the pairs at v that may get cheaper.
  virtual void list_raised(Index /*v*/, std::vector<Index>& /*ids*/) const {}

  /// Told after each contraction, once the cost has been told.
  virtual void note(const Change& change) = 0;
};

/// A queued pair, under the cost that it had when it was ranked last.
struct Candidate {
  double cost;
  std::uint64_t tie;  ///< the lower, then the higher origin of the two vertices
  Pair pair;
  Index placement = invalid_index;  ///< index among the remembered placements, if it is there

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

/// The vertex with the lower origin first.
inline Pair in_order(const TriangleComplex& complex, const Pair& pair) {
  const bool is_a_first = complex.origin(pair.a) < complex.origin(pair.b);
  return {pair.id, select_branch_free(is_a_first, pair.a, pair.b), select_branch_free(is_a_first, pair.b, pair.a)};
}
/// With its ends as they are now.
inline Pair pair_now(TriangleComplex& complex, Index id) {
  const auto [a, b] = complex.ends(id);
  return in_order(complex, {id, a, b});
}

}  // namespace whittle
