#pragma once

#include <cstdint>

#include "whittle/core/indexed_mesh.hh"

// Makes large meshes from small ones.

namespace whittle::bench {

/// One step of Loop's subdivision (with Warren's weights): each face becomes four. Old vertices come first, then the
/// edges' vertices in the order of the edges' first faces. Edges with one face are borders; those with more than two
/// use the border rule. Source: Loop: Smooth Subdivision Surfaces Based on Triangles (1987).
IndexedMesh loop_subdivided(const IndexedMesh& mesh);

/// Moves each vertex along its normal at random, by at most `amplitude` times the mean edge length.
IndexedMesh with_noise(IndexedMesh mesh, double amplitude, std::uint64_t seed);

/// The unit sphere: each face of the icosahedron cut into `frequency`² faces. F 20·frequency².
IndexedMesh geodesic_sphere(int frequency);

}  // namespace whittle::bench
