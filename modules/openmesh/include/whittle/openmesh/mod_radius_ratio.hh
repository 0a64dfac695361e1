#pragma once

#include <stdexcept>

#include "whittle/openmesh/detail/face_guard.hh"

namespace whittle {

/// Refuses a collapse that leaves a face with a radius ratio below a limit, unless the face was thinner before.
///
/// The radius ratio of a triangle is twice the radius of its inscribed circle over that of its circumscribed one
/// (radius_ratio.hh): 1 for an equilateral triangle, 0 for one without area. The module looks at the remaining faces of
/// v0 and v1, with both vertices at v̄. In a stock decimater tell it the cost module (`FaceGuardT::set_cost_module`).
///
/// In `PairDecimaterT` both drivers make this test. So the least ratio of a mesh doesn't fall below the limit, or below
/// what it was. Refusals are counted in `Refusal::shape`.
template <class MeshT>
class ModRadiusRatioT : public FaceGuardT<MeshT> {
 public:
  DECIMATING_MODULE(ModRadiusRatioT, MeshT, RadiusRatio);

  explicit ModRadiusRatioT(MeshT& mesh) : FaceGuardT<MeshT>(mesh) {}

  /// [0, 1], default 0.1; 0 refuses nothing. The error tolerance factor f of the decimater changes any ratio but 0 to
  /// ratio + (1 − ratio) (1 − f).
  /// \throw std::invalid_argument outside [0, 1]
  void set_min_radius_ratio(double ratio) {
    if (!(ratio >= 0 && ratio <= 1)) throw std::invalid_argument("ModRadiusRatioT: min_radius_ratio is not in [0, 1]");
    min_radius_ratio_ = ratio;
  }
  double min_radius_ratio() const {
    if (min_radius_ratio_ == 0) return 0;
    return min_radius_ratio_ + (1 - min_radius_ratio_) * (1 - this->error_tolerance_factor_);
  }

  float collapse_priority(const CollapseInfo& collapse) override {
    return this->priority(collapse, gets_thinner_than(min_radius_ratio()));
  }

 private:
  double min_radius_ratio_ = 0.1;
};

}  // namespace whittle
