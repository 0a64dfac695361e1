#pragma once

#include <algorithm>  // before OpenMesh's headers, which use std::find without it

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <stdexcept>
#include <string>

#include "bench/peers/peer_arrays.hh"
#include "whittle/openmesh/conversions.hh"

namespace whittle::bench {

/// The usual OpenMesh mesh: coordinates in float.
using OpenMeshMesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// Makes the mesh and requests its status bits. Decimaters request them, too, but release them before the deleted
/// elements are collected.
/// \throw std::runtime_error if a half-edge mesh can't hold all faces
inline void fill(OpenMeshMesh& mesh, const IndexedMesh& input) {
  require_none_refused(to_open_mesh(input, mesh, NonManifold::refuse).size(), input.faces.size());
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  mesh.request_edge_status();
  mesh.request_face_status();
}

}  // namespace whittle::bench
