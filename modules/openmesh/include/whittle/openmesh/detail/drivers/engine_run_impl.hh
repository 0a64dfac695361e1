#pragma once

#include <algorithm>

#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/engine/attributes.hh"
#include "whittle/openmesh/detail/drivers/engine_run.hh"
#include "whittle/openmesh/pair_cost_module.hh"

namespace whittle {

template <class MeshT>
EngineRunT<MeshT>::EngineRunT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target, bool only_selected)
    : decimater_(decimater),
      mesh_(decimater.mesh()),
      target_(target),
      input_(mesh_, Copies::joined,
             [&decimater, only_selected](VertexHandle v) { return decimater.is_fixed(v, only_selected); }),
      state_(state_of_module()),
      attributes_(mesh_) {}

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
  options.progress = [this, n_vertices = count_vertices(input_.mesh)](const Progress& progress) {
    return notify_observer(n_vertices - std::min(n_vertices, progress.n_vertices));
  };
  Decimation small = whittle::decimate(input_.mesh, target_before_rounding(), options);
  if (small.result.proven_error) small.result.proven_error = target_.error_limit();
  return small;
}

/// The limits less what rounding to the scalar of the mesh may add: what moves each vertex by d at most, moves each
/// point of the surface by d at most.
template <class MeshT>
DecimateTarget EngineRunT<MeshT>::target_before_rounding() const {
  using Scalar = typename OpenMesh::vector_traits<typename MeshT::Point>::value_type;
  const double surface = *target_.error_limit();
  const double border = *target_.border_error_limit();
  double farthest = surface;  // a vertex may move outwards
  for (const Vec3& p : input_.mesh.positions) farthest = std::max(farthest, p.cwiseAbs().maxCoeff() + surface);
  // Each of three coordinates is rounded by half of epsilon at most: √3 / 2 in all.
  const double rounding = farthest * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
  const auto is_too_small = [rounding](double limit) { return limit > 0 && limit <= rounding; };
  if (is_too_small(surface) || is_too_small(border)) {
    throw std::invalid_argument("PairDecimaterT: max_error is less than rounding may move a vertex of the mesh");
  }
  return target_.or_max_error(surface - rounding, border - rounding);
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

/// Counts vertices with a face.
template <class MeshT>
std::uint64_t EngineRunT<MeshT>::count_vertices(const IndexedMesh& mesh) {
  std::vector<bool> has_face(mesh.positions.size());
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) has_face[v] = true;
  }
  return static_cast<std::uint64_t>(std::count(has_face.begin(), has_face.end(), true));
}

// The mesh ------------------------------------------------------------------------------------------------------------

template <class MeshT>
void EngineRunT<MeshT>::write_back(Decimation& small) {
  const bool were_collapses = are_collapses(small);
  const IndexedMesh attributes = vertex_attributes_of(small);
  const std::vector<Copy> vertices = were_collapses ? collapse(small) : relink(small);
  for (const auto& [vertex, handle] : vertices) {
    attributes_.set(attributes, vertex, mesh_, handle);
    const Vec3& position = small.mesh.positions[vertex];
    if (position == to_vec3(mesh_.point(handle))) continue;  // don't round a vertex that hasn't moved
    mesh_.set_point(handle, to_point<typename MeshT::Point>(position));
  }
  std::vector<Index> vertex_of(mesh_.n_vertices(), invalid_index);
  for (const auto& [vertex, handle] : vertices) vertex_of[static_cast<std::size_t>(handle.idx())] = vertex;
  input_.write_corners(small, vertex_of, decimater_.threads_, mesh_);
  if (mesh_.has_face_normals()) update_face_normals(vertices, small.mesh.origins);
  hand_over_quadrics(vertices, std::move(small.quadrics), were_collapses);
}

