#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Tools/Decimater/CollapseInfoT.hh>
#include <cstddef>
#include <optional>
#include <vector>

#include "whittle/metrics/detail/surface_proof.hh"
#include "whittle/openmesh/conversions.hh"

namespace whittle {

/// What is proven of a mesh while it is decimated: that it and the input are near to each other, the surfaces and their
/// borders. Edges of one face are the border, but for those where a non-manifold mesh was cut into copies of vertices.
template <class MeshT>
class MeshProofT {
 public:
  using CollapseInfo = OpenMesh::Decimater::CollapseInfoT<MeshT>;
  using Point = typename MeshT::Point;

  /// Model units.
  struct Limits {
    double surface = 0;
    double border = 0;
    bool operator==(const Limits&) const = default;
  };

  /// Proves the mesh as it is, as far as it can be. \param mesh, input must outlive it
  MeshProofT(const MeshT& mesh, const IndexedMesh& input, const Limits& limits);

  const Limits& limits() const { return limits_; }
  /// Whether it knows the mesh: garbage collection gives it other handles.
  bool fits() const { return mesh_.n_faces() == n_faces_; }
  /// Whether the mesh as it is is proven to keep the limits.
  bool is_proven() const { return !is_cut_open_ && surface_.is_proven() && (!border_ || border_->is_proven()); }

  /// Whether the mesh will be proven after a collapse. \param point where v1 goes
  bool allows(const CollapseInfo& collapse, const Point& point);
  /// To be called before each collapse and after it. What was asked doesn't matter: it looks at what was done.
  void note_before(const CollapseInfo& collapse);
  void note_after(const CollapseInfo& collapse);

 private:
  using VertexHandle = OpenMesh::VertexHandle;
  using EdgeHandle = OpenMesh::EdgeHandle;
  using FaceHandle = OpenMesh::FaceHandle;
  using Face = metrics::SurfaceProof::Face;
  using Change = metrics::SurfaceProof::Change;
  struct Question {
    VertexHandle first, second;
    Point point;
    std::size_t n_made;
    bool operator==(const Question&) const = default;
  };
  /// Around a collapse, before it.
  struct Before {
    Point p1;
    std::vector<Index> faces_at_v0, faces_at_v1;
    std::vector<Index> border_edges_at_v0, border_edges_at_v1;
    bool is_v0_at_cut = false, is_v1_at_cut = false;
  };

  std::vector<bool> find_cuts() const;
  bool is_allowed(const CollapseInfo& collapse, const Point& point);
  bool is_at_cut(VertexHandle v) const;
  Change surface_change(const CollapseInfo& collapse, const Point& point) const;
  Change border_change(const CollapseInfo& collapse, const Point& point) const;
  std::vector<VertexHandle> border_ends(const CollapseInfo& collapse) const;
  Change surface_change_made(VertexHandle v1, bool v1_moved) const;
  Change border_change_made(VertexHandle v1) const;
  void add_faces_around(VertexHandle v, std::vector<Index>& faces) const;
  std::vector<Index> faces_at(VertexHandle v) const;
  std::vector<Index> border_edges_at(VertexHandle v) const;
  bool is_border(EdgeHandle e) const { return mesh_.is_boundary(e) && !is_cut(e); }
  bool is_cut(EdgeHandle e) const { return !is_cut_.empty() && is_cut_[static_cast<std::size_t>(e.idx())]; }
  Face face_of(FaceHandle f) const;
  Face face_of(EdgeHandle e) const;
  static Index index(OpenMesh::BaseHandle handle) { return static_cast<Index>(handle.idx()); }

  const MeshT& mesh_;
  Limits limits_;
  std::size_t n_faces_;       ///< of the mesh, with deleted ones
  std::vector<bool> is_cut_;  ///< by edge, whether it has one face only because the mesh was cut there; or empty
  bool is_cut_open_ = false;  ///< whether copies may have been moved apart
  IndexedMesh input_border_;  ///< edges as faces of which two corners are one
  metrics::SurfaceProof surface_;
  std::optional<metrics::SurfaceProof> border_;  ///< empty if the input has none
  std::size_t n_made_ = 0;
  std::optional<Question> last_question_;
  bool last_answer_ = false;
  Before before_;
};

}  // namespace whittle

#include "whittle/openmesh/detail/mesh_proof_impl.hh"
