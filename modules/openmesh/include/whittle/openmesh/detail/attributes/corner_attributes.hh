#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/wedges.hh"
#include "whittle/openmesh/detail/attributes/property_column.hh"
#include "whittle/openmesh/detail/status_bits.hh"

namespace whittle {

/// What the halfedges of a mesh carry: texture coordinates, normals and colours, as far as it has them. The values of a
/// corner are at the halfedge of its face that points to its vertex, where OpenMesh's readers put them.
template <class MeshT>
class CornerAttributesT {
 public:
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;

  explicit CornerAttributesT(const MeshT& mesh) {
    if (mesh.has_halfedge_texcoords1D()) add("texcoord1D", AttributeKind::scalar, mesh.halfedge_texcoords1D_pph());
    if (mesh.has_halfedge_texcoords2D()) add("texcoord2D", AttributeKind::texcoord, mesh.halfedge_texcoords2D_pph());
    if (mesh.has_halfedge_texcoords3D()) add("texcoord3D", AttributeKind::texcoord, mesh.halfedge_texcoords3D_pph());
    if (mesh.has_halfedge_colors()) add("color", AttributeKind::color, mesh.halfedge_colors_pph());
    if (mesh.has_halfedge_normals()) add("normal", AttributeKind::normal, mesh.halfedge_normals_pph());
  }

  bool empty() const { return columns_.empty(); }
  std::size_t n() const { return columns_.size(); }
  /// Without values.
  const Attribute& attribute(std::size_t i) const { return columns_[i]->attribute(); }
  /// All numbers of a corner, attribute by attribute.
  std::size_t size() const { return size_; }

  void get(const MeshT& mesh, HalfedgeHandle h, std::span<double> to) const {
    for_each(
        [&](const Column& column, std::size_t first, std::size_t n) { column.get(mesh, h, to.subspan(first, n)); });
  }
  void set(MeshT& mesh, HalfedgeHandle h, std::span<const double> from) const {
    for_each(
        [&](const Column& column, std::size_t first, std::size_t n) { column.set(mesh, h, from.subspan(first, n)); });
  }

  /// \param visit (column, its first number, how many it has)
  template <class Visit>
  void for_each(const Visit& visit) const {
    std::size_t first = 0;
    for (const auto& column : columns_) {
      const std::size_t n = column->attribute().n_components;
      visit(*column, first, n);
      first += n;
    }
  }

 private:
  using Column = PropertyColumnT<MeshT, HalfedgeHandle>;

  template <class PropertyHandle>
  void add(const char* name, AttributeKind kind, PropertyHandle property) {
    columns_.push_back(std::make_unique<TypedColumnT<MeshT, HalfedgeHandle, PropertyHandle>>(name, kind, property));
    size_ += columns_.back()->attribute().n_components;
  }

  std::vector<std::unique_ptr<const Column>> columns_;
  std::size_t size_ = 0;
};

/// The halfedges at the corners of a face, in the order of `face_corners`.
template <class MeshT>
std::array<OpenMesh::HalfedgeHandle, 3> corner_halfedges(const MeshT& mesh, OpenMesh::FaceHandle face) {
  const OpenMesh::HalfedgeHandle h0 = mesh.halfedge_handle(face);
  const OpenMesh::HalfedgeHandle h1 = mesh.next_halfedge_handle(h0);
  return {h0, h1, mesh.next_halfedge_handle(h1)};
}

/// Gives an indexed mesh the wedges of the mesh that it was made of. \pre it has the mesh's faces in the order of the
/// handles, and no attributes
template <class MeshT>
void add_wedges(const MeshT& mesh, const CornerAttributesT<MeshT>& corners, IndexedMesh& to) {
  if (corners.empty()) return;
  for (std::size_t i = 0; i < corners.n(); ++i) to.attributes.push_back(corners.attribute(i));
  std::vector<double> values(corners.size());
  const StatusBitsT<OpenMesh::FaceHandle, const MeshT> bits(mesh);
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

/// Writes the wedges of faces back to the corners that they have become.
/// \param from has the attributes of `add_wedges` \param face_handles of its faces
/// \param vertex_of by handle, the vertex of `from`
template <class MeshT>
void set_corners(const IndexedMesh& from, std::span<const Index> face_handles, std::span<const Index> vertex_of,
                 const CornerAttributesT<MeshT>& corners, MeshT& mesh) {
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
