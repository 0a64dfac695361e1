#pragma once

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/openmesh/detail/attributes/property_column.hh"

namespace whittle {

/// What the halfedges of a mesh carry: texture coordinates, normals and colours, as far as it has them. The values of a
/// corner are at the halfedge of its face that points to its vertex, where OpenMesh's readers put them.
class CornerProperties {
 public:
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;

  template <class MeshT>
  explicit CornerProperties(const MeshT& mesh) {
    if (mesh.has_halfedge_texcoords1D()) add("texcoord1D", AttributeKind::scalar, mesh.halfedge_texcoords1D_pph());
    if (mesh.has_halfedge_texcoords2D()) add("texcoord2D", AttributeKind::texcoord, mesh.halfedge_texcoords2D_pph());
    if (mesh.has_halfedge_texcoords3D()) add("texcoord3D", AttributeKind::texcoord, mesh.halfedge_texcoords3D_pph());
    if (mesh.has_halfedge_colors()) add("color", AttributeKind::color, mesh.halfedge_colors_pph());
    if (mesh.has_halfedge_normals()) add("normal", AttributeKind::normal, mesh.halfedge_normals_pph());
  }

  bool empty() const { return columns_.empty(); }
  /// All numbers of a corner, attribute by attribute.
  std::size_t size() const { return size_; }

  void get(const OpenMesh::BaseKernel& mesh, HalfedgeHandle h, std::span<double> to) const;
  void set(OpenMesh::BaseKernel& mesh, HalfedgeHandle h, std::span<const double> from) const;

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
  using Column = PropertyColumn<HalfedgeHandle>;

  template <class PropertyHandle>
  void add(const char* name, AttributeKind kind, PropertyHandle property) {
    columns_.push_back(std::make_unique<TypedColumn<HalfedgeHandle, PropertyHandle>>(name, kind, property));
    size_ += columns_.back()->attribute().n_components;
  }

  std::vector<std::unique_ptr<const Column>> columns_;
  std::size_t size_ = 0;
};

/// The halfedges at the corners of a face, in the order of `face_corners`.
std::array<OpenMesh::HalfedgeHandle, 3> corner_halfedges(const OpenMesh::ArrayKernel& mesh, OpenMesh::FaceHandle face);

/// Gives an indexed mesh the wedges of the mesh that it was made of. \pre it has the mesh's faces in the order of the
/// handles, and no attributes
void add_wedges(const OpenMesh::ArrayKernel& mesh, const CornerProperties& corners, IndexedMesh& to);

/// Writes the wedges of faces back to the corners that they have become.
/// \param from has the attributes of `add_wedges` \param face_handles of its faces
/// \param vertex_of by handle, the vertex of `from`
void set_corners(const IndexedMesh& from, std::span<const Index> face_handles, std::span<const Index> vertex_of,
                 const CornerProperties& corners, OpenMesh::ArrayKernel& mesh);

}  // namespace whittle
