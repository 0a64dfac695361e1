#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/openmesh/detail/status_bits.hh"

// A half-edge mesh can't hold an edge with three faces, two faces that run along an edge the same way, or two closed
// fans of faces at a vertex (`manifold_cut.hh`). Such vertices are stored as several copies. A vertex property of the
// mesh says which copies belong together.

namespace whittle {

/// Name of that property, an int. Vertices with the same number above 0 are copies of one vertex; 0 = no copies.
/// Vertices added later have 0. Garbage collection moves the numbers along with the vertices.
inline constexpr const char* copies_property = "whittle:copies";

/// \return invalid if the mesh has no such property: then no vertex has copies
template <class MeshT>
OpenMesh::VPropHandleT<int> find_copies_property(const MeshT& mesh) {
  OpenMesh::VPropHandleT<int> property;
  mesh.get_property_handle(property, copies_property);
  return property;
}

/// The same; adds the property if the mesh doesn't have it.
template <class MeshT>
OpenMesh::VPropHandleT<int> require_copies_property(MeshT& mesh) {
  OpenMesh::VPropHandleT<int> property = find_copies_property(mesh);
  if (!property.is_valid()) mesh.add_property(property, copies_property);
  return property;
}

/// By vertex handle, the first of its copies: the lowest handle among those that belong together *and are at exactly
/// one position*. A vertex without an earlier copy has its own handle. Empty if all vertices have their own. Copies
/// that were moved apart are vertices of their own: joining them would move faces.
template <class MeshT>
std::vector<Index> first_copies(const MeshT& mesh) {
  const OpenMesh::VPropHandleT<int> property = find_copies_property(mesh);
  if (!property.is_valid()) return {};
  const StatusBitsT<OpenMesh::VertexHandle, const MeshT> bits(mesh);
  std::vector<Index> result(mesh.n_vertices());
  std::iota(result.begin(), result.end(), Index{0});
  std::map<int, std::vector<OpenMesh::VertexHandle>> firsts;  // by number: the first at each position
  bool any = false;
  for (int i = 0; i < static_cast<int>(mesh.n_vertices()); ++i) {
    const OpenMesh::VertexHandle v(i);
    const int number = mesh.property(property, v);
    if (number <= 0 || bits.is_deleted(v)) continue;
    std::vector<OpenMesh::VertexHandle>& known = firsts[number];
    const auto is_here = [&](OpenMesh::VertexHandle other) { return mesh.point(other) == mesh.point(v); };
    const auto first = std::find_if(known.begin(), known.end(), is_here);
    if (first == known.end()) {
      known.push_back(v);
    } else {
      result[static_cast<std::size_t>(i)] = static_cast<Index>(first->idx());
      any = true;
    }
  }
  if (!any) result.clear();
  return result;
}

}  // namespace whittle
