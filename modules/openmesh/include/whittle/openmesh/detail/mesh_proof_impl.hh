#pragma once

#include <algorithm>
#include <utility>

#include "whittle/core/geometry/proof/border_edges.hh"
#include "whittle/openmesh/detail/mesh_proof.hh"

namespace whittle {

template <class MeshT>
MeshProofT<MeshT>::MeshProofT(const MeshT& mesh, const IndexedMesh& input, const Limits& limits)
    : mesh_(mesh),
      limits_(limits),
      n_faces_(mesh.n_faces()),
      is_cut_(find_cuts()),
      input_border_(border_edges_of(input).mesh),
      surface_(input, limits.surface) {
  std::vector<Vec3> positions;
  positions.reserve(mesh_.n_vertices());
  for (Index v = 0; v < mesh_.n_vertices(); ++v) {
    positions.push_back(to_vec3(mesh_.point(VertexHandle(static_cast<int>(v)))));
  }
  std::vector<Face> faces;
  for (const FaceHandle f : mesh_.faces()) faces.push_back(face_of(f));
  surface_.start(positions, faces);
  if (input_border_.faces.empty()) return;
  std::vector<Face> edges;
  for (const EdgeHandle e : mesh_.edges()) {
    if (is_border(e)) edges.push_back(face_of(e));
  }
  border_.emplace(input_border_, limits.border);
  border_->start(positions, edges);
}

template <class MeshT>
std::vector<bool> MeshProofT<MeshT>::find_cuts() const {
  if (first_copies(mesh_).empty()) return {};
  const detail::VertexNumbers numbers = detail::number_vertices(mesh_, Copies::joined);
  const auto pair_of = [](Index a, Index b) { return std::pair(std::min(a, b), std::max(a, b)); };
  std::vector<std::pair<Index, Index>> borders;
  for (const Triangle& edge : border_edges_of(detail::geometry_of(mesh_, numbers)).mesh.faces) {
    borders.push_back(pair_of(edge[0], edge[1]));
  }
  std::sort(borders.begin(), borders.end());
  std::vector<bool> is_cut(mesh_.n_edges());
  for (const EdgeHandle e : mesh_.edges()) {
    const auto [number, ends] = face_of(e);
    const auto joined = pair_of(numbers.number_of[ends[0]], numbers.number_of[ends[1]]);
    is_cut[number] = mesh_.is_boundary(e) && !std::binary_search(borders.begin(), borders.end(), joined);
  }
  return is_cut;
}

template <class MeshT>
typename MeshProofT<MeshT>::Face MeshProofT<MeshT>::face_of(FaceHandle f) const {
  const auto corners = face_corners(mesh_, f);
  return {index(f), {index(corners[0]), index(corners[1]), index(corners[2])}};
}

template <class MeshT>
typename MeshProofT<MeshT>::Face MeshProofT<MeshT>::face_of(EdgeHandle e) const {
  const Index to = index(mesh_.to_vertex_handle(mesh_.halfedge_handle(e, 0)));
  return {index(e), {index(mesh_.to_vertex_handle(mesh_.halfedge_handle(e, 1))), to, to}};
}

// Questions -----------------------------------------------------------------------------------------------------------

/// PairDecimaterT asks about both directions of a contraction: the answer is the same.
template <class MeshT>
bool MeshProofT<MeshT>::allows(const CollapseInfo& collapse, const Point& point) {
  const auto [first, second] = std::minmax(collapse.v0, collapse.v1);
  const Question question{first, second, point, n_made_};
  if (last_question_ == question) return last_answer_;
  last_question_ = question;
  last_answer_ = is_allowed(collapse, point);
  return last_answer_;
}

template <class MeshT>
bool MeshProofT<MeshT>::is_allowed(const CollapseInfo& collapse, const Point& point) {
  if (is_at_cut(collapse.v0) || (point != mesh_.point(collapse.v1) && is_at_cut(collapse.v1))) return false;
  if (border_ && !border_->allows(border_change(collapse, point))) return false;
  return surface_.allows(surface_change(collapse, point));
}

template <class MeshT>
bool MeshProofT<MeshT>::is_at_cut(VertexHandle v) const {
  if (is_cut_.empty()) return false;
  const auto edges = mesh_.ve_range(v);
  return std::any_of(edges.begin(), edges.end(), [this](EdgeHandle e) { return is_cut(e); });
}

/// If v1 doesn't move, its own faces stay as they are.
template <class MeshT>
typename MeshProofT<MeshT>::Change MeshProofT<MeshT>::surface_change(const CollapseInfo& collapse,
                                                                     const Point& point) const {
  Change change{index(collapse.v1), to_vec3(point)};
  const auto add = [&](VertexHandle v) {
    for (const FaceHandle f : mesh_.vf_range(v)) {
      Face face = face_of(f);
      if (v == collapse.v0 || (f != collapse.fl && f != collapse.fr)) change.removed.push_back(face.number);
      if (f == collapse.fl || f == collapse.fr) continue;
      std::replace(face.vertices.begin(), face.vertices.end(), index(collapse.v0), index(collapse.v1));
      change.added.push_back(face);
    }
  };
  add(collapse.v0);
  if (point != mesh_.point(collapse.v1)) add(collapse.v1);
  add_faces_around(collapse.v0, change.around);
  add_faces_around(collapse.v1, change.around);
  return change;
}

/// Lists the faces at neighbours, those at v among them. Some are listed several times.
template <class MeshT>
void MeshProofT<MeshT>::add_faces_around(VertexHandle v, std::vector<Index>& faces) const {
  for (const VertexHandle neighbour : mesh_.vv_range(v)) {
    for (const FaceHandle f : mesh_.vf_range(neighbour)) faces.push_back(index(f));
  }
}

/// Border edges don't keep their handles, so those of the new ones are not known yet.
template <class MeshT>
typename MeshProofT<MeshT>::Change MeshProofT<MeshT>::border_change(const CollapseInfo& collapse,
                                                                    const Point& point) const {
  Change change{index(collapse.v1), to_vec3(point)};
  change.removed = border_edges_at(collapse.v0);
  if (change.removed.empty() && point == mesh_.point(collapse.v1)) return {};
  const std::vector<Index> at_v1 = border_edges_at(collapse.v1);
  change.removed.insert(change.removed.end(), at_v1.begin(), at_v1.end());
  if (change.removed.empty()) return {};
  for (const VertexHandle end : border_ends(collapse)) {
    const OpenMesh::HalfedgeHandle h = mesh_.find_halfedge(collapse.v1, end);
    if (h.is_valid() && is_cut(mesh_.edge_handle(h))) continue;
    change.added.push_back({invalid_index, {index(collapse.v1), index(end), index(end)}});
    for (const Index e : border_edges_at(end)) change.around.push_back(e);
  }
  return change;
}

/// The vertices that one face will join with the merged vertex.
template <class MeshT>
std::vector<OpenMesh::VertexHandle> MeshProofT<MeshT>::border_ends(const CollapseInfo& collapse) const {
  std::vector<VertexHandle> corners;
  for (const VertexHandle v : {collapse.v0, collapse.v1}) {
    for (const FaceHandle f : mesh_.vf_range(v)) {
      if (f == collapse.fl || f == collapse.fr) continue;
      for (const VertexHandle corner : face_corners(mesh_, f)) {
        if (corner != v) corners.push_back(corner);
      }
    }
  }
  std::sort(corners.begin(), corners.end());
  std::vector<VertexHandle> ends;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool is_first = i == 0 || corners[i - 1] != corners[i];
    const bool is_last = i + 1 == corners.size() || corners[i + 1] != corners[i];
    if (is_first && is_last) ends.push_back(corners[i]);
  }
  return ends;
}

