#pragma once

namespace whittle {

/// What is known of the distance of a surface from another one.
enum class Verdict {
  proven,   ///< each point is within the distance
  refuted,  ///< a point is farther
  undecided  ///< the largest distance is too near to the limit: by rounding errors, 10⁻¹⁴ of the size of both, or so
             ///< that a triangle was split into 65,536 pieces in vain
};

}  // namespace whittle
