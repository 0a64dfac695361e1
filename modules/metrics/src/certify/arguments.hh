#pragma once

#include <cstddef>
#include <span>

namespace whittle::metrics {

/// \throw std::invalid_argument if it is negative or not a number
void require_distance(double max_distance);
/// \throw std::invalid_argument if there are some, but not as many as vertices, or one isn't positive, or the distance
///        is infinite
void require_tolerances(std::span<const double> tolerances, std::size_t n_vertices, double max_distance);
/// \throw std::invalid_argument if it is not in [1e-6, 1]
void require_accuracy(double relative_accuracy);

}  // namespace whittle::metrics
