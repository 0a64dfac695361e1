#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/frame.hh"

namespace whittle {

struct CurvePoint {
  std::uint32_t cell;  ///< its place along the curve, 30 bits
  Index number;        ///< of the position
};

/// The positions along a Morton curve through their bounding box in the frame, 1024 cells a side; equal cells by
/// number.
std::vector<CurvePoint> along_morton_curve(std::span<const Vec3> positions, const Frame& frame, unsigned threads);

/// Their numbers alone.
std::vector<Index> morton_order(std::span<const Vec3> positions, const Frame& frame, unsigned threads);

}  // namespace whittle