template <class MeshT>
std::vector<Index> MeshProofT<MeshT>::faces_at(VertexHandle v) const {
  std::vector<Index> faces;
  for (const FaceHandle f : mesh_.vf_range(v)) faces.push_back(index(f));
  return faces;
}

template <class MeshT>
std::vector<Index> MeshProofT<MeshT>::border_edges_at(VertexHandle v) const {
  std::vector<Index> edges;
  for (const EdgeHandle e : mesh_.ve_range(v)) {
    if (is_border(e)) edges.push_back(index(e));
  }
  return edges;
}

// Collapses -----------------------------------------------------------------------------------------------------------

template <class MeshT>
void MeshProofT<MeshT>::note_before(const CollapseInfo& collapse) {
  before_.p1 = mesh_.point(collapse.v1);
  before_.faces_at_v0 = faces_at(collapse.v0);
  before_.faces_at_v1 = faces_at(collapse.v1);
  before_.border_edges_at_v0 = border_edges_at(collapse.v0);
  before_.border_edges_at_v1 = border_edges_at(collapse.v1);
  before_.is_v0_at_cut = is_at_cut(collapse.v0);
  before_.is_v1_at_cut = is_at_cut(collapse.v1);
}

template <class MeshT>
void MeshProofT<MeshT>::note_after(const CollapseInfo& collapse) {
  ++n_made_;
  const bool v1_moved = mesh_.point(collapse.v1) != before_.p1;
  is_cut_open_ |= before_.is_v0_at_cut || (v1_moved && before_.is_v1_at_cut);
  surface_.make(surface_change_made(collapse.v1, v1_moved));
  if (border_ && (v1_moved || !before_.border_edges_at_v0.empty())) border_->make(border_change_made(collapse.v1));
}

template <class MeshT>
typename MeshProofT<MeshT>::Change MeshProofT<MeshT>::surface_change_made(VertexHandle v1, bool v1_moved) const {
  Change change{index(v1), to_vec3(mesh_.point(v1)), before_.faces_at_v0};
  for (const Index number : before_.faces_at_v1) {
    const bool is_common = std::find(change.removed.begin(), change.removed.end(), number) != change.removed.end();
    if (v1_moved && !is_common) change.removed.push_back(number);
  }
  for (const Index number : change.removed) {
    const FaceHandle f(static_cast<int>(number));
    if (!mesh_.status(f).deleted()) change.added.push_back(face_of(f));
  }
  add_faces_around(v1, change.around);
  return change;
}

template <class MeshT>
typename MeshProofT<MeshT>::Change MeshProofT<MeshT>::border_change_made(VertexHandle v1) const {
  Change change{index(v1), to_vec3(mesh_.point(v1)), before_.border_edges_at_v0};
  change.removed.insert(change.removed.end(), before_.border_edges_at_v1.begin(), before_.border_edges_at_v1.end());
  for (const Index number : border_edges_at(v1)) {
    const Face edge = face_of(EdgeHandle(static_cast<int>(number)));
    change.added.push_back(edge);
    const Index end = edge.vertices[0] == index(v1) ? edge.vertices[1] : edge.vertices[0];
    for (const Index e : border_edges_at(VertexHandle(static_cast<int>(end)))) {
      if (e != number) change.around.push_back(e);
    }
  }
  return change;
}

}  // namespace whittle
