#pragma once

#include <algorithm>

#include "whittle/openmesh/mod_lindstrom_turk.hh"

namespace whittle {

template <class MeshT>
PairEvaluation ModLindstromTurkT<MeshT>::evaluate_plain(VertexHandle first, VertexHandle second,
                                                        PairConstraint constraint) const {
  std::vector<BorderEdge> border;
  add_border_at(first, VertexHandle(), border);
  add_border_at(second, first, border);
  return evaluate_lindstrom_turk(star_of(first), star_of(second), common_faces(first, second), border, constraint);
}

template <class MeshT>
std::vector<CommonFace> ModLindstromTurkT<MeshT>::common_faces(VertexHandle first, VertexHandle second) const {
  const MeshT& mesh = surface();
  const HalfedgeHandle h = mesh.find_halfedge(first, second);
  std::vector<CommonFace> faces;
  for (const auto& [side, turn] : {std::pair(h, 1), std::pair(mesh.opposite_halfedge_handle(h), -1)}) {
    if (mesh.is_boundary(side)) continue;
    const VertexHandle third = mesh.to_vertex_handle(mesh.next_halfedge_handle(side));
    faces.push_back({static_cast<Index>(third.idx()), this->position(third), turn});
  }
  if (faces.size() == 2 && faces[1].vertex < faces[0].vertex) std::swap(faces[0], faces[1]);
  return faces;
}

template <class MeshT>
std::vector<typename ModLindstromTurkT<MeshT>::OtherCorners> ModLindstromTurkT<MeshT>::faces_at(VertexHandle v) const {
  const MeshT& mesh = surface();
  std::vector<OtherCorners> faces;
  for (const HalfedgeHandle h : mesh.voh_ccw_range(v)) {
    if (mesh.is_boundary(h)) continue;
    faces.emplace_back(mesh.to_vertex_handle(h), mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
  }
  if (mesh.is_boundary(v)) {
    std::sort(faces.begin(), faces.end());
  } else {
    std::rotate(faces.begin(), std::min_element(faces.begin(), faces.end()), faces.end());
  }
  return faces;
}

template <class MeshT>
StarSums ModLindstromTurkT<MeshT>::star_of(VertexHandle v) const {
  std::vector<LinkEdgePoints> faces;
  std::vector<Vec3> neighbours;
  const bool is_ring = !surface().is_boundary(v);
  for (const auto& [x, y] : faces_at(v)) {
    faces.push_back({this->position(x), this->position(y)});
    if (is_ring) neighbours.push_back(this->position(y));
  }
  if (!is_ring) {
    std::vector<VertexHandle> vertices;
    for (const VertexHandle w : surface().vv_range(v)) vertices.push_back(w);
    std::sort(vertices.begin(), vertices.end());
    for (const VertexHandle w : vertices) neighbours.push_back(this->position(w));
  }
  return sum_star(this->position(v), faces, neighbours);
}

/// Adds the border edges at v, except the one to `but`.
template <class MeshT>
void ModLindstromTurkT<MeshT>::add_border_at(VertexHandle v, VertexHandle but, std::vector<BorderEdge>& border) const {
  const MeshT& mesh = surface();
  if (!mesh.is_boundary(v)) return;
  std::vector<std::pair<VertexHandle, bool>> ends;  // and whether the face leaves v along the edge
  for (const HalfedgeHandle h : mesh.voh_range(v)) {
    const VertexHandle w = mesh.to_vertex_handle(h);
    if (mesh.is_boundary(mesh.edge_handle(h)) && w != but) ends.emplace_back(w, !mesh.is_boundary(h));
  }
  std::sort(ends.begin(), ends.end());
  const Vec3 here = this->position(v);
  for (const auto& [w, leaves] : ends) {
    const Vec3 there = this->position(w);
    border.push_back(leaves ? BorderEdge{here, there} : BorderEdge{there, here});
  }
}

}  // namespace whittle
