#pragma once

#include <span>

#include "whittle/core/indexed_mesh.hh"

// Positions in files whose numbers have 32 bits: these hold 24 binary digits, and the farther a mesh lies from the
// origin, the fewer are left for its shape.

namespace whittle {

/// Whether 32-bit numbers hold each coordinate exactly.
bool fit_float32(std::span<const Vec3> points);

/// A point as it is read again from a file that has 32-bit numbers, which count from `origin`.
Vec3 rounded_to_float32(const Vec3& point, const Vec3& origin = Vec3::Zero());

/// How far rounding to 32 bits moves a point, at most; model units.
double float32_error(std::span<const Vec3> points);

/// Where 32-bit numbers should count from, so that they round points by a millionth of their box's diagonal at most:
/// the origin if these lie no farther from it than 16 diagonals (16 · 2^-24 is a millionth), else the middle of the box
/// along those axes where it is far. Fits 32-bit numbers itself. Differences to it are exact.
Vec3 float32_origin(std::span<const Vec3> points);

}  // namespace whittle
