#pragma once

#include "complex/triangle_complex.hh"
#include "guard/guard.hh"
#include "whittle/engine/formula/flip_limit.hh"

namespace whittle {

/// Refuses what turns the normal of a remaining face too far, or leaves a face without area (flip_limit.hh).
class FlipGuard final : public Guard {
 public:
  /// \param quadric if the cost looks at the faces as a ring, the planes that it will ask for there
  FlipGuard(const TriangleComplex& complex, double max_angle_deg, const QuadricOptions& quadric)
      : complex_(complex), limit_(max_angle_deg), quadric_(quadric) {}

  std::optional<Refusal> reason() const override { return Refusal::flip; }
  bool refuses_at(ContractionProfile& profile, const Vec3& position) override;

 private:
  const TriangleComplex& complex_;
  FlipLimit limit_;
  QuadricOptions quadric_;
};

}  // namespace whittle
