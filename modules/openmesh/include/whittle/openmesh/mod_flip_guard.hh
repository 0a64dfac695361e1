#pragma once

#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <stdexcept>

#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/flip_limit.hh"
#include "whittle/openmesh/pair_cost_module.hh"

namespace whittle {

/// Refuses a collapse that turns a remaining face further than an angle, or takes its area away.
///
/// With n₀ = (x − v) × (y − v) and n₁ the same with v̄, for each face (v, x, y) at v0 or v1 that stays: refused when
/// n₀·n₁ < cos(angle) |n₀||n₁|, or n₁ = 0 ≠ n₀. Unlike OpenMesh's ModNormalFlippingT it looks at both stars, since a
/// placed v1 moves too; it computes without touching the mesh; and it needs no normals.
///
/// The stock decimater asks a guard when a collapse is queued, not when its turn comes: some faces still flip there.
/// `PairDecimaterT` tests when the turn comes, always, with this module's angle if it is there.
template <class MeshT>
class ModFlipGuardT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModFlipGuardT, MeshT, FlipGuard);

  explicit ModFlipGuardT(MeshT& mesh) : Base(mesh, true), mesh_(mesh) {}

  /// (0, 180], default 75; 180 refuses only what loses its area. The error tolerance factor of the decimater scales it.
  /// \throw std::invalid_argument outside
  void set_max_normal_flip_deg(double angle) {
    if (!(angle > 0 && angle <= 180)) {
      throw std::invalid_argument("ModFlipGuardT: max_normal_flip_deg is not in (0, 180]");
    }
    max_normal_flip_deg_ = angle;
  }
  double max_normal_flip_deg() const { return max_normal_flip_deg_ * this->error_tolerance_factor_; }

  /// The module that places the merged vertex, of the same decimater; null, the default: v1 keeps its place. In a stock
  /// decimater a guard has no other way to know; `PairDecimaterT` knows by itself.
  void set_cost_module(const PairCostModuleT<MeshT>* module) { cost_ = module; }

  float collapse_priority(const CollapseInfo& collapse) override {
    return static_cast<float>(turns_a_face(collapse) ? Base::ILLEGAL_COLLAPSE : Base::LEGAL_COLLAPSE);
  }

 private:
  void set_binary(bool) {}

  bool turns_a_face(const CollapseInfo& collapse) const {
    if (cost_ && cost_->has_placement()) {
      const auto position = [this](OpenMesh::VertexHandle v) { return cost_->position(v); };
      return turns_a_face(collapse, cost_->evaluate(collapse).position, position);
    }
    const auto position = [this](OpenMesh::VertexHandle v) { return to_vec3(mesh_.point(v)); };
    return turns_a_face(collapse, to_vec3(collapse.p1), position);
  }

  template <class PositionOf>
  bool turns_a_face(const CollapseInfo& collapse, const Vec3& to, const PositionOf& position_of) const {
    const FlipLimit limit(max_normal_flip_deg());
    return is_exceeded_around(limit, mesh_, collapse.v0, collapse.v1, to, position_of) ||
           is_exceeded_around(limit, mesh_, collapse.v1, collapse.v0, to, position_of);
  }

  const MeshT& mesh_;
  double max_normal_flip_deg_ = 75;
  const PairCostModuleT<MeshT>* cost_ = nullptr;
};

}  // namespace whittle
