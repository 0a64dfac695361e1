#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
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

/// Makes many collapses on OpenMesh's connectivity at once, in a few passes over the mesh. Each must be legal when its
/// turn comes. What is left is what `mesh.collapse` would leave, called for one after the other, to the handle and the
/// status bit; only a vertex whose outgoing halfedge vanished may have another one. Of edges that become one the
/// remaining one is a feature if any was.
///
/// Vertices merged into one are a cluster. An edge within a cluster vanishes, and so do the faces at it. The other
/// edges of those faces form strips: edges between the same two clusters a and b, from one face that stays, or the
/// border, to the next.
///
///              b---b---b
///       stays / \ / \ / stays     A strip of five edges, and the four faces in it that vanish.
///            a---a---a
///
/// A strip becomes one edge. Whenever one of its faces vanished, the edges on both its sides became one, and the one
/// at the surviving vertex remained; so the order in which they did decides which one is left.
template <class MeshT>
class BulkCollapseT {
 public:
  BulkCollapseT(MeshT& mesh, std::span<const VertexMerge> merges);

  void run();

 private:
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;
  using EdgeHandle = OpenMesh::EdgeHandle;
  using FaceHandle = OpenMesh::FaceHandle;

  /// What a vertex was merged into.
  struct Fate {
    VertexHandle into;
    Index time = invalid_index;  ///< number of the collapse; later than all others for those that survive
  };
  /// How two vertices became one.
  struct Meeting {
    Index time;
    bool second_survived;  ///< what the second had been merged into
  };
  /// An edge of a strip and the face before it.
  struct Rung {
    HalfedgeHandle halfedge;
    Meeting meeting;  ///< of the face's two corners in one cluster: the one at the edge before, the one at this edge
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
  /// Whether a strip ends at h: its face stays, or there is none.
  bool ends_strip(HalfedgeHandle h) const {
    const FaceHandle face = mesh_.face_handle(h);
    return !face.is_valid() || !face_bits_[face].deleted();
  }

  MeshT& mesh_;
  StatusBitsT<VertexHandle, MeshT> vertex_bits_;
  StatusBitsT<HalfedgeHandle, MeshT> halfedge_bits_;
  StatusBitsT<EdgeHandle, MeshT> edge_bits_;
  StatusBitsT<FaceHandle, MeshT> face_bits_;
  std::vector<Fate> fates_;                  ///< by vertex
  std::vector<VertexHandle> clusters_;       ///< by vertex: the survivor
  std::vector<HalfedgeHandle> substitutes_;  ///< by halfedge of a face that stays, or of the border: what takes its
                                             ///< place. Invalid for others
  std::vector<HalfedgeHandle> border_;       ///< those of the border
  std::vector<Rung> strip_;                  ///< scratch: what is left of the strip under look
};

}  // namespace whittle

#include "whittle/openmesh/detail/bulk_collapse_impl.hh"
