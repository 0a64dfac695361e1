#pragma once

#include <cstdint>
#include <vector>
#include <whittle/core/indexed_mesh.hh>

/// The same mesh at another position, in another size or in another order. Results must not depend on these.
namespace whittle::test {

/// Turned about `axis` (any length but zero) by `angle_deg`; normals too.
IndexedMesh rotated(const IndexedMesh& mesh, const Vec3& axis, double angle_deg);
/// Turned about a random axis by a random angle.
IndexedMesh rotated(const IndexedMesh& mesh, std::uint64_t seed);
/// All coordinates times `factor`, greater than 0.
IndexedMesh scaled(const IndexedMesh& mesh, double factor);
IndexedMesh moved(const IndexedMesh& mesh, const Vec3& offset);

struct Permuted {
  IndexedMesh mesh;               ///< Attributes follow their elements; `origins` is empty.
  std::vector<Index> old_vertex;  ///< V; new vertex v was vertex old_vertex[v].
  std::vector<Index> old_face;    ///< F; new face f was face old_face[f], with the same first corner.
};
/// Vertices and faces in another order.
Permuted permuted(const IndexedMesh& mesh, std::uint64_t seed);

/// Length of the diagonal of the bounding box of all positions; 0 without any.
double diagonal(const IndexedMesh& mesh);

}  // namespace whittle::test
