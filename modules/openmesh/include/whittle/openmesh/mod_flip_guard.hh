#pragma once

#include <stdexcept>

#include "whittle/openmesh/detail/face_guard.hh"

namespace whittle {

/// Refuses a collapse that turns a remaining face further than an angle, or takes away its area.
///
/// For each remaining face (v, x, y) at v0 or v1 let n₀ = (x − v) × (y − v), and n₁ the same with v̄ for v. The
/// collapse is refused when n₀·n₁ < cos(angle) |n₀||n₁|, or n₁ = 0 ≠ n₀. Unlike OpenMesh's ModNormalFlippingT the
/// module looks at both stars, since v1 moves too. In a stock decimater tell it the cost module
/// (`FaceGuardT::set_cost_module`).
///
/// `PairDecimaterT` always makes this test. If this module was added, its angle is used.
template <class MeshT>
class ModFlipGuardT : public FaceGuardT<MeshT> {
 public:
  DECIMATING_MODULE(ModFlipGuardT, MeshT, FlipGuard);

  explicit ModFlipGuardT(MeshT& mesh) : FaceGuardT<MeshT>(mesh) {}

  /// (0, 180], default 75; at 180 only a face that loses its area is refused. The error tolerance factor of the
  /// decimater scales it.
  /// \throw std::invalid_argument outside this range
  void set_max_normal_flip_deg(double angle) {
    if (!(angle > 0 && angle <= 180)) {
      throw std::invalid_argument("ModFlipGuardT: max_normal_flip_deg is not in (0, 180]");
    }
    max_normal_flip_deg_ = angle;
  }
  double max_normal_flip_deg() const { return max_normal_flip_deg_ * this->error_tolerance_factor_; }

  float collapse_priority(const CollapseInfo& collapse) override {
    const FlipLimit limit(max_normal_flip_deg());
    return this->priority(collapse, turns_beyond(limit));
  }

 private:
  double max_normal_flip_deg_ = 75;
};

}  // namespace whittle
