#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <cmath>
#include <numbers>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle {

/// How far a face may turn when one of its corners moves. The engine's test, to the bit.
class FlipLimit {
 public:
  /// \param max_angle_deg [0, 180]; at 180 only a face that loses its area is too much
  explicit FlipLimit(double max_angle_deg)
      : signed_min_cosine_sq_(signed_square(std::cos(max_angle_deg * std::numbers::pi / 180))) {}

  /// Whether the face (corner, x, y) turns further, or loses its area, when its corner moves. A face that has no area
  /// has no direction to keep.
  bool is_exceeded(const Vec3& from, const Vec3& to, const Vec3& x, const Vec3& y) const {
    const Vec3 opposite = y - x;
    const Vec3 before = (x - from).cross(opposite);
    const Vec3 after = (x - to).cross(opposite);
    const double before_sq = before.squaredNorm();
    const double after_sq = after.squaredNorm();
    // before · after < cos · |before| |after|, without the root.
    const double difference = signed_square(before.dot(after)) - signed_min_cosine_sq_ * (before_sq * after_sq);
    return difference < 0 || (after_sq == 0 && before_sq > 0);
  }

  /// Whether it is at any face of v when v moves to `to`, those at the edge to `other` left out: they vanish. Changes
  /// nothing. \param position_of vertex handle → Vec3
  template <class MeshT, class PositionOf>
  bool is_exceeded(const MeshT& mesh, OpenMesh::VertexHandle v, OpenMesh::VertexHandle other, const Vec3& to,
                   const PositionOf& position_of) const {
    const Vec3 from = position_of(v);
    for (const OpenMesh::HalfedgeHandle h : mesh.voh_range(v)) {
      if (mesh.is_boundary(h)) continue;
      const OpenMesh::VertexHandle x = mesh.to_vertex_handle(h);
      const OpenMesh::VertexHandle y = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
      if (x == other || y == other) continue;
      if (is_exceeded(from, to, position_of(x), position_of(y))) return true;
    }
    return false;
  }

 private:
  static double signed_square(double x) { return x * std::abs(x); }

  double signed_min_cosine_sq_;
};

}  // namespace whittle
