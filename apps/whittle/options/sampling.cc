#include "options/sampling.hh"

#include <string>
#include <string_view>

#include "options/command_line.hh"
#include "options/values.hh"

namespace whittle::app {

void add_sampling_options(CLI::App& app, metrics::DistanceOptions& options) {
  constexpr std::uint64_t most_samples = std::uint64_t{1} << 40;
  add_value(
      app, "--samples", "N", options.samples,
      [](std::string_view text) { return static_cast<std::size_t>(parse_count(text, 1, most_samples)); },
      "points on each of the two surfaces from which distances are taken, besides all vertices, 1 <= N <= 2^40")
      ->default_str(std::to_string(options.samples));
  add_value(
      app, "--seed", "N", options.seed, [](std::string_view text) { return parse_count(text, 0); },
      "where the points lie, N >= 0; the same seed gives the same numbers")
      ->default_str(std::to_string(options.seed));
}

}  // namespace whittle::app
