#pragma once

#include "complex/contraction_profile.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/host.hh"

namespace whittle {

/// What the loop asks of a cost when a pair's turn has come: where the merged vertex goes, and what that costs. What
/// several functions share is kept in the profile.
class Placer {
 public:
  virtual ~Placer() = default;

  /// Positions to try, the best first.
  virtual CandidatePositions place(ContractionProfile& /*profile*/, const PairEvaluation& ranked) const {
    CandidatePositions candidates;
    candidates.add(ranked.position);
    return candidates;
  }

  /// What a contraction to `position` costs: its rank, or more.
  virtual double final_cost(const ContractionProfile& /*profile*/, const PairEvaluation& ranked,
                            const Vec3& /*position*/) const {
    return ranked.cost;
  }

  /// Updates what is kept of vertices. \param profile as it was before the contraction
  virtual void merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) = 0;
};

}  // namespace whittle
