#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "whittle/core/attribute_blend.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/openmesh/detail/attributes/property_column.hh"

namespace whittle {

/// How far along the edge from `from` to `to` a point lies, as a share in [0, 1].
inline double share_along(const Vec3& from, const Vec3& to, const Vec3& point) {
  const Vec3 way = to - from;
  const double length_sq = way.squaredNorm();
  return length_sq > 0 ? std::clamp((point - from).dot(way) / length_sq, 0.0, 1.0) : 0;
}

/// Blends what vertices carry when two become one: texture coordinates, colours, normals, and the user's properties of
/// real numbers (float, double, OpenMesh's vectors of them) that have a name. All other properties stay those of the
/// vertex that survives: whole numbers name things.
template <class MeshT>
class VertexBlendT {
 public:
  using VertexHandle = OpenMesh::VertexHandle;

  explicit VertexBlendT(const MeshT& mesh) : properties_(mesh.vprops_begin(), mesh.vprops_end()) {
    if (mesh.has_vertex_texcoords1D()) add(AttributeKind::scalar, mesh.vertex_texcoords1D_pph());
    if (mesh.has_vertex_texcoords2D()) add(AttributeKind::scalar, mesh.vertex_texcoords2D_pph());
    if (mesh.has_vertex_texcoords3D()) add(AttributeKind::scalar, mesh.vertex_texcoords3D_pph());
    if (mesh.has_vertex_colors()) add(AttributeKind::scalar, mesh.vertex_colors_pph());
    if (mesh.has_vertex_normals()) add(AttributeKind::normal, mesh.vertex_normals_pph());
    int number = 0;
    for (auto property = mesh.vprops_begin(); property != mesh.vprops_end(); ++property, ++number) {
      if (*property == nullptr || !is_of_user((*property)->name())) continue;
      add_if_real<float, double, OpenMesh::Vec2f, OpenMesh::Vec3f, OpenMesh::Vec4f, OpenMesh::Vec2d, OpenMesh::Vec3d,
                  OpenMesh::Vec4d>(**property, number);
    }
  }

  bool empty() const { return columns_.empty(); }
  /// Whether the mesh has the same properties as before.
  bool fits(const MeshT& mesh) const {
    return std::equal(mesh.vprops_begin(), mesh.vprops_end(), properties_.begin(), properties_.end());
  }

  /// \pre `fits`
  /// \param share of the removed vertex, [0, 1]; 0 changes nothing
  void blend(MeshT& mesh, VertexHandle survivor, VertexHandle removed, double share) {
    if (!(share > 0)) return;
    for (auto& [column, mean] : columns_) {
      values_.resize(column->attribute().n_components);
      column->get(mesh, removed, values_);
      mean.add(values_, share);
      column->get(mesh, survivor, values_);
      mean.add(values_, 1 - share);
      if (mean.result(values_)) column->set(mesh, survivor, values_);
    }
  }

 private:
  using Column = PropertyColumnT<MeshT, VertexHandle>;
  struct Blended {
    std::unique_ptr<const Column> column;
    AttributeBlend mean;
  };

  /// OpenMesh's own are called "v:…", those that have no name, as modules' of decimaters, "<vprop>".
  static bool is_of_user(const std::string& name) {
    return !name.empty() && !name.starts_with("v:") && !name.starts_with('<') && !name.starts_with("whittle:");
  }

  template <class PropertyHandle>
  void add(AttributeKind kind, PropertyHandle property) {
    auto column = std::make_unique<TypedColumnT<MeshT, VertexHandle, PropertyHandle>>("", kind, property);
    const AttributeBlend mean(kind, column->attribute().n_components);
    columns_.push_back({std::move(column), mean});
  }

  template <class... Reals>
  void add_if_real(const OpenMesh::BaseProperty& property, int number) {
    const auto add_if = [&]<class Real>(const Real*) {
      if (dynamic_cast<const OpenMesh::PropertyT<Real>*>(&property) == nullptr) return;
      add(AttributeKind::scalar, OpenMesh::VPropHandleT<Real>(number));
    };
    (add_if(static_cast<const Reals*>(nullptr)), ...);
  }

  std::vector<const OpenMesh::BaseProperty*> properties_;
  std::vector<Blended> columns_;
  std::vector<double> values_;  ///< scratch
};

}  // namespace whittle
