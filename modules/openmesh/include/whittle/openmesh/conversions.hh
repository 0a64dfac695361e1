#pragma once

#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "whittle/engine/indexed_mesh.hh"
#include "whittle/openmesh/status_bits.hh"

// OpenMesh triangle meshes of any traits, to plain arrays and back.

namespace whittle {

/// A point or normal of any OpenMesh mesh, in double.
template <class PointT>
Vec3 to_vec3(const PointT& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// Rounded to the scalar of the mesh.
template <class PointT>
PointT to_point(const Vec3& p) {
  using Scalar = typename OpenMesh::vector_traits<PointT>::value_type;
  PointT result;
  result[0] = static_cast<Scalar>(p.x());
  result[1] = static_cast<Scalar>(p.y());
  result[2] = static_cast<Scalar>(p.z());
  return result;
}

/// The corners of a face, counter-clockwise, first the one that OpenMesh's FaceVertexIter comes to first.
template <class MeshT>
std::array<OpenMesh::VertexHandle, 3> face_corners(const MeshT& mesh, OpenMesh::FaceHandle face) {
  const OpenMesh::HalfedgeHandle h0 = mesh.halfedge_handle(face);
  const OpenMesh::HalfedgeHandle h1 = mesh.next_halfedge_handle(h0);
  return {mesh.to_vertex_handle(h0), mesh.to_vertex_handle(h1), mesh.to_vertex_handle(mesh.next_halfedge_handle(h1))};
}

namespace detail {

/// OpenMesh keeps colours as floats in [0, 1] or as whole numbers in [0, 255], of three or four channels.
template <class ColorT>
Color from_mesh_color(const ColorT& color) {
  using Traits = OpenMesh::vector_traits<ColorT>;
  Color result{0, 0, 0, 1};
  for (std::size_t channel = 0; channel < Traits::size_; ++channel) {
    result[channel] = static_cast<float>(color[channel]);
    if constexpr (std::is_integral_v<typename Traits::value_type>) result[channel] /= 255;
  }
  return result;
}

template <class ColorT>
ColorT to_mesh_color(const Color& color) {
  using Traits = OpenMesh::vector_traits<ColorT>;
  using Scalar = typename Traits::value_type;
  ColorT result;
  for (std::size_t channel = 0; channel < Traits::size_; ++channel) {
    if constexpr (std::is_integral_v<Scalar>) {
      result[channel] = static_cast<Scalar>(std::lround(std::clamp(color[channel], 0.0F, 1.0F) * 255));
    } else {
      result[channel] = static_cast<Scalar>(color[channel]);
    }
  }
  return result;
}

/// Keeps OpenMesh from printing while it lives.
class QuietOpenMesh {
 public:
  QuietOpenMesh() : was_enabled_(omerr().is_enabled()) { omerr().disable(); }
  ~QuietOpenMesh() {
    if (was_enabled_) omerr().enable();
  }
  QuietOpenMesh(const QuietOpenMesh&) = delete;
  QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;

 private:
  bool was_enabled_;
};

}  // namespace detail

/// Positions and faces of what isn't deleted, in the order of the handles. `origins` says which vertex handle each
/// vertex was, and is empty where that is its own number.
template <class MeshT>
IndexedMesh geometry_of(const MeshT& mesh) {
  static_assert(MeshT::is_trimesh(), "whittle: triangle meshes only");
  IndexedMesh result;
  result.positions.reserve(mesh.n_vertices());
  result.faces.reserve(mesh.n_faces());
  std::vector<Index> number_of(mesh.n_vertices());
  const StatusBitsT<OpenMesh::VertexHandle, const MeshT> vertex_bits(mesh);
  for (int i = 0; i < static_cast<int>(mesh.n_vertices()); ++i) {
    const OpenMesh::VertexHandle v(i);
    if (vertex_bits.is_deleted(v)) continue;
    number_of[static_cast<std::size_t>(i)] = static_cast<Index>(result.positions.size());
    result.positions.push_back(to_vec3(mesh.point(v)));
  }
  if (result.positions.size() < mesh.n_vertices()) {
    for (const OpenMesh::VertexHandle v : mesh.vertices()) result.origins.push_back(static_cast<Index>(v.idx()));
  }
  const StatusBitsT<OpenMesh::FaceHandle, const MeshT> face_bits(mesh);
  for (int i = 0; i < static_cast<int>(mesh.n_faces()); ++i) {
    const OpenMesh::FaceHandle f(i);
    if (face_bits.is_deleted(f)) continue;
    const auto corners = face_corners(mesh, f);
    const auto number = [&](std::size_t corner) { return number_of[static_cast<std::size_t>(corners[corner].idx())]; };
    result.faces.push_back({number(0), number(1), number(2)});
  }
  return result;
}

/// `geometry_of(mesh)` with the vertex normals and colours, where the mesh has them.
template <class MeshT>
IndexedMesh to_indexed_mesh(const MeshT& mesh) {
  IndexedMesh result = geometry_of(mesh);
  for (const OpenMesh::VertexHandle v : mesh.vertices()) {
    if (mesh.has_vertex_normals()) {
      const Vec3 n = to_vec3(mesh.normal(v));
      result.normals.push_back({static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z())});
    }
    if (mesh.has_vertex_colors()) result.colors.push_back(detail::from_mesh_color(mesh.color(v)));
  }
  return result;
}

/// Makes `mesh` a copy of `source`: vertex v becomes handle v, with its normal and colour where both have them (so call
/// `request_vertex_colors()` first). What the mesh held is cleared; its properties stay, their values don't.
/// Positions are rounded to the scalar of the mesh. Texture coordinates and groups are not carried.
/// \return the faces left out, ascending, because a half-edge mesh can't hold them: two equal corners, a third face at
///         an edge, a neighbour turned the other way round, a second closed fan at a vertex.
template <class MeshT>
[[nodiscard]] std::vector<Index> to_open_mesh(const IndexedMesh& source, MeshT& mesh) {
  static_assert(MeshT::is_trimesh(), "whittle: triangle meshes only");
  mesh.clean();
  mesh.reserve(source.positions.size(), source.positions.size() + source.faces.size(), source.faces.size());
  const bool carry_normals = !source.normals.empty() && mesh.has_vertex_normals();
  const bool carry_colors = !source.colors.empty() && mesh.has_vertex_colors();
  for (std::size_t v = 0; v < source.positions.size(); ++v) {
    const OpenMesh::VertexHandle handle = mesh.add_vertex(to_point<typename MeshT::Point>(source.positions[v]));
    if (carry_normals) {
      const auto& n = source.normals[v];
      mesh.set_normal(handle, to_point<typename MeshT::Normal>(Vec3(n[0], n[1], n[2])));
    }
    if (carry_colors) {
      mesh.set_color(handle, detail::to_mesh_color<typename MeshT::Color>(source.colors[v]));
    }
  }
  const detail::QuietOpenMesh quiet;  // what it would print is what we return
  std::vector<Index> refused;
  for (std::size_t f = 0; f < source.faces.size(); ++f) {
    const auto [a, b, c] = source.faces[f];
    const bool degenerate = a == b || b == c || c == a;
    const auto handle = [](Index v) { return OpenMesh::VertexHandle(static_cast<int>(v)); };
    if (degenerate || !mesh.add_face(handle(a), handle(b), handle(c)).is_valid()) {
      refused.push_back(static_cast<Index>(f));
    }
  }
  return refused;
}

}  // namespace whittle
