#pragma once

#include <algorithm>

#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <cstdint>
#include <limits>
#include <utility>

#include "whittle/openmesh/detail/drivers/engine_run.hh"
#include "whittle/openmesh/pair_cost_module.hh"

namespace whittle {

template <class MeshT>
EngineRunT<MeshT>::EngineRunT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target, bool only_selected)
    : EngineRun(decimater.mesh(), target,
                [&decimater, only_selected](VertexHandle v) { return decimater.is_fixed(v, only_selected); }),
      decimater_(decimater),
      mesh_(decimater.mesh()),
      state_(state_of_module()) {}

template <class MeshT>
DecimateResult EngineRunT<MeshT>::run() {
  Decimation small = contract();
  write_back(small);
  if (small.result.n_contractions > 0) decimater_.is_fresh_ = false;
  return small.result;
}

// The engine ----------------------------------------------------------------------------------------------------------

/// After contractions the module knows more than the mesh: unrounded positions, and accumulated quadrics.
template <class MeshT>
std::optional<DecimationState> EngineRunT<MeshT>::state_of_module() const {
  if (decimater_.is_fresh_) return std::nullopt;
  DecimationState state;
  state.frame = decimater_.roles_.cost->frame();
  state.face_area = decimater_.roles_.cost->face_area();
  for (Index v = 0; v < input_.mesh.positions.size(); ++v) {
    state.vertices.push_back(decimater_.roles_.cost->quadric(input_.handle(v)));
  }
  return state;
}

template <class MeshT>
Decimation EngineRunT<MeshT>::contract() {
  DecimateOptions options = decimater_.engine_options_but_cost();
  const CostOptions cost = *decimater_.roles_.cost->engine_options();
  options.cost = cost.cost;
  options.quadric = cost.quadric;
  options.isotropy = cost.isotropy;
  options.valence_weight = cost.valence_weight;
  options.locked = input_.locked;
  options.feature_edges = input_.features;
  options.keep_quadrics = true;
  if (target_.error_limit()) return contract_within_error(std::move(options));
  return whittle::decimate(input_.mesh, target_, options, *this);
}

/// The engine tells its listener at the end, in order.
template <class MeshT>
Decimation EngineRunT<MeshT>::contract_within_error(DecimateOptions options) {
  options.listener = [this](const Contraction& made) { note(made); };
  options.progress = [this, n_vertices = n_vertices_of_input()](const Progress& progress) {
    return notify_observer(n_vertices - std::min(n_vertices, progress.n_vertices));
  };
  using Scalar = typename OpenMesh::vector_traits<typename MeshT::Point>::value_type;
  const DecimateTarget target = target_before_rounding(double{std::numeric_limits<Scalar>::epsilon()});
  Decimation small = whittle::decimate(input_.mesh, target, options);
  if (small.result.proven_error) small.result.proven_error = target_.error_limit();
  return small;
}

/// Progress comes at numbers of its own.
template <class MeshT>
bool EngineRunT<MeshT>::notify_observer(std::uint64_t n_contractions) {
  OpenMesh::Decimater::Observer* const observer = decimater_.observer();
  if (observer == nullptr) return true;
  const std::uint64_t before = std::exchange(n_notified_, n_contractions);
  if (before / observer->get_interval() == n_contractions / observer->get_interval()) return true;
  observer->notify(n_contractions);
  return !observer->abort();
}

template <class MeshT>
bool EngineRunT<MeshT>::follow(const HostedContraction&, const Contraction& contraction) {
  note(contraction);
  return decimater_.notify_observer(merges_.size());
}

template <class MeshT>
void EngineRunT<MeshT>::note(const Contraction& contraction) {
  merges_.push_back({input_.handle(contraction.removed), input_.handle(contraction.survivor)});
  if (!decimater_.listener_) return;
  Contraction by_handles = contraction;
  by_handles.survivor = input_.numbers.handles[contraction.survivor];
  by_handles.removed = input_.numbers.handles[contraction.removed];
  decimater_.listener_(by_handles);
}

// The mesh ------------------------------------------------------------------------------------------------------------

template <class MeshT>
void EngineRunT<MeshT>::write_back(Decimation& small) {
  const std::vector<Index> firsts = first_copies(mesh_);
  const bool were_collapses = are_collapses(small, firsts);
  const IndexedMesh attributes = vertex_attributes_of(small, decimater_.threads_);
  const std::vector<Copy> vertices = were_collapses ? collapse(small) : relink(small, firsts);
  for (const auto& [vertex, handle] : vertices) {
    attributes_.set(attributes, vertex, mesh_, handle);
    const Vec3& position = small.mesh.positions[vertex];
    if (position == to_vec3(mesh_.point(handle))) continue;  // don't round a vertex that hasn't moved
    mesh_.set_point(handle, to_point<typename MeshT::Point>(position));
  }
  input_.write_corners(small, vertices_by_handle(vertices), decimater_.threads_, mesh_);
  if (mesh_.has_face_normals()) update_face_normals(merged_vertices(vertices, small.mesh.origins));
  hand_over_quadrics(vertices, std::move(small.quadrics), were_collapses);
}

/// Updates the normals of faces at merged vertices.
template <class MeshT>
void EngineRunT<MeshT>::update_face_normals(const std::vector<bool>& is_merged) {
  for (const OpenMesh::FaceHandle f : mesh_.faces()) {
    const auto corners = face_corners(mesh_, f);
    const auto at_merged = [&](VertexHandle v) { return is_merged[static_cast<std::size_t>(v.idx())]; };
    if (std::any_of(corners.begin(), corners.end(), at_merged)) mesh_.set_normal(f, mesh_.calc_face_normal(f));
  }
}

/// Hands the quadrics over to the module. Each copy gets the whole quadric of its vertex.
template <class MeshT>
void EngineRunT<MeshT>::hand_over_quadrics(const std::vector<Copy>& vertices, std::vector<PlacedQuadric> quadrics,
                                           bool were_collapses) {
  std::vector<Index> handles;
  handles.reserve(vertices.size());
  for (const Copy& copy : vertices) handles.push_back(static_cast<Index>(copy.handle.idx()));
  for (std::size_t i = quadrics.size(); i < vertices.size(); ++i) {
    const PlacedQuadric quadric = quadrics[vertices[i].vertex];
    quadrics.push_back(quadric);
  }
  decimater_.roles_.cost->adopt(handles, std::move(quadrics), were_collapses);
}

}  // namespace whittle
