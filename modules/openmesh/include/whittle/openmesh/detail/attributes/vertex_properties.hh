#pragma once

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <functional>
#include <memory>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/detail/attributes/property_column.hh"

namespace whittle {

/// What vertices carry, when some become one: texture coordinates, colours, normals, and the user's properties of real
/// numbers (float, double, OpenMesh's vectors of them) that have a name. A merged vertex gets what the surface has
/// around the place where it goes (`AttributeFunctions`). All other properties stay those of the vertex that survives:
/// whole numbers name things.
class VertexProperties {
 public:
  using VertexHandle = OpenMesh::VertexHandle;

  template <class MeshT>
  explicit VertexProperties(const MeshT& mesh) : properties_(mesh.vprops_begin(), mesh.vprops_end()) {
    if (mesh.has_vertex_texcoords1D()) add(AttributeKind::scalar, mesh.vertex_texcoords1D_pph());
    if (mesh.has_vertex_texcoords2D()) add(AttributeKind::scalar, mesh.vertex_texcoords2D_pph());
    if (mesh.has_vertex_texcoords3D()) add(AttributeKind::scalar, mesh.vertex_texcoords3D_pph());
    if (mesh.has_vertex_colors()) add(AttributeKind::scalar, mesh.vertex_colors_pph());
    if (mesh.has_vertex_normals()) add(AttributeKind::normal, mesh.vertex_normals_pph());
    add_those_of_user();
  }

  bool empty() const { return columns_.empty(); }
  /// Whether the mesh has the same properties as before.
  bool fits(const OpenMesh::BaseKernel& mesh) const;

  /// Gives the survivor of an edge what the faces around both vertices have at a place. \pre `fits`; the edge is there
  /// \param position in model units
  template <class MeshT>
  void merge(MeshT& mesh, VertexHandle survivor, VertexHandle removed, const Vec3& position) const {
    if (empty()) return;
    merge(mesh, survivor, removed, position, [&mesh](VertexHandle v) { return to_vec3(mesh.point(v)); });
  }

  /// Adds what vertices carry to the attributes of `to`. \pre `fits` \param handles of the vertices of `to`
  void add_to(IndexedMesh& to, const OpenMesh::BaseKernel& mesh, const std::vector<Index>& handles) const;
  /// Gives a vertex what a vertex of `from` has. \pre `from` has the attributes that `add_to` gave it, alone
  void set(const IndexedMesh& from, Index v, OpenMesh::BaseKernel& mesh, VertexHandle to) const;

 private:
  using Column = PropertyColumn<VertexHandle>;
  using PositionOf = std::function<Vec3(VertexHandle)>;  ///< in model units

  template <class PropertyHandle>
  void add(AttributeKind kind, PropertyHandle property) {
    columns_.push_back(std::make_unique<TypedColumn<VertexHandle, PropertyHandle>>("", kind, property));
  }
  void add_those_of_user();
  template <class Real>
  bool add_if(const OpenMesh::BaseProperty& property, int number);
  void merge(OpenMesh::TriConnectivity& mesh, VertexHandle survivor, VertexHandle removed, const Vec3& position,
             const PositionOf& position_of) const;

  std::vector<const OpenMesh::BaseProperty*> properties_;
  std::vector<std::unique_ptr<const Column>> columns_;
};

}  // namespace whittle
