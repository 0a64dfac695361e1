#pragma once

#include "complex/triangle_complex.hh"
#include "guard/guard.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// Refuses what changes the topology, as far as it is to be kept; with `Topology::automatic` what opens a closed
/// manifold. Plans a non-manifold contraction in the profile for
/// what is allowed to change it.
class TopologyGuard final : public Guard {
 public:
  TopologyGuard(TriangleComplex& complex, Topology topology)
      : complex_(complex), topology_(topology), stays_closed_(topology == Topology::automatic && complex.is_closed()) {}

  std::optional<Refusal> reason() const override { return Refusal::link; }
  bool refuses(ContractionProfile& profile) override;

 private:
  TriangleComplex& complex_;
  Topology topology_;
  bool stays_closed_;
};

}  // namespace whittle
