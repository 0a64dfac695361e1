#pragma once

#include "complex/constraints.hh"
#include "guard/guard.hh"

namespace whittle {

/// Refuses pairs of two locked vertices.
class LockedGuard final : public Guard {
 public:
  explicit LockedGuard(const Constraints& constraints) : constraints_(constraints) {}

  std::optional<Refusal> reason() const override { return Refusal::locked; }
  bool refuses(ContractionProfile& profile) override { return constraints_.are_both_locked(profile.pair); }
  bool is_final() const override { return true; }

 private:
  const Constraints& constraints_;
};

/// Keeps vertices on their feature lines, and lines whole and where they were.
class FeatureLineGuard final : public Guard {
 public:
  FeatureLineGuard(TriangleComplex& complex, const Constraints& constraints)
      : complex_(complex), constraints_(constraints) {}

  std::optional<Refusal> reason() const override { return Refusal::feature; }
  bool refuses(ContractionProfile& profile) override { return !constraints_.of(profile.pair); }
  bool refuses_at(ContractionProfile& profile, const Vec3& position) override {
    return constraints_.harms_a_line(complex_, profile, position);
  }

 private:
  TriangleComplex& complex_;
  const Constraints& constraints_;
};

}  // namespace whittle
