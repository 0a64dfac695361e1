#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle {

/// Makes a face's box hold it where its corners are there.
inline void extend(Eigen::AlignedBox3f& box, const Triangle& face, std::span<const Vec3> positions) {
  for (const Index v : face) box.extend(positions[v].cast<float>());
}

/// All pairs of boxes that have a point in common, each once, the lower number first, always in the same order.
/// In single precision: boxes that overlap do so when rounded, too.
std::vector<std::array<Index, 2>> overlapping_boxes(std::span<const Eigen::AlignedBox3f> boxes, unsigned threads);

}  // namespace whittle
