#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Tools/Decimater/CollapseInfoT.hh>
#include <algorithm>

namespace whittle {

/// A collapse makes two edges one, of which OpenMesh keeps v1's. Makes that edge a feature if either of the two is.
/// Call before the collapse.
template <class MeshT>
void carry_feature_bits(MeshT& mesh, const OpenMesh::Decimater::CollapseInfoT<MeshT>& collapse) {
  if (!mesh.has_edge_status()) return;
  const auto carry = [&mesh](OpenMesh::HalfedgeHandle from, OpenMesh::HalfedgeHandle to) {
    if (!from.is_valid() || !mesh.status(mesh.edge_handle(from)).feature()) return;
    mesh.status(mesh.edge_handle(to)).set_feature(true);
  };
  carry(collapse.v0vl, collapse.vlv1);
  carry(collapse.vrv0, collapse.v1vr);
}

/// How many edges at v have the feature bit.
template <class MeshT>
int count_feature_edges(const MeshT& mesh, OpenMesh::VertexHandle v) {
  const auto edges = mesh.ve_range(v);
  return static_cast<int>(
      std::count_if(edges.begin(), edges.end(), [&mesh](auto edge) { return mesh.status(edge).feature(); }));
}

}  // namespace whittle
