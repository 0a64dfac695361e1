#pragma once

namespace whittle {

/// Result of a proof about the distance of a surface from another surface.
enum class Verdict {
  proven,   ///< each point is within the distance
  refuted,  ///< a point is farther
  /// The largest distance is too near the limit: within rounding errors, 10⁻¹⁴ of the size of both, or 65,536 pieces of
  /// a triangle don't decide.
  undecided
};

}  // namespace whittle