/// What vertices carry, at the places where they are now. Without anything, an empty mesh.
template <class MeshT>
IndexedMesh EngineRunT<MeshT>::vertex_attributes_of(const Decimation& small) const {
  IndexedMesh before;
  IndexedMesh after;
  if (attributes_.empty()) return after;
  before.positions = input_.mesh.positions;
  before.faces = input_.mesh.faces;
  attributes_.add_to(before, mesh_, input_.numbers.handles);
  after.positions = small.mesh.positions;
  after.faces = small.mesh.faces;
  carry_attributes(before, Frame::of_points(before.positions), Normals::keep, small.vertex_map, small.face_origins,
                   after, decimater_.threads_);
  return after;
}

/// Whether the contractions are legal collapses on the mesh as it is. Without threshold pairs and copies they are, with
/// one exception: vertices with several open fans, which OpenMesh can hold. There the engine may also join two border
/// edges or part a fan. Joining increases the Euler number, and never the number of fans. Parting keeps the Euler
/// number and adds a fan. So both are noticed.
template <class MeshT>
bool EngineRunT<MeshT>::are_collapses(const Decimation& small) const {
  if (small.result.threshold_pairs.contracted > 0 || small.result.n_coincident_faces > 0) return false;
  if (!first_copies(mesh_).empty()) return false;
  if (small.result.before.nonmanifold_vertices == 0) return true;
  return shape_of(input_.mesh) == shape_of(small.mesh);
}

template <class MeshT>
typename EngineRunT<MeshT>::Shape EngineRunT<MeshT>::shape_of(const IndexedMesh& mesh) {
  const auto n_edges = static_cast<std::ptrdiff_t>(detail::EdgeTable(mesh.faces, mesh.positions.size()).size());
  const auto n_vertices = static_cast<std::ptrdiff_t>(count_vertices(mesh));
  const std::size_t n_further_fans = cut_into_manifold(mesh.positions.size(), mesh.faces).originals.size();
  return {n_further_fans, n_vertices - n_edges + static_cast<std::ptrdiff_t>(mesh.faces.size())};
}

template <class MeshT>
std::vector<typename EngineRunT<MeshT>::Copy> EngineRunT<MeshT>::collapse(const Decimation& small) {
  BulkCollapseT<MeshT>(mesh_, merges_).run();
  std::vector<Copy> vertices;
  vertices.reserve(small.mesh.origins.size());
  for (Index v = 0; v < small.mesh.origins.size(); ++v) {
    vertices.push_back({v, VertexHandle(static_cast<int>(small.mesh.origins[v]))});
  }
  return vertices;
}

template <class MeshT>
std::vector<typename EngineRunT<MeshT>::Copy> EngineRunT<MeshT>::relink(const Decimation& small) {
  JoinedFaces joined;
  joined.vertex_handles = small.mesh.origins;
  joined.faces = small.mesh.faces;
  joined.vertex_of.assign(mesh_.n_vertices(), invalid_index);
  for (const VertexHandle v : mesh_.vertices()) {
    const auto place = static_cast<std::size_t>(v.idx());
    if (!mesh_.is_isolated(v)) joined.vertex_of[place] = small.vertex_map[input_.numbers.number_of[place]];
  }
  std::vector<Index> face_handles;
  for (const OpenMesh::FaceHandle f : mesh_.faces()) face_handles.push_back(static_cast<Index>(f.idx()));
  for (const Index f : small.face_origins) joined.face_handles.push_back(face_handles[f]);
  return FaceRelinkerT<MeshT>(mesh_, joined).run();
}

/// Updates the normals of faces at merged vertices. \param origins handles of the vertices' first copies
template <class MeshT>
void EngineRunT<MeshT>::update_face_normals(const std::vector<Copy>& vertices, const std::vector<Index>& origins) {
  std::vector<bool> is_merged(mesh_.n_vertices());
  for (const VertexMerge& merge : merges_) is_merged[static_cast<std::size_t>(merge.survivor.idx())] = true;
  for (const auto& [vertex, handle] : vertices) {
    is_merged[static_cast<std::size_t>(handle.idx())] = is_merged[origins[vertex]];
  }
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
