#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/frame.hh"

namespace whittle {

struct CurvePoint {
  std::uint32_t cell;  ///< index along the curve, 30 bits
  Index number;        ///< of the position
};

/// Sorts positions along a Morton curve through their bounding box in the frame, with 1024 cells a side. Positions in
/// the same cell are sorted by number.
std::vector<CurvePoint> along_morton_curve(std::span<const Vec3> positions, const Frame& frame, unsigned threads);

/// The same, numbers only.
std::vector<Index> morton_order(std::span<const Vec3> positions, const Frame& frame, unsigned threads);

}  // namespace whittle
