#pragma once

#include <algorithm>

#include "complex/constraints.hh"
#include "cost/pair_cost.hh"
#include "whittle/engine/host.hh"

namespace whittle {

/// A host's cost as the engine asks it. One thread asks at a time.
class HostCost final : public StatelessCost {
 public:
  HostCost(const TriangleComplex& complex, const Constraints& constraints, HostedCost& cost)
      : complex_(complex), constraints_(constraints), cost_(cost) {}

  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double enough) const override;
  CandidatePositions place(ContractionProfile& profile, const PairEvaluation& ranked) const override;
  double final_cost(const ContractionProfile& profile, const PairEvaluation& ranked,
                    const Vec3& position) const override;
  /// At least the ends: nothing says that a host's ranks are lower bounds.
  Reach affects() const override { return std::max(cost_.reach(), Reach::ends); }

 private:
  const TriangleComplex& complex_;
  const Constraints& constraints_;
  HostedCost& cost_;
};

/// A profile's contraction in the words of hosts.
HostedContraction hosted(const TriangleComplex& complex, const ContractionProfile& profile,
                         const PairEvaluation& ranked, const Vec3& position);

}  // namespace whittle
