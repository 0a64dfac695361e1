#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>
#include <functional>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// A half-edge mesh can't hold an edge with three faces, two faces that run along an edge the same way, or two closed
// fans of faces at a vertex (`manifold_cut.hh`). Such vertices are stored as several copies. A vertex property of the
// mesh says which copies belong together.

namespace whittle {

/// Name of that property, an int. Vertices with the same number above 0 are copies of one vertex; 0 = no copies.
/// Vertices added later have 0. Garbage collection moves the numbers along with the vertices.
inline constexpr const char* copies_property = "whittle:copies";

/// \return invalid if the mesh has no such property: then no vertex has copies
OpenMesh::VPropHandleT<int> find_copies_property(const OpenMesh::ArrayKernel& mesh);

/// The same; adds the property if the mesh doesn't have it.
OpenMesh::VPropHandleT<int> require_copies_property(OpenMesh::ArrayKernel& mesh);

namespace detail {

/// \param coincide (vertex, vertex): whether both are at exactly one position
std::vector<Index> find_first_copies(
    const OpenMesh::ArrayKernel& mesh,
    const std::function<bool(OpenMesh::VertexHandle, OpenMesh::VertexHandle)>& coincide);

}  // namespace detail

/// By vertex handle, the first of its copies: the lowest handle among those that belong together *and are at exactly
/// one position*. A vertex without an earlier copy has its own handle. Empty if all vertices have their own. Copies
/// that were moved apart are vertices of their own: joining them would move faces.
template <class MeshT>
std::vector<Index> first_copies(const MeshT& mesh) {
  return detail::find_first_copies(
      mesh, [&mesh](OpenMesh::VertexHandle v, OpenMesh::VertexHandle w) { return mesh.point(v) == mesh.point(w); });
}

}  // namespace whittle
