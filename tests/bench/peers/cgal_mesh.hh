#pragma once

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "bench/peers/peer_arrays.hh"

namespace whittle::bench {

using CgalKernel = CGAL::Simple_cartesian<double>;
/// The usual mesh of CGAL, with coordinates in double.
template <class Kernel = CgalKernel>
using CgalMesh = CGAL::Surface_mesh<typename Kernel::Point_3>;

/// \throw std::runtime_error if a half-edge mesh can't hold all faces
template <class Kernel = CgalKernel>
CgalMesh<Kernel> cgal_mesh_of(const IndexedMesh& input) {
  using Mesh = CgalMesh<Kernel>;
  Mesh mesh;
  const auto size = [](std::size_t n) { return static_cast<typename Mesh::size_type>(n); };
  mesh.reserve(size(input.positions.size()), size(input.positions.size() + input.faces.size()),
               size(input.faces.size()));
  for (const Vec3& p : input.positions) mesh.add_vertex(typename Kernel::Point_3(p.x(), p.y(), p.z()));
  std::size_t n_refused = 0;
  for (const auto& [a, b, c] : input.faces) {
    using Vertex = typename Mesh::Vertex_index;
    if (mesh.add_face(Vertex(a), Vertex(b), Vertex(c)) == Mesh::null_face()) ++n_refused;
  }
  require_none_refused(n_refused, input.faces.size());
  return mesh;
}

/// \pre no garbage
template <class Mesh>
IndexedMesh arrays_of_cgal(const Mesh& mesh) {
  IndexedMesh result;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    result.positions.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : mesh.faces()) {
    Triangle corners{};
    std::size_t i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) corners[i++] = v;
    result.faces.push_back(corners);
  }
  return result;
}

}  // namespace whittle::bench
