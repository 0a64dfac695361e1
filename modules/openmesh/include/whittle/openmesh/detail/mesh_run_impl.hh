#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "whittle/openmesh/detail/feature_bits.hh"
#include "whittle/openmesh/detail/mesh_run.hh"
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
      state_(initial_state()) {}

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
bool MeshRunT<MeshT>::is_foreign() const {
  return decimater_.foreign_cost_ != nullptr;
}

/// Our cost modules have positions that are not rounded to the scalar of the mesh.
template <class MeshT>
DecimationState MeshRunT<MeshT>::initial_state() const {
  DecimationState state;
  state.frame = is_foreign() ? Frame::of_points(input_.mesh.positions) : decimater_.cost_->frame();
  for (Index v = 0; v < input_.mesh.positions.size(); ++v) {
    const Vec3 here =
        is_foreign() ? state.frame.to_frame(input_.mesh.positions[v]) : decimater_.cost_->position(input_.handle(v));
    state.vertices.push_back({here, {}});
  }
  return state;
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
  Decimation small = whittle::decimate(input_.mesh, target_, options(), *this);
  std::vector<Index> vertex_of(mesh_.n_vertices(), invalid_index);
  for (Index v = 0; v < small.mesh.origins.size(); ++v) vertex_of[small.mesh.origins[v]] = v;
  input_.write_corners(small, vertex_of, decimater_.threads_, mesh_);
  DecimateResult result = small.result;
  result.n_vertices = decimater_.count_elements().vertices;
  result.rejections.locked += rejections_.locked;
  result.rejections.link += rejections_.link;
  result.rejections.feature += rejections_.feature;
  result.rejections.error += rejections_.error;
  return result;
}

// The cost ------------------------------------------------------------------------------------------------------------

template <class MeshT>
PairEvaluation MeshRunT<MeshT>::rank(Index first, Index second, Pinned pinned) {
  if (!is_foreign()) return decimater_.cost_->evaluate(input_.handle(first), input_.handle(second), pinned);
  const Collapses collapses = legal_collapses(first, second, pinned);
  if (collapses.n == 0) {
    constexpr double never = std::numeric_limits<double>::infinity();
    return {never, never, position(first), false};
  }
  const auto& [priority, survivor] = collapses.legal[0];
  return {priority, priority, position(survivor), false};
}

/// The second choice of our costs is the position of least cost. That of a foreign cost is the collapse in the other
/// direction.
template <class MeshT>
Settlement MeshRunT<MeshT>::settle(Index first, Index second, Pinned pinned, const PairEvaluation& rank) {
  Settlement settlement;
  if (is_foreign()) {
    const Collapses collapses = legal_collapses(first, second, pinned);
    for (std::size_t i = 0; i < collapses.n; ++i) {
      const Index survivor = collapses.legal[i].survivor;
      settlement.add(position(survivor), survivor);
    }
    return settlement;
  }
  const Vec3 best = decimater_.cost_->place(input_.handle(first), input_.handle(second), rank);
  if (best != rank.position) settlement.add(best);
  settlement.add(rank.position);
  return settlement;
}

template <class MeshT>
double MeshRunT<MeshT>::final_cost(const HostedContraction& contraction) {
  const auto& [first, second, survivor, removed, before, rank, to] = contraction;
  if (!is_foreign()) {
    return decimater_.cost_->final_cost(input_.handle(first), input_.handle(second), rank, to);
  }
  const std::optional<Collapse> collapse = legal_collapse(removed, survivor);
  return collapse ? collapse->priority : rank.cost;
}

/// Foreign costs may look at whole stars.
template <class MeshT>
Reach MeshRunT<MeshT>::reach() const {
  return is_foreign() ? Reach::opposite_rings : decimater_.cost_->reach();
}

