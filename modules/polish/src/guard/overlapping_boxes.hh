#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Makes a face's box hold it where its corners are there.
inline void extend(Eigen::AlignedBox3f& box, const Triangle& face, std::span<const Vec3> positions) {
  for (const Index v : face) box.extend(positions[v].cast<float>());
}

inline int n_common_corners(const Triangle& s, const Triangle& t) {
  int n = 0;
  for (const Index v : s) n += int{v == t[0]} | int{v == t[1]} | int{v == t[2]};
  return n;
}

/// All pairs of boxes that have a point in common, each once, the lower number first, always in the same order.
/// In single precision: boxes that overlap do so when rounded, too.
/// \param faces whose boxes they are: then without those that have a corner in common; or none
std::vector<std::array<Index, 2>> overlapping_boxes(std::span<const Eigen::AlignedBox3f> boxes,
                                                    std::span<const Triangle> faces, unsigned threads);

}  // namespace whittle
