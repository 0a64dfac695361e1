#pragma once

#include <span>
#include <vector>

#include "whittle/engine/frame.hh"

namespace whittle {

/// The positions' numbers along a Morton curve through their bounding box in the frame, 1024 cells a side; equal cells
/// by number.
std::vector<Index> morton_order(std::span<const Vec3> positions, const Frame& frame, unsigned threads);

}  // namespace whittle
