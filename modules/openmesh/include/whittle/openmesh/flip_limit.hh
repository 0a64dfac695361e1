#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>

#include "whittle/engine/flip_limit.hh"

namespace whittle {

/// Whether any face of v exceeds the limit when v moves to `to`, those at the edge to `other` left out: they vanish.
/// Changes nothing. \param position_of vertex handle → Vec3
template <class MeshT, class PositionOf>
bool is_exceeded_around(const FlipLimit& limit, const MeshT& mesh, OpenMesh::VertexHandle v,
                        OpenMesh::VertexHandle other, const Vec3& to, const PositionOf& position_of) {
  const Vec3 from = position_of(v);
  for (const OpenMesh::HalfedgeHandle h : mesh.voh_range(v)) {
    if (mesh.is_boundary(h)) continue;
    const OpenMesh::VertexHandle x = mesh.to_vertex_handle(h);
    const OpenMesh::VertexHandle y = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
    if (x == other || y == other) continue;
    if (limit.is_exceeded(from, to, position_of(x), position_of(y))) return true;
  }
  return false;
}

}  // namespace whittle