template <class MeshT>
bool MeshRunT<MeshT>::stays_at_vertices() const {
  if (is_foreign()) return false;
  const std::optional<CostOptions> options = decimater_.cost_->engine_options();
  if (!options || (options->cost != Cost::quadric && options->cost != Cost::memoryless)) return false;
  return options->quadric.placement == Placement::endpoint;
}

template <class MeshT>
double MeshRunT<MeshT>::dimension() const {
  return is_foreign() ? 0 : decimater_.cost_->cost_dimension();
}

template <class MeshT>
typename MeshRunT<MeshT>::Collapses MeshRunT<MeshT>::legal_collapses(Index first, Index second, Pinned pinned) {
  Collapses result;
  const auto add = [&](Index removed, Index survivor) {
    if (const std::optional<Collapse> collapse = legal_collapse(removed, survivor))
      result.legal[result.n++] = *collapse;
  };
  const auto count_pinned = [this](Index removed) {
    ++(is_fixed(input_.handle(removed)) ? rejections_.locked : rejections_.feature);
  };
  pinned != Pinned::second ? add(second, first) : count_pinned(second);
  pinned != Pinned::first ? add(first, second) : count_pinned(first);
  if (result.n == 2 && result.legal[1].priority < result.legal[0].priority) {
    std::swap(result.legal[0], result.legal[1]);
  }
  return result;
}

/// OpenMesh's modules are written for collapses that its decimaters call legal: v1 keeps its position, and a border
/// vertex stays on the border. So they are asked about legal collapses only.
template <class MeshT>
std::optional<typename MeshRunT<MeshT>::Collapse> MeshRunT<MeshT>::legal_collapse(Index removed, Index survivor) {
  const CollapseInfo info(mesh_, halfedge(removed, survivor));
  if (is_fixed(info.v0)) {
    ++rejections_.locked;
    return std::nullopt;
  }
  if (!decimater_.is_collapse_legal(info)) {
    ++rejections_.link;
    return std::nullopt;
  }
  const float priority = decimater_.foreign_cost_->collapse_priority(info);
  if (priority >= 0) return Collapse{priority, survivor};
  decimater_.count_rejection(*decimater_.foreign_cost_);
  return std::nullopt;
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
  if (decimater_.asked_guards_.empty()) return false;
  CollapseInfo forward = info;
  CollapseInfo backward(mesh_, info.v1v0);
  if (v1_moves) forward.p1 = backward.p1 = to_point<typename MeshT::Point>(state_.frame.to_model(contraction.position));
  for (Module* module : decimater_.asked_guards_) {
    if (module->collapse_priority(forward) >= 0 && (!v1_moves || module->collapse_priority(backward) >= 0)) continue;
    refusing_module_ = module;
    return true;
  }
  return false;
}

template <class MeshT>
void MeshRunT<MeshT>::count_refusal() {
  if (refusing_module_ == nullptr) {
    ++rejections_.locked;
  } else if (refusing_module_ == decimater_.error_guard_) {
    ++rejections_.error;
  } else {
    decimater_.count_rejection(*refusing_module_);
  }
}

// Contractions --------------------------------------------------------------------------------------------------------

template <class MeshT>
bool MeshRunT<MeshT>::follow(const HostedContraction& made, const Contraction& contraction) {
  collapse(made);
  state_.vertices[made.survivor].position = made.position;
  ++n_contractions_;
  decimater_.is_fresh_ = false;
  if (decimater_.listener_) {
    Contraction by_handles = contraction;
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
  if (!is_foreign()) decimater_.cost_->place_next(made.rank, made.position, input_.handle(made.first));
  decimater_.preprocess_collapse(info);
  carry_feature_bits(mesh_, info);
  mesh_.collapse(to_survivor);
  if (mesh_.has_face_normals()) {
    for (const OpenMesh::FaceHandle f : mesh_.vf_range(info.v1)) mesh_.set_normal(f, mesh_.calc_face_normal(f));
  }
  decimater_.postprocess_collapse(info);
}

}  // namespace whittle
