#pragma once

#include <span>

#include "complex/triangle_complex.hh"
#include "cost/cost_state.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/reach.hh"

namespace whittle {

/// Ranks pairs, then settles where the merged vertex goes and what that costs. A cost keeps what it needs to know about
/// vertices. Between calls it remembers nothing about pairs; the profile has room for what several calls share.
///
/// Life of a cost, told by the loop:
///
///   see_faces()                    the faces of each vertex are listed
///   see_seams(planes)              only if there are some, and nothing is to be recalled; faces are still listed
///   see_attributes(attributes)     only if some count
///   start()                        neighbours and edges are known
///   resume(state)                  only if the run goes on from another one
///   recall(memory)                 only if others worked on the surface before
///   rank(pairs)                    whenever the queue asks; looks at vertices alone
///   settle(profile, ranked)        a pair's turn has come: positions to try, the best first
///   final_cost(profile, ranked, p) the guards accept position p
///   merge(profile, ranked, change) the pair was contracted
class PairCost : public CostState {
 public:
  /// \param pairs each with the vertex of the lower original number first, edges before threshold pairs. Several
  ///        threads may ask at once.
  virtual void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const = 0;
  /// Likewise, with less work where a pair costs at least `enough`: its rank may cost less than it does, but that much.
  virtual void rank_up_to(double /*enough*/, std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const {
    rank(pairs, ranks);
  }
  PairEvaluation rank(const Pair& pair) const {
    PairEvaluation ranked;
    rank({&pair, 1}, {&ranked, 1});
    return ranked;
  }

  /// Where the merged vertex may go, the best position first.
  virtual Settlement settle(ContractionProfile& /*profile*/, const PairEvaluation& ranked) const {
    Settlement settlement;
    settlement.add(ranked.position);
    return settlement;
  }

  /// What a contraction to `position` costs: its rank, or more.
  virtual double final_cost(const ContractionProfile& /*profile*/, const PairEvaluation& ranked,
                            const Vec3& /*position*/) const {
    return ranked.cost;
  }

  /// Which pairs a contraction may make cheaper.
  virtual Reach reach() const = 0;

  /// Around which vertices `rank` looks at lists, which must be compact there.
  virtual Reach sight() const { return Reach::none; }
};

}  // namespace whittle
