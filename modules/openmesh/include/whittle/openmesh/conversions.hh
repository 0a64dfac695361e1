#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/manifold_cut.hh"
#include "whittle/openmesh/vertex_copies.hh"

// Converts OpenMesh triangle meshes with any traits to plain arrays and back.

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

/// The corners of a face, counter-clockwise, in the order of OpenMesh's FaceVertexIter.
inline std::array<OpenMesh::VertexHandle, 3> face_corners(const OpenMesh::ArrayKernel& mesh,
                                                          OpenMesh::FaceHandle face) {
  const OpenMesh::HalfedgeHandle h0 = mesh.halfedge_handle(face);
  const OpenMesh::HalfedgeHandle h1 = mesh.next_halfedge_handle(h0);
  return {mesh.to_vertex_handle(h0), mesh.to_vertex_handle(h1), mesh.to_vertex_handle(mesh.next_halfedge_handle(h1))};
}

/// The bounding box of the vertices that aren't deleted.
template <class MeshT>
Box mesh_bounds(const MeshT& mesh) {
  Box box;
  for (const OpenMesh::VertexHandle v : mesh.vertices()) box.extend(to_vec3(mesh.point(v)));
  return box.isEmpty() ? bounds_of(std::span<const Vec3>()) : box;
}

namespace detail {

/// OpenMesh has colours of three or four channels, as floats in [0, 1] or integers in [0, 255].
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

/// What is done with copies of a vertex (`vertex_copies.hh`).
enum class Copies {
  joined,  ///< copies at exactly one position become one vertex again
  apart    ///< each copy is a vertex, as in the mesh
};

namespace detail {

/// The vertices that aren't deleted, numbered in the order of the handles. Of copies only the first is numbered.
struct VertexNumbers {
  std::vector<Index> number_of;  ///< by handle; copies have the number of the first. Undefined for deleted vertices
  std::vector<Index> handles;    ///< by number, ascending
};

/// \param firsts of copies (`first_copies`)
VertexNumbers number_vertices(const OpenMesh::ArrayKernel& mesh, const std::vector<Index>& firsts);

template <class MeshT>
VertexNumbers number_vertices(const MeshT& mesh, Copies copies) {
  return number_vertices(mesh, copies == Copies::joined ? first_copies(mesh) : std::vector<Index>{});
}

/// The faces that aren't deleted, in the order of the handles.
std::vector<Triangle> faces_of(const OpenMesh::ArrayKernel& mesh, const VertexNumbers& numbers);

/// Positions, faces and origins.
template <class MeshT>
IndexedMesh geometry_of(const MeshT& mesh, const VertexNumbers& numbers) {
  static_assert(MeshT::is_trimesh(), "whittle: triangle meshes only");
  IndexedMesh result;
  result.positions.reserve(numbers.handles.size());
  for (const Index v : numbers.handles) {
    result.positions.push_back(to_vec3(mesh.point(OpenMesh::VertexHandle(static_cast<int>(v)))));
  }
  if (!numbers.handles.empty() && numbers.handles.back() >= numbers.handles.size()) result.origins = numbers.handles;
  result.faces = faces_of(mesh, numbers);
  return result;
}

}  // namespace detail

/// Positions and faces that aren't deleted, in the order of the handles. Copies of a vertex are one vertex, at the
/// index of the first. `origins` is the handle of each vertex; it is empty if all handles equal their numbers.
template <class MeshT>
IndexedMesh geometry_of(const MeshT& mesh, Copies copies = Copies::joined) {
  return detail::geometry_of(mesh, detail::number_vertices(mesh, copies));
}

/// `geometry_of(mesh)` with vertex normals and colours if the mesh has them; copies have those of the first.
template <class MeshT>
IndexedMesh to_indexed_mesh(const MeshT& mesh, Copies copies = Copies::joined) {
  const detail::VertexNumbers numbers = detail::number_vertices(mesh, copies);
  IndexedMesh result = detail::geometry_of(mesh, numbers);
  for (const Index handle : numbers.handles) {
    const OpenMesh::VertexHandle v(static_cast<int>(handle));
    if (mesh.has_vertex_normals()) {
      const Vec3 n = to_vec3(mesh.normal(v));
      result.normals.push_back({static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z())});
    }
    if (mesh.has_vertex_colors()) result.colors.push_back(detail::from_mesh_color(mesh.color(v)));
  }
  return result;
}

