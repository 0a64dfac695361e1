#pragma once

#include <algorithm>
#include <utility>

#include "whittle/openmesh/engine_run.hh"
#include "whittle/openmesh/pair_decimater.hh"

namespace whittle {

template <class MeshT>
EngineRunT<MeshT>::EngineRunT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target, bool only_selected)
    : decimater_(decimater),
      mesh_(decimater.mesh()),
      target_(target),
      numbers_(detail::number_vertices(mesh_, Copies::joined)),
      input_(detail::geometry_of(mesh_, numbers_)),
      features_(find_features()),
      locked_(fixed_vertices(only_selected)) {}

template <class MeshT>
DecimateResult EngineRunT<MeshT>::run() {
  Decimation small = contract();
  write_back(small);
  return small.result;
}

/// The edges with the feature bit, ascending. Between copies of two vertices there may be several.
template <class MeshT>
std::vector<VertexPair> EngineRunT<MeshT>::find_features() const {
  std::vector<VertexPair> result;
  const StatusBitsT<OpenMesh::EdgeHandle, MeshT> bits(mesh_);
  for (int i = 0; i < static_cast<int>(mesh_.n_edges()); ++i) {
    const OpenMesh::EdgeHandle e(i);
    if (bits[e].deleted() || !bits[e].feature()) continue;
    const auto [low, high] = std::minmax({number(mesh_.to_vertex_handle(mesh_.halfedge_handle(e, 0))),
                                          number(mesh_.to_vertex_handle(mesh_.halfedge_handle(e, 1)))});
    result.push_back({low, high});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// As the engine wants to have it: empty if there are none. A vertex is fixed if any of its copies is; those with the
/// feature bit are unless they lie on a line of feature edges.
template <class MeshT>
std::vector<std::uint8_t> EngineRunT<MeshT>::fixed_vertices(bool only_selected) const {
  std::vector<Index> n_features(input_.positions.size());
  for (const auto& [a, b] : features_) {
    ++n_features[a];
    ++n_features[b];
  }
  std::vector<std::uint8_t> result(input_.positions.size());
  bool any = false;
  for (const VertexHandle v : mesh_.vertices()) {
    const bool is_point = mesh_.status(v).feature() && n_features[number(v)] != 2;
    if (!is_point && !decimater_.is_fixed(v, only_selected)) continue;
    result[number(v)] = 1;
    any = true;
  }
  if (!any) result.clear();
  return result;
}

// The engine ----------------------------------------------------------------------------------------------------------

template <class MeshT>
Decimation EngineRunT<MeshT>::contract() {
  bool is_aborted = false;
  DecimateOptions options;
  const CostOptions cost = *decimater_.cost_->engine_options();
  options.cost = cost.cost;
  options.quadric = cost.quadric;
  options.isotropy = cost.isotropy;
  options.valence_weight = cost.valence_weight;
  options.order = Order::exact;  // as the mesh driver has it
  options.pairs = decimater_.pairs_;
  options.max_normal_flip_deg = decimater_.max_normal_flip_deg();
  options.min_radius_ratio = decimater_.min_radius_ratio();
  options.locked = locked_;
  options.feature_edges = features_;
  options.feature_tolerance = decimater_.feature_tolerance_;
  options.threads = decimater_.threads_;
  options.keep_quadrics = true;
  options.progress = [&is_aborted](const Progress&) { return !is_aborted; };
  options.listener = [&](const Contraction& made) {
    if (is_aborted) return;
    merges_.push_back({handle(made.removed), handle(made.survivor)});
    if (decimater_.listener_) {
      decimater_.listener_({handle_index(made.survivor), handle_index(made.removed), made.position, made.cost});
    }
    is_aborted = !decimater_.notify_observer(merges_.size());
  };
  Decimation small = whittle::decimate(input_, target_, options);
  if (!is_aborted) return small;
  if (merges_.size() < small.result.n_contractions) small = contract_again(options);
  small.result.stop = StopReason::cancelled;
  return small;
}

/// Up to the abort: the engine asks now and then only. A contraction takes one vertex at least; a few take more, as
/// faces that coincide vanish, so how many are left after so many contractions has to be found out.
template <class MeshT>
Decimation EngineRunT<MeshT>::contract_again(DecimateOptions options) const {
  options.progress = nullptr;
  options.listener = nullptr;
  DecimateTarget target = DecimateTarget::vertices(count_vertices(input_) - merges_.size());
  while (true) {
    Decimation small = whittle::decimate(input_, target, options);
    const std::uint64_t n_missing = merges_.size() - small.result.n_contractions;
    if (n_missing == 0) return small;
    target = DecimateTarget::vertices(small.result.n_vertices - n_missing);
  }
}

/// Those with a face.
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
  const std::vector<Copy> vertices = were_collapses ? collapse(small) : relink(small);
  for (const auto& [vertex, handle] : vertices) {
    const Vec3& position = small.mesh.positions[vertex];
    if (position == to_vec3(mesh_.point(handle))) continue;  // not rounded for nothing
    mesh_.set_point(handle, to_point<typename MeshT::Point>(position));
  }
  if (mesh_.has_face_normals()) update_face_normals(vertices, small.mesh.origins);
  hand_over_quadrics(vertices, std::move(small.quadrics), were_collapses);
}

/// Whether the contractions are legal collapses on the mesh as it is. Without threshold pairs and copies they are, but
/// where vertices have several open fans, which OpenMesh holds: there the engine may also lay two border edges together
/// or tear a fan apart. The first makes the Euler number greater, and fans never more; the second leaves the Euler
/// number alone and makes one fan more. So neither goes unnoticed.
template <class MeshT>
bool EngineRunT<MeshT>::are_collapses(const Decimation& small) const {
  if (small.result.threshold_pairs.contracted > 0 || small.result.n_coincident_faces > 0) return false;
  if (!first_copies(mesh_).empty()) return false;
  if (small.result.before.nonmanifold_vertices == 0) return true;
  return shape_of(input_) == shape_of(small.mesh);
}

template <class MeshT>
typename EngineRunT<MeshT>::Shape EngineRunT<MeshT>::shape_of(const IndexedMesh& mesh) {
  std::vector<std::pair<Index, Index>> edges;
  edges.reserve(3 * mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces)
    edges.insert(edges.end(), {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)});
  std::sort(edges.begin(), edges.end());
  const auto n_edges = std::unique(edges.begin(), edges.end()) - edges.begin();
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
    if (!mesh_.is_isolated(v)) joined.vertex_of[place] = small.vertex_map[numbers_.number_of[place]];
  }
  std::vector<Index> face_handles;
  for (const OpenMesh::FaceHandle f : mesh_.faces()) face_handles.push_back(static_cast<Index>(f.idx()));
  for (const Index f : small.face_origins) joined.face_handles.push_back(face_handles[f]);
  return FaceRelinkerT<MeshT>(mesh_, joined).run();
}

/// Those of faces at merged vertices. \param origins first copies of the vertices
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

/// To the module: each copy has the whole of its vertex.
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
  decimater_.cost_->adopt(handles, std::move(quadrics), were_collapses);
}

}  // namespace whittle
