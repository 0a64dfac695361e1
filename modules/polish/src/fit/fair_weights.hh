#pragma once

#include <cmath>

#include "fit/two_sided_error.hh"
#include "whittle/core/detail/portable_math.hh"

// Fair's weights. Up to a unit distance a point counts by its squared distance, beyond that by its distance.
// \cite holland_1977_robust

namespace whittle::polishing {

using Distances = std::vector<TwoSidedError::Distance>;

/// The unit of Fair's weights.
inline double root_mean_square(const Distances& distances) {
  double sum = 0;
  for (const auto& [square, weight] : distances) sum += weight * square;
  return std::sqrt(sum);
}

/// The weight of a point at a distance.
inline double fair_weight(double distance, double unit) { return 1 / (1 + std::abs(distance) / unit); }

/// What a fit with Fair's weights minimises.
inline double fair_loss(const Distances& distances, double unit) {
  double sum = 0;
  for (const auto& [square, weight] : distances) {
    const double x = std::sqrt(square) / unit;
    sum += weight * (x - detail::log_of_one_plus(x));
  }
  return sum;
}

}  // namespace whittle::polishing
