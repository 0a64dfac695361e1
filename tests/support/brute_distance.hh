#pragma once

#include <array>
#include <cstddef>

#include "support/random.hh"
#include "whittle/core/indexed_mesh.hh"

// Distances to surfaces by looking at each face, for tests of what finds them faster.

namespace whittle::test {

using Corners = std::array<Vec3, 3>;

Corners corners_of(const IndexedMesh& mesh, Index face);

/// The corners may coincide.
double distance_to_triangle(const Corners& triangle, const Vec3& point);

/// Infinite if the mesh has no faces.
double distance_to_all(const IndexedMesh& mesh, const Vec3& point);

/// Any triangles: folded, crossing, with corners that are one, with edges of any number of faces.
IndexedMesh random_faces(std::size_t n_faces, Random& random);

}  // namespace whittle::test
