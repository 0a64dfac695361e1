#pragma once

#include <algorithm>
#include <cmath>

namespace whittle {

/// Finds the cost at which a sample of blocks has few enough vertices left, by going up step by step: what is
/// contracted on the way stays contracted.
class CostLadder {
 public:
  /// \param face_area mean area of the input's faces, in the frame
  explicit CostLadder(double face_area)
      : cost_(std::max(lowest, least_share * face_area * face_area * std::sqrt(face_area))) {}

  /// The step to run up to.
  double cost() const { return cost_; }

  /// \param excess how many times as many vertices are left as there should be
  /// \return whether another step follows
  bool climb(double excess) {
    if (!(excess > 1) || cost_ > highest) return false;
    cost_ *= excess > 4 ? 4 : excess > 2 ? 2 : 1.2;
    return true;
  }

 private:
  static constexpr double least_share = 1e-12;  ///< on flat ground contractions cost almost nothing
  static constexpr double lowest = 1e-60;       ///< faces may have no area
  static constexpr double highest = 1e30;

  double cost_;
};

}  // namespace whittle
