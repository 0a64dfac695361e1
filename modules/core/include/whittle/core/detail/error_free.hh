#pragma once

// Sums and products of two doubles, with their rounding errors. \cite shewchuk_1997_adaptive

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

/// A double as a sum of two doubles with half its digits; Split.
inline WithError split(double a) {
  const double shifted = a * (0x1p27 + 1);
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

/// a · b; Two-Product. Without `std::fma`, which is slow where the processor has none, and wrong in MinGW.
/// \pre a and b are below 2⁹⁹⁵, and the error isn't below 2⁻¹⁰⁷⁴
inline WithError two_product(double a, double b) {
  const double product = a * b;
  const auto [a_high, a_low] = split(a);
  const auto [b_high, b_low] = split(b);
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

}  // namespace whittle::detail
