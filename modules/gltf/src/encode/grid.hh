#pragma once

#include <optional>
#include <span>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::gltf {

/// The largest whole number that 24 bits with a sign hold.
inline constexpr double largest_mantissa = 0x1p23 - 1;

/// Positions are multiples of a power of two, so that they need few bits.
struct Grid {
  int exponent = 0;  ///< of the step
  /// If there is one, positions are written as integers: steps from here. A multiple of the step.
  std::optional<Vec3> origin;

  double step() const;
};

/// The coarsest with 2^16 steps along the longest side of all positions. Empty where 24 bits wouldn't do: far away from
/// the origin.
std::optional<Grid> grid_of(const IndexedMesh& triangles);
/// The finest with an origin for which positions fit into 16 bits, and morph targets into 16 bits with a sign. Empty
/// if the meshes have no size, or are so far from the origin that 52 bits wouldn't do.
std::optional<Grid> integer_grid_of(std::span<const IndexedMesh* const> meshes);

}  // namespace whittle::gltf
