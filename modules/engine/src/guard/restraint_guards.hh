#pragma once

#include "complex/restraints.hh"
#include "guard/guard.hh"

namespace whittle {

/// Refuses pairs of two locked vertices.
class LockedGuard final : public Guard {
 public:
  explicit LockedGuard(const Restraints& restraints) : restraints_(restraints) {}

  std::optional<Refusal> reason() const override { return Refusal::locked; }
  bool refuses(ContractionProfile& profile) override { return restraints_.are_both_locked(profile.pair); }
  bool is_final() const override { return true; }

 private:
  const Restraints& restraints_;
};

/// Keeps vertices on their feature lines, and lines whole and where they were.
class FeatureLineGuard final : public Guard {
 public:
  FeatureLineGuard(TriangleComplex& complex, const Restraints& restraints)
      : complex_(complex), restraints_(restraints) {}

  std::optional<Refusal> reason() const override { return Refusal::feature; }
  bool refuses(ContractionProfile& profile) override { return !restraints_.pinned(profile.pair); }
  bool refuses_at(ContractionProfile& profile, const Vec3& position) override {
    return restraints_.harms_a_line(complex_, profile, position);
  }

 private:
  TriangleComplex& complex_;
  const Restraints& restraints_;
};

}  // namespace whittle
