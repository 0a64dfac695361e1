#pragma once

#include <span>

#include "whittle/core/indexed_mesh.hh"

// Positions in files with 32-bit numbers. These have 24 binary digits: the farther a mesh lies from the origin, the
// fewer are left for its shape.

namespace whittle {

/// Whether 32-bit numbers represent each coordinate exactly.
bool fit_float32(std::span<const Vec3> points);

/// A point after a round trip through a file with 32-bit numbers relative to `origin`.
Vec3 rounded_to_float32(const Vec3& point, const Vec3& origin = Vec3::Zero());

/// Largest distance by which rounding to 32 bits moves a point, model units.
double float32_error(std::span<const Vec3> points);

/// The origin of 32-bit numbers with which rounding moves points by at most a millionth of their box's diagonal. It is
/// 0 along axes where the points lie within 16 diagonals of 0 (16 · 2^-24 is a millionth), else the middle of the box.
/// It is exact in 32-bit numbers, and so are differences from it.
Vec3 float32_origin(std::span<const Vec3> points);

}  // namespace whittle
