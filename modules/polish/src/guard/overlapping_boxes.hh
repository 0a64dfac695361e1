#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::polishing {

/// Extends a box by a face with its corners at these positions.
inline void extend(Eigen::AlignedBox3f& box, const Triangle& face, std::span<const Vec3> positions) {
  for (const Index v : face) box.extend(positions[v].cast<float>());
}

/// All pairs of boxes that have a common point, each once, with the lower number first, and always in the same order.
/// It is fast where successive boxes are near each other. Boxes in single precision are enough: rounding keeps
/// overlapping boxes overlapping. \param faces the boxes' faces: pairs of faces with a common corner are left out; or
/// empty \throw Cancelled
std::vector<std::array<Index, 2>> overlapping_boxes(std::span<const Eigen::AlignedBox3f> boxes,
                                                    std::span<const Triangle> faces, const detail::Workers& workers);

}  // namespace whittle::polishing
