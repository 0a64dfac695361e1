#pragma once

#include <algorithm>
#include <array>

#include "whittle/openmesh/mod_lindstrom_turk.hh"

namespace whittle {

/// About the first vertex.
template <class MeshT>
PairEvaluation ModLindstromTurkT<MeshT>::evaluate_plain(VertexHandle first, VertexHandle second, Pinned pinned) const {
  const Vec3 origin = this->position(first);
  LindstromTurk term(volume_of(first, second), border_of(first, second), Vec3::Zero(), this->position(second) - origin);
  if (!term.is_determined()) term.add_neighbours(neighbours_of(first, second));
  return in_frame(term.evaluate(pinned), origin, this->position(second));
}

/// Those of both vertices without the faces that both have. Of the planes of the second vertex's faces, those of these
/// pass through the origin, too.
template <class MeshT>
VolumeSums ModLindstromTurkT<MeshT>::volume_of(VertexHandle first, VertexHandle second) const {
  const Vec3 origin = this->position(first);
  const Vec3 d = this->position(second) - origin;
  VolumeSums sums = volume_at(first);
  sums += volume_at(second).about(-d);
  for (const auto& [c, turn] : common_faces(first, second)) {
    if (c.is_valid()) sums.remove(turn * d.cross(this->position(c) - origin));
  }
  return sums;
}

template <class MeshT>
std::array<typename ModLindstromTurkT<MeshT>::Third, 2> ModLindstromTurkT<MeshT>::common_faces(
    VertexHandle first, VertexHandle second) const {
  const MeshT& mesh = surface();
  const auto third = [&mesh](HalfedgeHandle side) {
    return mesh.is_boundary(side) ? VertexHandle() : mesh.to_vertex_handle(mesh.next_halfedge_handle(side));
  };
  const HalfedgeHandle h = mesh.find_halfedge(first, second);
  std::array<Third, 2> thirds = {{{third(h), 1}, {third(mesh.opposite_halfedge_handle(h)), -1}}};
  if (thirds[1].first < thirds[0].first) std::swap(thirds[0], thirds[1]);
  return thirds;
}

/// Over the faces at a vertex, about it. There their planes have no offset.
template <class MeshT>
VolumeSums ModLindstromTurkT<MeshT>::volume_at(VertexHandle v) const {
  VolumeSums sums;
  const Vec3 p = this->position(v);
  for (const auto& [x, y] : faces_at(v)) {
    const Vec3 normal = (this->position(x) - p).cross(this->position(y) - p);
    sums.normal += normal;
    sums.squares.a += SymmetricMatrix::outer(normal, 1);
  }
  return sums;
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
BorderSums ModLindstromTurkT<MeshT>::border_of(VertexHandle first, VertexHandle second) const {
  BorderSums sums;
  const Vec3 origin = this->position(first);
  add_border_at(first, VertexHandle(), origin, sums);
  add_border_at(second, first, origin, sums);
  return sums;
}

/// The border edges at v, but for the one to `but`, each as its face has it.
template <class MeshT>
void ModLindstromTurkT<MeshT>::add_border_at(VertexHandle v, VertexHandle but, const Vec3& origin,
                                             BorderSums& sums) const {
  const MeshT& mesh = surface();
  if (!mesh.is_boundary(v)) return;
  std::vector<std::pair<VertexHandle, bool>> ends;  // and whether the face leaves v along the edge
  for (const HalfedgeHandle h : mesh.voh_range(v)) {
    const VertexHandle w = mesh.to_vertex_handle(h);
    if (mesh.is_boundary(mesh.edge_handle(h)) && w != but) ends.emplace_back(w, !mesh.is_boundary(h));
  }
  std::sort(ends.begin(), ends.end());
  const Vec3 here = this->position(v) - origin;
  for (const auto& [w, leaves] : ends) {
    const Vec3 there = this->position(w) - origin;
    leaves ? sums.add(here, there) : sums.add(there, here);
  }
}

template <class MeshT>
NeighbourSums ModLindstromTurkT<MeshT>::neighbours_of(VertexHandle first, VertexHandle second) const {
  const Vec3 origin = this->position(first);
  const Vec3 d = this->position(second) - origin;
  NeighbourSums sums = neighbours_at(first);
  sums += neighbours_at(second).about(-d);
  sums.remove(d);
  sums.remove(Vec3::Zero());
  const std::array<Third, 2> thirds = common_faces(first, second);
  for (const auto& [c, turn] : thirds) {
    const bool is_twice = c == thirds[0].first && turn != thirds[0].second;
    if (c.is_valid() && !is_twice) sums.remove(this->position(c) - origin);
  }
  return sums;
}

/// About it.
template <class MeshT>
NeighbourSums ModLindstromTurkT<MeshT>::neighbours_at(VertexHandle v) const {
  std::vector<VertexHandle> neighbours;
  if (surface().is_boundary(v)) {
    for (const VertexHandle w : surface().vv_range(v)) neighbours.push_back(w);
    std::sort(neighbours.begin(), neighbours.end());
  } else {
    for (const auto& [x, y] : faces_at(v)) neighbours.push_back(y);
  }
  NeighbourSums sums;
  for (const VertexHandle w : neighbours) sums.add(this->position(w) - this->position(v));
  return sums;
}

}  // namespace whittle
