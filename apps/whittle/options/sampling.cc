#include "options/sampling.hh"

namespace whittle::app {

OptionRows sampling_rows(metrics::DistanceOptions& options) {
  constexpr std::uint64_t most_samples = std::uint64_t{1} << 40;
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  return {{.names = "--samples",
           .access = count(options.samples, 1, most_samples),
           .help = "points on each of the two surfaces from which distances are taken, besides all vertices, "
                   "1 <= N <= 2^40"},
          {.names = "--seed",
           .access = count(options.seed, 0, most),
           .help = "where the points lie, N >= 0; the same seed gives the same numbers"}};
}

}  // namespace whittle::app
