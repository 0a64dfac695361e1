#pragma once

#include <cmath>

// Sums and products of two doubles together with what rounding takes from them.
// \cite shewchuk_1997_adaptive

namespace whittle::detail {

/// value + error is exact, and value is the rounded result.
struct WithError {
  double value, error;
};

/// a + b; Two-Sum.
inline WithError two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// a · b
inline WithError two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

}  // namespace whittle::detail
