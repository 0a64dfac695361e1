#pragma once

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "whittle/openmesh/detail/drivers/mesh_run.hh"
#include "whittle/openmesh/detail/feature_bits.hh"
#include "whittle/openmesh/pair_cost_module.hh"

namespace whittle {

/// Copies of a vertex would have to move together, which the mesh driver can't do: they stay.
template <class MeshT>
MeshRunT<MeshT>::MeshRunT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target, bool only_selected)
    : decimater_(decimater),
      mesh_(decimater.mesh()),
      target_(target),
      only_selected_(only_selected),
      has_copies_(vertices_with_copies(mesh_)),
      input_(mesh_, Copies::apart, [this](VertexHandle v) { return is_fixed(v); }),
      cost_(make_cost()),
      state_(initial_state()),
      n_followed_before_(decimater.roles_.error_guard ? decimater.roles_.error_guard->n_followed() : 0) {}

template <class MeshT>
std::vector<bool> MeshRunT<MeshT>::vertices_with_copies(const MeshT& mesh) {
  const std::vector<Index> firsts = first_copies(mesh);
  std::vector<bool> result(firsts.size());
  for (Index v = 0; v < firsts.size(); ++v) {
    if (firsts[v] != v) result[v] = result[firsts[v]] = true;
  }
  return result;
}

/// By the status bits as they are now: modules may lock vertices during the run.
template <class MeshT>
bool MeshRunT<MeshT>::is_fixed(VertexHandle v) const {
  return decimater_.is_fixed(v, only_selected_) ||
         (!has_copies_.empty() && has_copies_[static_cast<std::size_t>(v.idx())]);
}

template <class MeshT>
DecimationState MeshRunT<MeshT>::initial_state() const {
  DecimationState state;
  state.frame = cost_->frame();
  for (Index v = 0; v < input_.mesh.positions.size(); ++v) state.vertices.push_back({cost_->position_at_start(v), {}});
  return state;
}

template <class MeshT>
std::unique_ptr<ModuleCostT<MeshRunT<MeshT>>> MeshRunT<MeshT>::make_cost() {
  if (!roles().cost) return std::make_unique<ForeignCostT<MeshRunT>>(*this);
  if (roles().has_own_priority) return std::make_unique<PriorityCostT<MeshRunT>>(*this);
  return std::make_unique<PlacingCostT<MeshRunT>>(*this);
}

template <class MeshT>
HostedCost* MeshRunT<MeshT>::cost() {
  return cost_.get();
}

template <class MeshT>
DecimateOptions MeshRunT<MeshT>::options() const {
  DecimateOptions options = decimater_.engine_options_but_cost();
  options.locked = input_.locked;
  options.feature_edges = input_.features;
  return options;
}

template <class MeshT>
DecimateResult MeshRunT<MeshT>::run() {
  Decimation small = whittle::decimate(input_.mesh, cost_->target(), options(), *this);
  std::vector<Index> vertex_of(mesh_.n_vertices(), invalid_index);
  for (Index v = 0; v < small.mesh.origins.size(); ++v) vertex_of[small.mesh.origins[v]] = v;
  input_.write_corners(small, vertex_of, decimater_.threads_, mesh_);
  DecimateResult result = small.result;
  result.n_vertices = count_vertices(mesh_, first_copies(mesh_));
  result.refusals += refusals_;
  cost_->complete(result);
  return result;
}

// Guards --------------------------------------------------------------------------------------------------------------

