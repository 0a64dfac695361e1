#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <array>

namespace whittle {

/// `mesh.garbage_collection()`, compiled with the flags of the program. OpenMesh's library may have been built with
/// asserts, as Debian's is. Then its own version takes four times as long.
template <class MeshT>
void collect_garbage(MeshT& mesh) {
  std::array<OpenMesh::VertexHandle*, 0> vertices;  // handles to keep up to date: none
  std::array<OpenMesh::HalfedgeHandle*, 0> halfedges;
  std::array<OpenMesh::FaceHandle*, 0> faces;
  mesh.garbage_collection(vertices, halfedges, faces);
}

}  // namespace whittle
