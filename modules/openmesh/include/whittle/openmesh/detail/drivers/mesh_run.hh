#pragma once

#include <memory>
#include <optional>

#include "whittle/openmesh/detail/drivers/mesh_run_costs.hh"
#include "whittle/openmesh/detail/drivers/run_input.hh"

namespace whittle {

template <class MeshT>
class PairDecimaterT;

/// One call of `decimate` with the mesh driver: the engine's loop, in which OpenMesh's modules take part. The cost
/// module ranks and places (mesh_run_costs.hh); binary modules are guards. Each contraction of the engine is made
/// on the mesh at once, so that modules and observers see the mesh as it is.
template <class MeshT>
class MeshRunT final : private DecimationHost {
 public:
  /// \param target with the limit of the cost module
  MeshRunT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target, bool only_selected);

  DecimateResult run();

 private:
  using Mesh = MeshT;
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;
  using Module = typename PairDecimaterT<MeshT>::Module;
  using CollapseInfo = typename PairDecimaterT<MeshT>::CollapseInfo;

  friend class ModuleCostT<MeshRunT>;
  friend class PlacingCostT<MeshRunT>;
  friend class PriorityCostT<MeshRunT>;
  friend class ForeignCostT<MeshRunT>;
  using ModuleCost = ModuleCostT<MeshRunT>;

  // DecimationHost
  bool keeps_topology() const override { return true; }
  bool refuses(const HostedContraction& contraction) override;
  void count_refusal() override;
  bool follow(const HostedContraction& made, const Contraction& contraction) override;
  HostedCost* cost() override;
  const DecimationState* state() const override { return &state_; }

  const auto& roles() const { return decimater_.roles_; }
  void count_refusal_by_cost() { decimater_.count_refusal(*roles().cost_module); }
  bool is_collapse_legal(const CollapseInfo& collapse) { return decimater_.is_collapse_legal(collapse); }
  bool is_refused_by(Module& module, const CollapseInfo& collapse);
  std::unique_ptr<ModuleCost> make_cost();
  DecimateOptions options() const;
  DecimationState initial_state() const;
  static std::vector<bool> vertices_with_copies(const MeshT& mesh);
  bool is_fixed(VertexHandle v) const;
  Vec3 position(Index v) const { return state_.vertices[v].position; }
  HalfedgeHandle halfedge(Index from, Index to) const {
    return mesh_.find_halfedge(input_.handle(from), input_.handle(to));
  }
  void collapse(const HostedContraction& made);
  void require_that_modules_followed(const HostedContraction& made) const;

  PairDecimaterT<MeshT>& decimater_;
  MeshT& mesh_;
  DecimateTarget target_;
  bool only_selected_;
  std::vector<bool> has_copies_;  ///< by handle; empty if there are no copies
  RunInput input_;
  std::unique_ptr<ModuleCost> cost_;
  DecimationState state_;  ///< positions as they are now
  std::uint64_t n_contractions_ = 0;
  std::uint64_t n_followed_before_ = 0;  ///< collapses that the error guard had been told of before the run
  Module* refusing_module_ = nullptr;    ///< the one that refused last; null if a vertex was locked
  bool is_refused_for_error_ = false;    ///< whether it did because of a limit of the error
  RefusalCounts refusals_;               ///< that the engine doesn't count
};

}  // namespace whittle

#include "whittle/openmesh/detail/drivers/mesh_run_impl.hh"
