#include "packed_values.hh"

#include <algorithm>
#include <cmath>

namespace whittle::report {

std::uint8_t packed_value(double value, const ValueRange& range) {
  constexpr double n_usual = 100;
  constexpr double n_greater = 27;
  const double size = std::abs(value);
  double step = 0;
  if (size <= range.usual) {
    step = range.usual > 0 ? size / range.usual * n_usual : 0;
  } else if (range.usual > 0) {
    step = n_usual + std::ceil(n_greater * std::log(size / range.usual) / std::log(range.max / range.usual));
  } else {
    step = n_usual + std::ceil(n_greater * size / range.max);
  }
  return static_cast<std::uint8_t>(std::lround(std::min(step, n_usual + n_greater)) + (value < 0 ? 128 : 0));
}

}  // namespace whittle::report
