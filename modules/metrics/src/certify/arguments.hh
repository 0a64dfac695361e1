#pragma once

namespace whittle::metrics {

/// \throw std::invalid_argument if it is negative or not a number
void require_distance(double max_distance);
/// \throw std::invalid_argument if it is not in [1e-6, 1]
void require_accuracy(double relative_accuracy);

}  // namespace whittle::metrics
