#pragma once

#include "complex/triangle_complex.hh"
#include "guard/guard.hh"

namespace whittle {

/// Refuses what leaves a face with a smaller radius ratio (radius_ratio.hh) than allowed, unless it was smaller before.
class RadiusRatioGuard final : public Guard {
 public:
  /// \param min_radius_ratio (0, 1]
  RadiusRatioGuard(const TriangleComplex& complex, double min_radius_ratio)
      : complex_(complex), min_radius_ratio_(min_radius_ratio) {}

  std::optional<Refusal> reason() const override { return Refusal::shape; }
  bool refuses_at(ContractionProfile& profile, const Vec3& position) override;

 private:
  bool makes_thin(const StarFaces& faces, const Vec3& from, const Vec3& to) const;

  const TriangleComplex& complex_;
  double min_radius_ratio_;
};

}  // namespace whittle
