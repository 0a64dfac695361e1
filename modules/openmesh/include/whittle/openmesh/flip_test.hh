#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <cmath>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle {

/// Whether the face (corner, x, y) turns further than allowed, or loses its area, when its corner moves. A face that
/// has no area has no direction to keep. The engine's test, to the bit.
inline bool turns_too_far(const Vec3& from, const Vec3& to, const Vec3& x, const Vec3& y, double min_cosine) {
  const Vec3 before = (x - from).cross(y - from);
  const Vec3 after = (x - to).cross(y - to);
  const double product = before.squaredNorm() * after.squaredNorm();
  return product > 0 ? before.dot(after) < min_cosine * std::sqrt(product) : before.squaredNorm() > 0;
}

/// Whether one of v's faces turns too far when v moves to `to`, those at the edge to `other` left out: they vanish.
/// Changes nothing. \param position_of vertex handle → Vec3
template <class MeshT, class PositionOf>
bool star_turns_too_far(const MeshT& mesh, OpenMesh::VertexHandle v, OpenMesh::VertexHandle other, const Vec3& to,
                        double min_cosine, const PositionOf& position_of) {
  const Vec3 from = position_of(v);
  for (const OpenMesh::HalfedgeHandle h : mesh.voh_range(v)) {
    if (mesh.is_boundary(h)) continue;
    const OpenMesh::VertexHandle x = mesh.to_vertex_handle(h);
    const OpenMesh::VertexHandle y = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
    if (x == other || y == other) continue;
    if (turns_too_far(from, to, position_of(x), position_of(y), min_cosine)) return true;
  }
  return false;
}

}  // namespace whittle
