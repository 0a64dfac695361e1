#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <cstdint>
#include <vector>

namespace whittle {

/// Whether contracting an edge leaves the topology as it is: Lk a ∩ Lk b = Lk ab, the border seen as joined to a cone
/// vertex. \cite dey_1999_topology It depends on the edge, not on the direction.
///
/// OpenMesh's `is_collapse_ok` is that test, but for the tetrahedron and for vertices with several fans.
/// `BaseDecimaterT::is_collapse_legal` adds rules that are not topology, and that a contraction with placement does
/// without:
///   - v0 is locked, or is a feature and the edge none: `PairDecimaterT` looks at both vertices, and pins;
///   - "don't collapse a boundary vertex to an inner one": where v1 keeps its place that would eat the border away; a
///     placed vertex is held by the border's planes, and the merged vertex lies on the border whichever handle stays;
///   - "at least 2 incident faces at v0": the tip of an ear may vanish, or take the place of its neighbour, like any
///     other border vertex;
///   - wings that are neighbours of valence 3: for inner wings that is the tetrahedron; with a wing on the border it
///     forbids three faces around a vertex from becoming one, which changes nothing.
template <class MeshT>
class LinkConditionT {
 public:
  /// \param mesh may lose elements later, not gain any
  explicit LinkConditionT(const MeshT& mesh) : mesh_(mesh), marks_(mesh.n_vertices()) {}

  bool operator()(OpenMesh::HalfedgeHandle ab) {
    const OpenMesh::HalfedgeHandle ba = mesh_.opposite_halfedge_handle(ab);
    const OpenMesh::VertexHandle left = opposite_corner(ab);
    const OpenMesh::VertexHandle right = opposite_corner(ba);
    if (left == right) return false;  // an edge without a face, or both faces on the same three corners
    return !closes_a_tunnel(ab, left, right) && !is_tetrahedron(ab, left, right) && !pinches_border(ab, left, right);
  }

 private:
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;

  /// The third corner of the face left of h; invalid on the border.
  VertexHandle opposite_corner(HalfedgeHandle h) const {
    return mesh_.is_boundary(h) ? VertexHandle() : mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h));
  }

  /// A common neighbour that makes no face with the edge.
  bool closes_a_tunnel(HalfedgeHandle ab, VertexHandle left, VertexHandle right) {
    const auto mark_of = [this](VertexHandle v) -> std::uint64_t& { return marks_[static_cast<std::size_t>(v.idx())]; };
    ++mark_;
    for (const VertexHandle v : mesh_.vv_range(mesh_.from_vertex_handle(ab))) mark_of(v) = mark_;
    for (const VertexHandle v : mesh_.vv_range(mesh_.to_vertex_handle(ab))) {
      if (mark_of(v) == mark_ && v != left && v != right) return true;
    }
    return false;
  }

  /// Faces (a, left, right) and (b, left, right), which would coincide.
  bool is_tetrahedron(HalfedgeHandle ab, VertexHandle left, VertexHandle right) const {
    if (!left.is_valid() || !right.is_valid()) return false;
    const HalfedgeHandle b_left = mesh_.next_halfedge_handle(ab);
    const HalfedgeHandle left_a = mesh_.next_halfedge_handle(b_left);
    return opposite_corner(mesh_.opposite_halfedge_handle(b_left)) == right &&
           opposite_corner(mesh_.opposite_halfedge_handle(left_a)) == right;
  }

  /// Two border vertices may only merge along the border, not over a hole of three edges or a lone face, and not when
  /// both have several fans.
  bool pinches_border(HalfedgeHandle ab, VertexHandle left, VertexHandle right) const {
    const VertexHandle a = mesh_.from_vertex_handle(ab);
    const VertexHandle b = mesh_.to_vertex_handle(ab);
    if (!mesh_.is_boundary(a) || !mesh_.is_boundary(b)) return false;
    if (left.is_valid() && right.is_valid()) return true;
    if (!mesh_.is_manifold(a) && !mesh_.is_manifold(b)) return true;
    const HalfedgeHandle inner = left.is_valid() ? ab : mesh_.opposite_halfedge_handle(ab);
    const HalfedgeHandle next = mesh_.next_halfedge_handle(inner);
    return mesh_.is_boundary(mesh_.edge_handle(next)) &&
           mesh_.is_boundary(mesh_.edge_handle(mesh_.next_halfedge_handle(next)));
  }

  const MeshT& mesh_;
  std::vector<std::uint64_t> marks_;  ///< by vertex: the last test that met it
  std::uint64_t mark_ = 0;
};

}  // namespace whittle
