#include "whittle/openmesh/vertex_copies.hh"

#include <algorithm>
#include <map>
#include <numeric>

#include "whittle/openmesh/detail/status_bits.hh"

namespace whittle {

OpenMesh::VPropHandleT<int> find_copies_property(const OpenMesh::ArrayKernel& mesh) {
  OpenMesh::VPropHandleT<int> property;
  mesh.get_property_handle(property, copies_property);
  return property;
}

OpenMesh::VPropHandleT<int> require_copies_property(OpenMesh::ArrayKernel& mesh) {
  OpenMesh::VPropHandleT<int> property = find_copies_property(mesh);
  if (!property.is_valid()) mesh.add_property(property, copies_property);
  return property;
}

std::vector<Index> detail::find_first_copies(
    const OpenMesh::ArrayKernel& mesh,
    const std::function<bool(OpenMesh::VertexHandle, OpenMesh::VertexHandle)>& coincide) {
  const OpenMesh::VPropHandleT<int> property = find_copies_property(mesh);
  if (!property.is_valid()) return {};
  const ConstStatusBits<OpenMesh::VertexHandle> bits(mesh);
  std::vector<Index> result(mesh.n_vertices());
  std::iota(result.begin(), result.end(), Index{0});
  std::map<int, std::vector<OpenMesh::VertexHandle>> firsts;  // by number: the first at each position
  bool any = false;
  for (int i = 0; i < static_cast<int>(mesh.n_vertices()); ++i) {
    const OpenMesh::VertexHandle v(i);
    const int number = mesh.property(property, v);
    if (number <= 0 || bits.is_deleted(v)) continue;
    std::vector<OpenMesh::VertexHandle>& known = firsts[number];
    const auto is_here = [&](OpenMesh::VertexHandle other) { return coincide(other, v); };
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
