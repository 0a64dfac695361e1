#pragma once

#include "guard/guard.hh"
#include "pairs/threshold_pair_filter.hh"

namespace whittle {

/// Takes threshold pairs whose vertices share a face out of the way: there the edge decides. They are hidden, not
/// refused, and so not counted.
class HiddenPairGuard final : public Guard {
 public:
  HiddenPairGuard(const TriangleComplex& complex, ThresholdPairFilter& filter) : complex_(complex), filter_(filter) {}

  std::optional<Refusal> reason() const override { return std::nullopt; }
  bool refuses(ContractionProfile& profile) override {
    return complex_.is_threshold_pair(profile.pair.id) && filter_.hides(profile.pair);
  }
  bool is_final() const override { return true; }

 private:
  const TriangleComplex& complex_;
  ThresholdPairFilter& filter_;
};

}  // namespace whittle
