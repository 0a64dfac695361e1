#pragma once

#include <algorithm>

#include "complex/restraints.hh"
#include "cost/stateless_cost.hh"
#include "whittle/engine/host.hh"

namespace whittle {

/// A host's cost as the engine asks it. One thread asks at a time.
class HostCost final : public StatelessCost {
 public:
  HostCost(const TriangleComplex& complex, const Restraints& restraints, HostedCost& cost)
      : StatelessCost(complex), restraints_(restraints), cost_(cost) {}

  using PairCost::rank;
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override;
  Settlement settle(ContractionProfile& profile, const PairEvaluation& ranked) const override;
  double final_cost(const ContractionProfile& profile, const PairEvaluation& ranked,
                    const Vec3& position) const override;
  /// At least the ends: nothing says that a host's ranks are lower bounds.
  Reach reach() const override { return std::max(cost_.reach(), Reach::ends); }

 private:
  const Restraints& restraints_;
  HostedCost& cost_;
};

/// A profile's contraction in the words of hosts.
HostedContraction hosted(const TriangleComplex& complex, const ContractionProfile& profile,
                         const PairEvaluation& ranked, const Vec3& position);

}  // namespace whittle