/// What is done where a half-edge mesh can't hold vertices or edges.
enum class NonManifold {
  cut,    ///< vertices are cut into copies (`cut_into_manifold`); no face is lost
  refuse  ///< faces that don't fit to those added before are left out
};

namespace detail {

/// Adds vertices, with normals and colours if both sides have them.
template <class MeshT>
class VertexAdder {
 public:
  VertexAdder(const IndexedMesh& source, MeshT& mesh)
      : source_(source),
        mesh_(mesh),
        carry_normals_(!source.normals.empty() && mesh.has_vertex_normals()),
        carry_colors_(!source.colors.empty() && mesh.has_vertex_colors()) {}

  /// Adds a copy of vertex v of the source.
  OpenMesh::VertexHandle add(Index v) const {
    const OpenMesh::VertexHandle handle = mesh_.add_vertex(to_point<typename MeshT::Point>(source_.positions[v]));
    if (carry_normals_) {
      const auto& n = source_.normals[v];
      mesh_.set_normal(handle, to_point<typename MeshT::Normal>(Vec3(n[0], n[1], n[2])));
    }
    if (carry_colors_) mesh_.set_color(handle, to_mesh_color<typename MeshT::Color>(source_.colors[v]));
    return handle;
  }

 private:
  const IndexedMesh& source_;
  MeshT& mesh_;
  bool carry_normals_;
  bool carry_colors_;
};

/// \return faces that the mesh doesn't take, or that have two equal corners
template <class MeshT>
std::vector<Index> add_faces(const std::vector<Triangle>& faces, MeshT& mesh) {
  const QuietOpenMesh quiet;  // it would print what we return
  std::vector<Index> refused;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto [a, b, c] = faces[f];
    const auto handle = [](Index v) { return OpenMesh::VertexHandle(static_cast<int>(v)); };
    if (!has_three_corners(faces[f]) || !mesh.add_face(handle(a), handle(b), handle(c)).is_valid()) {
      refused.push_back(static_cast<Index>(f));
    }
  }
  return refused;
}

}  // namespace detail

/// Makes `mesh` a copy of `source`: vertex v becomes handle v, with normal and colour if both have them. (So call
/// `request_vertex_colors()` first.) The old content of the mesh is cleared. Its properties stay, their values don't.
/// Positions are rounded to the scalar of the mesh. Texture coordinates and groups are not carried.
///
/// Where vertices are cut, the added copies have handles after all others. The property `copies_property` says which
/// belong together, and `to_indexed_mesh` gives the source's vertices and faces back.
/// \return the faces left out, ascending: those with two equal corners. With `NonManifold::refuse` also a third face at
///         an edge, a neighbour of opposite orientation, and a second closed fan at a vertex
template <class MeshT>
[[nodiscard]] std::vector<Index> to_open_mesh(const IndexedMesh& source, MeshT& mesh,
                                              NonManifold non_manifold = NonManifold::cut) {
  static_assert(MeshT::is_trimesh(), "whittle: triangle meshes only");
  const std::size_t n_vertices = source.positions.size();
  ManifoldCut cut;
  if (non_manifold == NonManifold::cut) cut = cut_into_manifold(n_vertices, source.faces);
  mesh.clean();
  mesh.reserve(n_vertices + cut.originals.size(), n_vertices + source.faces.size(), source.faces.size());
  const detail::VertexAdder<MeshT> vertices(source, mesh);
  for (Index v = 0; v < n_vertices; ++v) vertices.add(v);
  if (!cut.originals.empty()) {
    const OpenMesh::VPropHandleT<int> copies = require_copies_property(mesh);
    for (const Index original : cut.originals) {
      const int number = static_cast<int>(original) + 1;
      mesh.property(copies, vertices.add(original)) = number;
      mesh.property(copies, OpenMesh::VertexHandle(static_cast<int>(original))) = number;
    }
  }
  return detail::add_faces(non_manifold == NonManifold::cut ? cut.faces : source.faces, mesh);
}

}  // namespace whittle
