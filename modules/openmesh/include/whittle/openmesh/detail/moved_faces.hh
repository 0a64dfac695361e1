#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Tools/Decimater/CollapseInfoT.hh>

#include "whittle/core/geometry/radius_ratio.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/flip_limit.hh"

namespace whittle {

/// Whether `is_bad(from, to, x, y)` holds for any face (v, x, y) when v moves to `to`. Faces at the edge to `other` are
/// left out, as they vanish. Changes nothing. \param position_of vertex handle → Vec3
template <class MeshT, class PositionOf, class IsBad>
bool any_moved_face_at(const MeshT& mesh, OpenMesh::VertexHandle v, OpenMesh::VertexHandle other, const Vec3& to,
                       const PositionOf& position_of, const IsBad& is_bad) {
  const Vec3 from = position_of(v);
  for (const OpenMesh::HalfedgeHandle h : mesh.voh_range(v)) {
    if (mesh.is_boundary(h)) continue;
    const OpenMesh::VertexHandle x = mesh.to_vertex_handle(h);
    const OpenMesh::VertexHandle y = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
    if (x == other || y == other) continue;
    if (is_bad(from, to, position_of(x), position_of(y))) return true;
  }
  return false;
}

/// The same for the faces of both vertices of a collapse, merged at `to`.
template <class MeshT, class PositionOf, class IsBad>
bool any_moved_face(const MeshT& mesh, const OpenMesh::Decimater::CollapseInfoT<MeshT>& collapse, const Vec3& to,
                    const PositionOf& position_of, const IsBad& is_bad) {
  return any_moved_face_at(mesh, collapse.v0, collapse.v1, to, position_of, is_bad) ||
         any_moved_face_at(mesh, collapse.v1, collapse.v0, to, position_of, is_bad);
}

/// Whether a face turns further than the limit.
inline auto turns_beyond(const FlipLimit& limit) {
  return [&limit](const Vec3& from, const Vec3& to, const Vec3& x, const Vec3& y) {
    return limit.is_exceeded(from, to, x, y);
  };
}

/// Whether the radius ratio of a face gets below `min_ratio`, and below what it was.
inline auto gets_thinner_than(double min_ratio) {
  return [min_ratio](const Vec3& from, const Vec3& to, const Vec3& x, const Vec3& y) {
    const double after = radius_ratio(to, x, y);
    return after < min_ratio && after < radius_ratio(from, x, y);
  };
}

}  // namespace whittle
