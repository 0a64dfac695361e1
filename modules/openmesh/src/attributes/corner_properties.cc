#include "whittle/openmesh/detail/attributes/corner_properties.hh"

#include <algorithm>

#include "whittle/core/wedges.hh"
#include "whittle/openmesh/detail/status_bits.hh"

namespace whittle {

void CornerProperties::get(const OpenMesh::BaseKernel& mesh, HalfedgeHandle h, std::span<double> to) const {
  for_each([&](const Column& column, std::size_t first, std::size_t n) { column.get(mesh, h, to.subspan(first, n)); });
}

void CornerProperties::set(OpenMesh::BaseKernel& mesh, HalfedgeHandle h, std::span<const double> from) const {
  for_each(
      [&](const Column& column, std::size_t first, std::size_t n) { column.set(mesh, h, from.subspan(first, n)); });
}

std::array<OpenMesh::HalfedgeHandle, 3> corner_halfedges(const OpenMesh::ArrayKernel& mesh, OpenMesh::FaceHandle face) {
  const OpenMesh::HalfedgeHandle h0 = mesh.halfedge_handle(face);
  const OpenMesh::HalfedgeHandle h1 = mesh.next_halfedge_handle(h0);
  return {h0, h1, mesh.next_halfedge_handle(h1)};
}

void add_wedges(const OpenMesh::ArrayKernel& mesh, const CornerProperties& corners, IndexedMesh& to) {
  if (corners.empty()) return;
  corners.for_each(
      [&to](const auto& column, std::size_t, std::size_t) { to.attributes.push_back(column.attribute()); });
  std::vector<double> values(corners.size());
  const ConstStatusBits<OpenMesh::FaceHandle> bits(mesh);
  for (int i = 0; i < static_cast<int>(mesh.n_faces()); ++i) {
    const OpenMesh::FaceHandle face(i);
    if (bits.is_deleted(face)) continue;
    for (const OpenMesh::HalfedgeHandle h : corner_halfedges(mesh, face)) {
      to.wedges.push_back(static_cast<Index>(to.wedges.size()));
      corners.get(mesh, h, values);
      std::size_t first = 0;
      for (Attribute& attribute : to.attributes) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
        first += attribute.n_components;
        attribute.values.insert(attribute.values.end(), begin,
                                begin + static_cast<std::ptrdiff_t>(attribute.n_components));
      }
    }
  }
  join_equal_wedges(to);
}

void set_corners(const IndexedMesh& from, std::span<const Index> face_handles, std::span<const Index> vertex_of,
                 const CornerProperties& corners, OpenMesh::ArrayKernel& mesh) {
  std::vector<double> values(corners.size());
  for (std::size_t f = 0; f < from.faces.size(); ++f) {
    const OpenMesh::FaceHandle face(static_cast<int>(face_handles[f]));
    for (const OpenMesh::HalfedgeHandle h : corner_halfedges(mesh, face)) {
      const Index vertex = vertex_of[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())];
      std::size_t k = 0;
      while (k < 2 && from.faces[f][k] != vertex) ++k;
      std::size_t first = 0;
      for (const Attribute& attribute : from.attributes) {
        const std::span<const double> value = attribute.value(from.wedge(f, k));
        std::copy(value.begin(), value.end(), values.begin() + static_cast<std::ptrdiff_t>(first));
        first += value.size();
      }
      corners.set(mesh, h, values);
    }
  }
}

}  // namespace whittle
