#pragma once

#include <cstdint>

#include "whittle/core/indexed_mesh.hh"

// Large meshes out of small ones.

namespace whittle::bench {

/// One step of Loop's subdivision (with Warren's weights): four faces for each. Old vertices first, then those of the
/// edges in the order in which the faces come to them. Edges with one face are borders; those with more than two take
/// the rule of the border. Source: Loop: Smooth Subdivision Surfaces Based on Triangles (1987).
IndexedMesh loop_subdivided(const IndexedMesh& mesh);

/// Each vertex moved along its normal by at most `amplitude` times the mean edge length, at random.
IndexedMesh with_noise(IndexedMesh mesh, double amplitude, std::uint64_t seed);

/// The unit sphere: each face of the icosahedron cut into `frequency`² faces. F 20·frequency².
IndexedMesh geodesic_sphere(int frequency);

}  // namespace whittle::bench
