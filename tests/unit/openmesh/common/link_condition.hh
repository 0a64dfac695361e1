#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <cstdint>
#include <vector>

namespace whittle {

/// Whether contracting an edge keeps the topology: Lk a ∩ Lk b = Lk ab, with a cone vertex joined to the border.
/// \cite dey_1999_topology It depends on the edge, not on the direction.
///
/// OpenMesh's `is_collapse_ok` is the same test, except for the tetrahedron and for vertices with several fans.
/// `BaseDecimaterT::is_collapse_legal` adds rules that are not about topology. A contraction with placement does not
/// need them:
///   - v0 is locked, or v0 is a feature and the edge is not. `PairDecimaterT` looks at both vertices, and pins.
///   - "don't collapse a boundary vertex to an inner one". If v1 keeps its position, that erodes the border. With
///     placement the border's planes hold the vertex, and the merged vertex lies on the border whichever handle stays.
///   - "at least 2 incident faces at v0". The tip of an ear may vanish, or take its neighbour's position, like any
///     other border vertex.
///   - Wings that are neighbours of valence 3. For inner wings that is the tetrahedron. With a wing on the border it
///     forbids merging three faces around a vertex into one, which does not change the topology.
template <class MeshT>
class LinkConditionT {
 public:
  /// \param mesh may lose elements later, but not gain any
  explicit LinkConditionT(const MeshT& mesh) : mesh_(mesh), marks_(mesh.n_vertices()) {}

  bool operator()(OpenMesh::HalfedgeHandle ab) {
    const OpenMesh::HalfedgeHandle ba = mesh_.opposite_halfedge_handle(ab);
    const OpenMesh::VertexHandle left = opposite_corner(ab);
    const OpenMesh::VertexHandle right = opposite_corner(ba);
    if (left == right) return false;  // the edge has no face, or both faces have the same three corners
    return !closes_a_tunnel(ab, left, right) && !is_tetrahedron(ab, left, right) && !pinches_border(ab, left, right);
  }

 private:
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;

  /// The third corner of the face left of h; invalid on the border.
  VertexHandle opposite_corner(HalfedgeHandle h) const {
    return mesh_.is_boundary(h) ? VertexHandle() : mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h));
  }

  /// True if the ends have a common neighbour that forms no face with the edge.
  bool closes_a_tunnel(HalfedgeHandle ab, VertexHandle left, VertexHandle right) {
    const auto mark_of = [this](VertexHandle v) -> std::uint64_t& { return marks_[static_cast<std::size_t>(v.idx())]; };
    ++mark_;
    for (const VertexHandle v : mesh_.vv_range(mesh_.from_vertex_handle(ab))) mark_of(v) = mark_;
    for (const VertexHandle v : mesh_.vv_range(mesh_.to_vertex_handle(ab))) {
      if (mark_of(v) == mark_ && v != left && v != right) return true;
    }
    return false;
  }

  /// True if there are faces (a, left, right) and (b, left, right): they would coincide.
  bool is_tetrahedron(HalfedgeHandle ab, VertexHandle left, VertexHandle right) const {
    if (!left.is_valid() || !right.is_valid()) return false;
    const HalfedgeHandle b_left = mesh_.next_halfedge_handle(ab);
    const HalfedgeHandle left_a = mesh_.next_halfedge_handle(b_left);
    return opposite_corner(mesh_.opposite_halfedge_handle(b_left)) == right &&
           opposite_corner(mesh_.opposite_halfedge_handle(left_a)) == right;
  }

  /// Two border vertices may merge only along a border edge. Its face must not have three border edges, and only one of
  /// the two may have several fans.
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
  std::vector<std::uint64_t> marks_;  ///< by vertex: number of the last test that visited it
  std::uint64_t mark_ = 0;
};

}  // namespace whittle
