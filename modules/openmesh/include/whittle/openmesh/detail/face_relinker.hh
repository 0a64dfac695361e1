#pragma once

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <utility>
#include <vector>

#include "whittle/core/manifold_cut.hh"
#include "whittle/openmesh/detail/status_bits.hh"
#include "whittle/openmesh/vertex_copies.hh"

namespace whittle {

/// What is left of a mesh after some of its vertices were joined, with or without an edge between them.
struct JoinedFaces {
  /// Handles of the vertices left, ascending; they are numbered in this order. Copies have the handle of the first.
  std::vector<Index> vertex_handles;
  /// By handle: the vertex that it is now part of, the same for all joined copies (`first_copies`). `invalid_index` if
  /// the vertex has vanished or had no face.
  std::vector<Index> vertex_of;
  std::vector<Triangle> faces;      ///< three different vertices of each, in the order of `face_corners`
  std::vector<Index> face_handles;  ///< of each, ascending
  std::vector<Index> first_copies;  ///< of the vertices before (`first_copies`)
};

/// Gives an OpenMesh mesh the connectivity that results from joining some of its vertices, in a few passes over the
/// mesh. What a half-edge mesh can't hold is cut into copies (`manifold_cut.hh`, `vertex_copies.hh`).
///
///   - *Faces* left keep their handles and first corners; the others are marked deleted.
///   - *Vertices* left keep their handles. If a vertex is cut, the copy whose faces had its handle keeps it. If it was
///     cut before, other copies keep their handles in the same way. Any other copies are new, after all others, with
///     all properties of the first. Vertices that had faces and are not left are marked deleted.
///   - *Edges* keep the handle of an edge that one of their faces had there: the lower handle if it is free. If two
///     faces were parted and the other face took the edge, the edge is new, with the same properties. An edge is a
///     feature if any edge between the vertices joined at its ends was one. Edges that no face took are marked deleted.
///
/// Positions don't change. \pre the mesh has status bits of vertices, edges and faces.
class FaceRelinker {
 public:
  using VertexHandle = OpenMesh::VertexHandle;

  /// A vertex of `JoinedFaces`, as the mesh holds it.
  struct Copy {
    Index vertex;
    VertexHandle handle;
  };

  /// \param joined must outlive this
  FaceRelinker(OpenMesh::TriConnectivity& mesh, const JoinedFaces& joined);

  /// \return all vertices left; a cut vertex is listed once per copy
  std::vector<Copy> run();

 private:
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;
  using EdgeHandle = OpenMesh::EdgeHandle;
  using FaceHandle = OpenMesh::FaceHandle;
  using Side = Index;                    ///< 3f + i, from corner i of face f to the next
  using Ends = std::pair<Index, Index>;  ///< vertices of an edge, the lower first

  void find_old_sides();
  void find_features();
  void assign_vertices();
  template <class Accepts>
  void keep_handles(const Accepts& accepts, std::vector<bool>& is_taken);
  void add_copies();
  void mark_copies();
  void assign_edges();
  bool take_edge(Side side);
  void add_edge(Side side);
  void set_edge(Side side, HalfedgeHandle halfedge);
  void carry_features();
  void delete_vertices();
  void delete_edges();
  void delete_faces();
  void link_sides();
  void link_border();
  void link_vertices();

  static Side next(Side side) { return side % 3 == 2 ? side - 2 : side + 1; }
  Index start(Side side) const { return cut_.faces[side / 3][side % 3]; }  ///< vertex of the cut
  VertexHandle start_handle(Side side) const { return vertices_[start(side)]; }
  EdgeHandle old_edge(Side side) const { return mesh_.edge_handle(old_sides_[side]); }
  bool has_opposite(Side side) const { return opposite_[side] != invalid_index; }
  bool is_taken(EdgeHandle e) const { return is_edge_taken_[static_cast<std::size_t>(e.idx())]; }
  /// The vertex of which a vertex of the cut is a copy, or itself.
  Index original(Index vertex) const {
    const std::size_t n = joined_.vertex_handles.size();
    return vertex < n ? vertex : cut_.originals[vertex - n];
  }

  OpenMesh::TriConnectivity& mesh_;
  const JoinedFaces& joined_;
  ManifoldCut cut_;
  std::vector<Side> opposite_;             ///< by side of the cut
  std::vector<HalfedgeHandle> old_sides_;  ///< by side: its old halfedge
  std::vector<Ends> features_;             ///< ascending: edges that are features
  std::vector<VertexHandle> vertices_;     ///< by vertex of the cut
  std::vector<HalfedgeHandle> sides_;      ///< by side: its new halfedge
  std::vector<bool> is_edge_taken_;        ///< by handle
  std::vector<HalfedgeHandle> outgoing_;   ///< by vertex of the cut: its outgoing halfedge
};

}  // namespace whittle
