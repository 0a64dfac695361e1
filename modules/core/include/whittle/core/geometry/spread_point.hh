#pragma once

#include <cmath>
#include <cstddef>

#include "whittle/core/geometry/nearest_on_triangle.hh"

namespace whittle {

/// Point i of a sequence that fills a triangle evenly. \cite roberts_2018_quasirandom
inline Barycentric spread_point(std::size_t i) {
  const double u = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(i), 1.0);
  const double v = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(i), 1.0);
  return u + v <= 1 ? Barycentric{u, v} : Barycentric{1 - u, 1 - v};
}

}  // namespace whittle