/// A guard of OpenMesh's looks at the faces of v0 with v0 at p1. So it gets v̄ as p1. If v1 moves, it is also asked
/// about v1's faces, as if v1 collapsed.
template <class MeshT>
bool MeshRunT<MeshT>::refuses(const HostedContraction& contraction) {
  const bool v1_moves = contraction.position != position(contraction.survivor);
  const CollapseInfo info(mesh_, halfedge(contraction.removed, contraction.survivor));
  if (is_fixed(info.v0) || (v1_moves && is_fixed(info.v1))) {
    refusing_module_ = nullptr;
    return true;
  }
  if (decimater_.roles_.asked_guards.empty()) return false;
  CollapseInfo forward = info;
  CollapseInfo backward(mesh_, info.v1v0);
  if (v1_moves) forward.p1 = backward.p1 = to_point<typename MeshT::Point>(state_.frame.to_model(contraction.position));
  for (Module* module : decimater_.roles_.asked_guards) {
    if (!is_refused_by(*module, forward) && !(v1_moves && is_refused_by(*module, backward))) continue;
    refusing_module_ = module;
    return true;
  }
  return false;
}

/// A class derived from `ModMaxErrorT` may refuse for reasons of its own.
template <class MeshT>
bool MeshRunT<MeshT>::is_refused_by(Module& module, const CollapseInfo& collapse) {
  if (&module != decimater_.roles_.error_guard) return !(module.collapse_priority(collapse) >= 0);
  const std::uint64_t n_before = decimater_.roles_.error_guard->n_refused();
  if (module.collapse_priority(collapse) >= 0) return false;
  is_refused_for_error_ = decimater_.roles_.error_guard->n_refused() > n_before;
  return true;
}

template <class MeshT>
void MeshRunT<MeshT>::count_refusal() {
  if (refusing_module_ == nullptr) {
    ++refusals_[Refusal::locked];
  } else if (refusing_module_ == decimater_.roles_.error_guard && is_refused_for_error_) {
    ++refusals_[Refusal::error];
  } else {
    decimater_.count_refusal(*refusing_module_);
  }
}

// Contractions --------------------------------------------------------------------------------------------------------

template <class MeshT>
bool MeshRunT<MeshT>::follow(const HostedContraction& made, const Contraction& contraction) {
  collapse(made);
  state_.vertices[made.survivor].position = made.position;
  ++n_contractions_;
  decimater_.is_fresh_ = false;
  const double cost = cost_->cost_of(contraction);
  if (decimater_.listener_) {
    Contraction by_handles = contraction;
    by_handles.cost = cost;
    by_handles.survivor = input_.numbers.handles[made.survivor];
    by_handles.removed = input_.numbers.handles[made.removed];
    decimater_.listener_(by_handles);
  }
  return decimater_.notify_observer(n_contractions_);
}

template <class MeshT>
void MeshRunT<MeshT>::collapse(const HostedContraction& made) {
  const HalfedgeHandle to_survivor = halfedge(made.removed, made.survivor);
  CollapseInfo info(mesh_, to_survivor);
  cost_->announce(made);
  decimater_.preprocess_collapse(info);
  carry_feature_bits(mesh_, info);
  mesh_.collapse(to_survivor);
  if (mesh_.has_face_normals()) {
    for (const OpenMesh::FaceHandle f : mesh_.vf_range(info.v1)) mesh_.set_normal(f, mesh_.calc_face_normal(f));
  }
  decimater_.postprocess_collapse(info);
  require_that_modules_followed(made);
}

/// Where a class derived from one of our modules doesn't call what it overrides, that module no longer knows the mesh.
template <class MeshT>
void MeshRunT<MeshT>::require_that_modules_followed(const HostedContraction& made) const {
  const auto require = [](bool has_followed, const Module& module) {
    if (has_followed) return;
    throw std::logic_error("PairDecimaterT: preprocess_collapse or postprocess_collapse of module " + module.name() +
                           " was overridden, and doesn't call the one of its base class");
  };
  if (decimater_.roles_.cost) {
    require(decimater_.roles_.cost->position(input_.handle(made.survivor)) == made.position,
            *decimater_.roles_.cost_module);
  }
  if (decimater_.roles_.error_guard) {
    require(decimater_.roles_.error_guard->n_followed() == n_followed_before_ + n_contractions_ + 1,
            *decimater_.roles_.error_guard);
  }
}

}  // namespace whittle
