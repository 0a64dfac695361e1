#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/openmesh/detail/status_bits.hh"

// A half-edge mesh can't hold an edge with three faces, nor a vertex at which two fans of faces meet
// (`manifold_cut.hh`). Such vertices are there several times, and a vertex property of the mesh tells which of them
// belong together.

namespace whittle {

/// Name of that property, an int: vertices with the same number above 0 are copies of one vertex; 0 = v has no copies.
/// So vertices added later have none, and garbage collection, which moves the numbers along, keeps it true.
inline constexpr const char* copies_property = "whittle:copies";

/// \return invalid where the mesh has no such property: then no vertex has copies
template <class MeshT>
OpenMesh::VPropHandleT<int> find_copies_property(const MeshT& mesh) {
  OpenMesh::VPropHandleT<int> property;
  mesh.get_property_handle(property, copies_property);
  return property;
}

/// The same, added if need be.
template <class MeshT>
OpenMesh::VPropHandleT<int> require_copies_property(MeshT& mesh) {
  OpenMesh::VPropHandleT<int> property = find_copies_property(mesh);
  if (!property.is_valid()) mesh.add_property(property, copies_property);
  return property;
}

/// By vertex handle, the first of its copies: the lowest handle among those that belong together *and are at exactly
/// one position*; itself where there is none before it. Empty where all are themselves. Copies that something has moved
/// apart are vertices of their own: making them one would move faces.
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
