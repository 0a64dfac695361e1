#pragma once

#include <vector>

namespace whittle::bench {

struct Spread {
  double min = 0;
  double median = 0;
  double max = 0;
};
/// \pre at least one value
Spread spread_of(std::vector<double> values);

/// Median of a[i] / b[i] over the rounds; quotient of the medians if one of them has fewer rounds.
/// \pre both have at least one value
double median_ratio(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace whittle::bench
