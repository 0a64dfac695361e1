#pragma once

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <array>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/openmesh/detail/status_bits.hh"

namespace whittle {

/// A collapse: one vertex into another.
struct VertexMerge {
  OpenMesh::VertexHandle removed;
  OpenMesh::VertexHandle survivor;
};

/// Makes many collapses on OpenMesh's connectivity at once, in a few passes over the mesh. Each collapse must be legal
/// when its turn comes. The result equals that of calling `mesh.collapse` for one after the other, to the handle and
/// the status bit. There is one exception: a vertex whose outgoing halfedge vanished may have another one. Where edges
/// become one, the remaining edge is a feature if any of them was.
///
/// Vertices merged into one are a cluster. An edge within a cluster vanishes, and so do the faces at it. The other
/// edges of those faces form strips. A strip has edges between the same two clusters a and b. It runs from a remaining
/// face, or the border, to the next.
///
///              b---b---b
///       stays / \ / \ / stays     A strip of five edges, and the four faces in it that vanish.
///            a---a---a
///
/// A strip becomes one edge. Whenever one of its faces vanishes, the edges on both its sides become one: the edge at
/// the surviving vertex remains. So the order of the collapses decides which edge is left.
class BulkCollapse {
 public:
  BulkCollapse(OpenMesh::TriConnectivity& mesh, std::span<const VertexMerge> merges);

  void run();

 private:
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;
  using EdgeHandle = OpenMesh::EdgeHandle;
  using FaceHandle = OpenMesh::FaceHandle;

  /// What a vertex was merged into.
  struct Fate {
    VertexHandle into;
    Index time = invalid_index;  ///< number of the collapse; greater than all others for survivors
  };
  /// How two vertices became one.
  struct Meeting {
    Index time;
    bool second_survived;  ///< whether what the second had been merged into survived
  };
  /// An edge of a strip and the face before it.
  struct Rung {
    HalfedgeHandle halfedge;
    Meeting meeting;  ///< of the face's corners in one cluster: first that of the edge before, second that of this edge
  };

  void find_clusters(std::span<const VertexMerge> merges);
  void delete_inner_edges();
  void update_vertices();
  void merge_strip(HalfedgeHandle first);
  Rung across(HalfedgeHandle h) const;
  Meeting meeting(VertexHandle v, VertexHandle w) const;
  void merge_last_rungs();
  void link_faces();
  void link_border();
  VertexHandle link(HalfedgeHandle h, HalfedgeHandle next);

  void delete_edge(EdgeHandle e);
  void delete_face(HalfedgeHandle h);

  VertexHandle cluster(VertexHandle v) const { return clusters_[static_cast<std::size_t>(v.idx())]; }
  const Fate& fate(VertexHandle v) const { return fates_[static_cast<std::size_t>(v.idx())]; }
  HalfedgeHandle& substitute(HalfedgeHandle h) { return substitutes_[static_cast<std::size_t>(h.idx())]; }
  /// Whether a strip ends at h: the face of h stays, or h has none.
  bool ends_strip(HalfedgeHandle h) const {
    const FaceHandle face = mesh_.face_handle(h);
    return !face.is_valid() || !face_bits_[face].deleted();
  }

  OpenMesh::TriConnectivity& mesh_;
  StatusBits<VertexHandle> vertex_bits_;
  StatusBits<HalfedgeHandle> halfedge_bits_;
  StatusBits<EdgeHandle> edge_bits_;
  StatusBits<FaceHandle> face_bits_;
  std::vector<Fate> fates_;                  ///< by vertex
  std::vector<VertexHandle> clusters_;       ///< by vertex: the survivor
  std::vector<HalfedgeHandle> substitutes_;  ///< by halfedge of a remaining face or of the border: the halfedge that
                                             ///< replaces it. Invalid for others
  std::vector<HalfedgeHandle> border_;       ///< border halfedges at ends of strips
  std::vector<Rung> strip_;                  ///< scratch: the remaining edges of the current strip
};

}  // namespace whittle
