#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// How far along the edge from `from` to `to` a point lies, as a share in [0, 1].
inline double share_along(const Vec3& from, const Vec3& to, const Vec3& point) {
  const Vec3 way = to - from;
  const double length_sq = way.squaredNorm();
  return length_sq > 0 ? std::clamp((point - from).dot(way) / length_sq, 0.0, 1.0) : 0;
}

/// Whether vertices have attributes that `blend_attributes` interpolates.
template <class MeshT>
bool has_vertex_attributes(const MeshT& mesh) {
  return mesh.has_vertex_texcoords1D() || mesh.has_vertex_texcoords2D() || mesh.has_vertex_texcoords3D() ||
         mesh.has_vertex_colors() || mesh.has_vertex_normals();
}

/// Interpolates texture coordinates, colours and normals of a merged vertex between both vertices.
/// Colours that are integers are rounded to the nearest.
/// \param share of the removed vertex, [0, 1]; 0 changes nothing
template <class MeshT>
void blend_attributes(MeshT& mesh, OpenMesh::VertexHandle survivor, OpenMesh::VertexHandle removed, double share) {
  if (!(share > 0)) return;
  const auto between = [share](const auto& kept, const auto& other, std::size_t size) {
    auto result = kept;
    for (std::size_t i = 0; i < size; ++i) {
      using Scalar = std::decay_t<decltype(kept[i])>;
      const double value = (1 - share) * static_cast<double>(kept[i]) + share * static_cast<double>(other[i]);
      result[i] = static_cast<Scalar>(std::is_integral_v<Scalar> ? std::round(value) : value);
    }
    return result;
  };
  if (mesh.has_vertex_texcoords1D()) {
    const auto kept = static_cast<double>(mesh.texcoord1D(survivor));
    const auto other = static_cast<double>(mesh.texcoord1D(removed));
    mesh.set_texcoord1D(survivor, static_cast<typename MeshT::TexCoord1D>((1 - share) * kept + share * other));
  }
  if (mesh.has_vertex_texcoords2D()) {
    mesh.set_texcoord2D(survivor, between(mesh.texcoord2D(survivor), mesh.texcoord2D(removed), 2));
  }
  if (mesh.has_vertex_texcoords3D()) {
    mesh.set_texcoord3D(survivor, between(mesh.texcoord3D(survivor), mesh.texcoord3D(removed), 3));
  }
  if (mesh.has_vertex_colors()) {
    mesh.set_color(survivor, between(mesh.color(survivor), mesh.color(removed), MeshT::Color::size()));
  }
  if (mesh.has_vertex_normals()) {
    auto normal = between(mesh.normal(survivor), mesh.normal(removed), 3);
    const auto length = normal.length();
    if (length > 0) mesh.set_normal(survivor, normal / length);
  }
}

}  // namespace whittle
