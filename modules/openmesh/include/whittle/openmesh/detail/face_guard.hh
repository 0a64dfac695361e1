#pragma once

#include <OpenMesh/Tools/Decimater/ModBaseT.hh>

#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/detail/moved_faces.hh"
#include "whittle/openmesh/pair_cost_module.hh"

namespace whittle {

/// A binary module that looks at the faces which a collapse moves: those of v0 *and* of v1, which a cost module may
/// move, too. It computes the moved faces without changing the mesh, and needs no normals.
///
/// The stock decimater asks a guard when a collapse is queued, not when its turn comes. So some bad faces are still
/// made. `PairDecimaterT` asks when the turn comes.
template <class MeshT>
class FaceGuardT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  using ModBase = OpenMesh::Decimater::ModBaseT<MeshT>;
  using CollapseInfo = typename ModBase::CollapseInfo;

  /// The module of the same decimater that places the merged vertex. Null, the default: v1 keeps its position. A guard
  /// in a stock decimater has no other way to find it; `PairDecimaterT` finds it by itself.
  void set_cost_module(const PairCostModuleT<MeshT>* module) { cost_ = module; }

  void set_binary(bool) = delete;  // always binary, as it only refuses

 protected:
  explicit FaceGuardT(MeshT& mesh) : ModBase(mesh, true), mesh_(mesh) {}

  /// Illegal if `is_bad(from, to, x, y)` for any face (v, x, y) whose corner v moves.
  template <class IsBad>
  float priority(const CollapseInfo& collapse, const IsBad& is_bad) const {
    return static_cast<float>(moves_bad_face(collapse, is_bad) ? ModBase::ILLEGAL_COLLAPSE : ModBase::LEGAL_COLLAPSE);
  }

  /// Where the merged vertex goes, rounded to the scalar of the mesh.
  typename MeshT::Point merged_point(const CollapseInfo& collapse) const {
    if (!cost_ || !cost_->has_placement()) return collapse.p1;
    const Vec3 position = cost_->evaluate(collapse).position;
    if (position == cost_->position(collapse.v1)) return mesh_.point(collapse.v1);
    return to_point<typename MeshT::Point>(cost_->frame().to_model(position));
  }

 private:
  template <class IsBad>
  bool moves_bad_face(const CollapseInfo& collapse, const IsBad& is_bad) const {
    if (cost_ && cost_->has_placement()) {
      const auto position = [this](OpenMesh::VertexHandle v) { return cost_->position(v); };
      return any_moved_face(mesh_, collapse, cost_->evaluate(collapse).position, position, is_bad);
    }
    const auto position = [this](OpenMesh::VertexHandle v) { return to_vec3(mesh_.point(v)); };
    return any_moved_face(mesh_, collapse, to_vec3(collapse.p1), position, is_bad);
  }

  const MeshT& mesh_;
  const PairCostModuleT<MeshT>* cost_ = nullptr;
};

}  // namespace whittle
