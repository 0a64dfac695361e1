#pragma once

#include "whittle/core/indexed_mesh.hh"

// Meshes whose coordinates are the same to the bit on every machine: numbers with few digits, computed without
// <cmath>'s sine or the like.

namespace whittle::test {

/// An open square of 2 n² faces with hills: n + 1 by n + 1 vertices, heights from a hash of their place.
IndexedMesh hills(unsigned n);

/// A cube with 12 n² faces, each side a grid, whose vertices are pushed about a little.
IndexedMesh rough_cube(unsigned n);

/// Two of them, apart by a hundredth of their size.
IndexedMesh two_cubes(unsigned n);

/// A square of 2 n² faces with a second one standing on its middle line: that line's edges have three faces or four.
IndexedMesh crossed_sheets(unsigned n);

/// The mesh with a texture of two charts and with colours. \pre its coordinates are about 1
IndexedMesh painted(IndexedMesh mesh);

}  // namespace whittle::test
