#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "whittle/core/attribute_blend.hh"
#include "whittle/core/attribute_functions.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/segment.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/local_functions.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/detail/attributes/property_column.hh"

namespace whittle {

/// What vertices carry, when some become one: texture coordinates, colours, normals, and the user's properties of real
/// numbers (float, double, OpenMesh's vectors of them) that have a name. A merged vertex gets what the surface has
/// around the place where it goes (`AttributeFunctions`). All other properties stay those of the vertex that survives:
/// whole numbers name things.
template <class MeshT>
class VertexAttributesT {
 public:
  using VertexHandle = OpenMesh::VertexHandle;

  explicit VertexAttributesT(const MeshT& mesh) : properties_(mesh.vprops_begin(), mesh.vprops_end()) {
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

  /// Gives the survivor of an edge what the faces around both vertices have at a place. \pre `fits`; the edge is there
  /// \param position in model units
  void merge(MeshT& mesh, VertexHandle survivor, VertexHandle removed, const Vec3& position) {
    if (empty()) return;
    Ring ring = ring_of(mesh, survivor, removed);
    add_to(ring.mesh, mesh, ring.handles);
    const Frame frame = Frame::of_points(ring.mesh.positions);
    std::vector<Index> map(ring.handles.size(), invalid_index);
    map[0] = map[1] = 0;
    const LocalFunctions functions(ring.mesh, frame, map, 1, 1);
    const double share = nearest_share(position, ring.mesh.positions[0], ring.mesh.positions[1]);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Attribute& around = ring.mesh.attributes[i];
      AttributeBlend mean(around.kind, around.n_components);
      mean.add(around.value(0), 1 - share);
      mean.add(around.value(1), share);
      std::vector<double> value(around.n_components);
      if (!mean.result(value)) continue;
      if (position != ring.mesh.positions[1]) {
        AttributeFunctions(functions, around.kind, around.n_components, around.values, 1)
            .move(0, frame.to_frame(position), value);
      }
      columns_[i]->set(mesh, survivor, value);
    }
  }

  /// Adds what vertices carry to the attributes of `to`. \pre `fits` \param handles of the vertices of `to`
  template <class Handles>
  void add_to(IndexedMesh& to, const MeshT& mesh, const Handles& handles) const {
    for (const auto& column : columns_) {
      Attribute attribute = column->attribute();
      const std::size_t n = attribute.n_components;
      attribute.values.resize(n * handles.size());
      for (std::size_t v = 0; v < handles.size(); ++v) {
        column->get(mesh, VertexHandle(static_cast<int>(handles[v])), std::span(attribute.values).subspan(n * v, n));
      }
      to.attributes.push_back(std::move(attribute));
    }
  }
  /// Gives a vertex what a vertex of `from` has. \pre `from` has the attributes that `add_to` gave it, alone
  void set(const IndexedMesh& from, Index v, MeshT& mesh, VertexHandle to) const {
    for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i]->set(mesh, to, from.attributes[i].value(v));
  }

 private:
  using Column = PropertyColumnT<MeshT, VertexHandle>;
  /// The faces around two vertices: those are the first.
  struct Ring {
    IndexedMesh mesh;
    std::vector<Index> handles;
  };

  static Ring ring_of(const MeshT& mesh, VertexHandle first, VertexHandle second) {
    Ring ring;
    const auto number_of = [&](VertexHandle v) {
      const auto handle = static_cast<Index>(v.idx());
      const auto known = std::find(ring.handles.begin(), ring.handles.end(), handle);
      const auto number = static_cast<Index>(known - ring.handles.begin());
      if (known != ring.handles.end()) return number;
      ring.handles.push_back(handle);
      ring.mesh.positions.push_back(to_vec3(mesh.point(v)));
      return number;
    };
    number_of(first);
    number_of(second);
    for (const VertexHandle v : {first, second}) {
      for (const OpenMesh::FaceHandle f : mesh.vf_range(v)) {
        const auto corners = face_corners(mesh, f);
        if (v == second && std::find(corners.begin(), corners.end(), first) != corners.end()) continue;
        ring.mesh.faces.push_back({number_of(corners[0]), number_of(corners[1]), number_of(corners[2])});
      }
    }
    return ring;
  }

  /// OpenMesh's own are called "v:…", those that have no name, as modules' of decimaters, "<vprop>".
  static bool is_of_user(const std::string& name) {
    return !name.empty() && !name.starts_with("v:") && !name.starts_with('<') && !name.starts_with("whittle:");
  }

  template <class PropertyHandle>
  void add(AttributeKind kind, PropertyHandle property) {
    columns_.push_back(std::make_unique<TypedColumnT<MeshT, VertexHandle, PropertyHandle>>("", kind, property));
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
  std::vector<std::unique_ptr<const Column>> columns_;
};

}  // namespace whittle
