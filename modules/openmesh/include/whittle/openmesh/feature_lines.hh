#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Tools/Decimater/CollapseInfoT.hh>
#include <unordered_map>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/openmesh/feature_bits.hh"

namespace whittle {

/// What feature bits let vertices do, as the engine has it for its feature edges: a vertex with two feature edges moves
/// along these only, to either end of the edge contracted; one with one, with three or more, or with the feature bit
/// and none, stays where it is. A line doesn't lose its loops, and stays near to where it was.
///
/// Positions may be in any frame, as long as it is the same one for all.
template <class MeshT>
class FeatureLinesT {
 public:
  using CollapseInfo = OpenMesh::Decimater::CollapseInfoT<MeshT>;

  /// \param tolerance how far a line may come to lie from what it is now
  FeatureLinesT(const MeshT& mesh, double tolerance)
      : mesh_(mesh), any_(has_feature_bits(mesh)), tolerance_sq_(tolerance * tolerance) {}

  /// Whether v may leave its place, or vanish, by a contraction of this edge of its.
  bool may_move(OpenMesh::VertexHandle v, OpenMesh::EdgeHandle along) const;
  bool is_point(OpenMesh::VertexHandle v) const { return any_ && is_feature_point(mesh_, v); }
  bool is_feature(OpenMesh::EdgeHandle edge) const { return any_ && mesh_.status(edge).feature(); }

  /// Whether the collapse, to be at `to`, would lay two feature edges on one another, so that a line lost its loop, or
  /// take a line farther off than it may be.
  /// \param moved of a feature edge, the end that goes to the other's place \param position_of vertex handle → Vec3
  template <class PositionOf>
  bool bends_a_line(const CollapseInfo& collapse, OpenMesh::VertexHandle moved, const Vec3& to,
                    const PositionOf& position_of) const;

  /// To be told before the mesh is, and before its feature bits are carried.
  template <class PositionOf>
  void note_collapse(const CollapseInfo& collapse, OpenMesh::VertexHandle moved, const PositionOf& position_of);

 private:
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;
  using EdgeHandle = OpenMesh::EdgeHandle;
  /// Where a line was, between the ends of a feature edge: its vertices there, in no particular order.
  using Course = std::vector<Vec3>;

  static bool has_feature_bits(const MeshT& mesh);
  /// The other feature edge of a vertex on a line, from it; invalid if it isn't on one.
  HalfedgeHandle next_on_line(VertexHandle v, EdgeHandle edge) const;

  const MeshT& mesh_;
  bool any_;
  double tolerance_sq_;
  std::unordered_map<int, Course> courses_;  ///< by edge index; of feature edges that stand for several
};

}  // namespace whittle

#include "whittle/openmesh/feature_lines_impl.hh"
