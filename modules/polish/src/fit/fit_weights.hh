#pragma once

#include <cmath>

#include "fit/two_sided_error.hh"
#include "whittle/core/detail/portable_math.hh"

namespace whittle::polishing {

inline double root_mean_square(const Distances& distances) {
  double sum = 0;
  for (const auto& [square, weight] : distances) sum += weight * square;
  return std::sqrt(sum);
}

/// Weights of points by their distance. With Fair's weights a point counts by its squared distance up to a unit, and by
/// its distance beyond that. \cite holland_1977_robust
/// Where the largest distance matters, far points count by their squared distances.
class FitWeights {
 public:
  /// \param unit of Fair's weights \param far distance of far points, in units; infinite: Fair's weights alone
  FitWeights(double unit, double far) : unit_(unit), far_(far) {}

  double weight(double distance) const {
    const double x = std::abs(distance) / unit_;
    return 1 / (1 + x) + far_weight(x);
  }

  /// The loss that a fit with these weights minimises.
  double loss(const Distances& distances) const {
    double sum = 0;
    for (const auto& [square, weight] : distances) {
      const double x = std::sqrt(square) / unit_;
      sum += weight * (x - detail::log_of_one_plus(x) + far_loss(x));
    }
    return sum;
  }

 private:
  double far_weight(double x) const {
    const double share = x / far_;
    const double square = share * share;
    return x < far_ ? square * square * square : 1;
  }
  /// The integral of x · far_weight(x).
  double far_loss(double x) const {
    return x < far_ ? far_weight(x) * x * x / 8 : far_ * far_ / 8 + (x * x - far_ * far_) / 2;
  }

  double unit_;
  double far_;
};

}  // namespace whittle::polishing
