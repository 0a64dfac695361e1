#pragma once

#include "guard/guard.hh"
#include "host/host_cost.hh"

namespace whittle {

/// Refuses what a half-edge mesh can't follow.
class NonmanifoldGuard final : public Guard {
 public:
  std::optional<Refusal> reason() const override { return Refusal::link; }
  bool refuses(ContractionProfile& profile) override { return profile.is_nonmanifold; }
};

/// Refuses what a host refuses, which counts that itself.
class HostGuard final : public Guard {
 public:
  HostGuard(const TriangleComplex& complex, DecimationHost& host) : complex_(complex), host_(host) {}

  std::optional<Refusal> reason() const override { return std::nullopt; }
  void count(RefusalCounts& /*refusals*/) override { host_.count_refusal(); }
  bool refuses_at(ContractionProfile& profile, const Vec3& position) override {
    return host_.refuses(hosted(complex_, profile, profile.ranked, position));
  }
  int n_rings() const override { return 2; }  // what modules look at is unknown; some look at valences

 private:
  const TriangleComplex& complex_;
  DecimationHost& host_;
};

}  // namespace whittle
