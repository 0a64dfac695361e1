#include "bench/results/statistics.hh"

#include <algorithm>
#include <cstddef>

namespace whittle::bench {

Spread spread_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return {values.front(), 0.5 * (values[(n - 1) / 2] + values[n / 2]), values.back()};
}

double median_ratio(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return spread_of(a).median / spread_of(b).median;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  return spread_of(ratios).median;
}

}  // namespace whittle::bench
