#include "commands/as_written.hh"

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>

#include "files/input.hh"
#include "terminal/interruption.hh"
#include "terminal/progress_bar.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::app {
namespace {

/// Of the largest distances.
constexpr double accuracy = 1e-3;

IndexedMesh as_written(const IndexedMesh& mesh, const SimplifyCommand& options) {
  const io::Format format = format_for_output(options.output, options.files);
  std::ostringstream out;
  io::write_mesh(out, format, mesh, {.ascii = options.files.ascii});
  const std::string bytes = std::move(out).str();
  return io::read_mesh(bytes, options.output, {.format = format, .threads = options.common.threads}).mesh;
}

}  // namespace

std::optional<DistancesAsWritten> distances_as_written(const IndexedMesh& input, const IndexedMesh& result,
                                                       const SimplifyCommand& options, const DecimateTarget& target,
                                                       const Talk& talk) {
  constexpr double no_limit = std::numeric_limits<double>::infinity();
  if (result.faces.empty()) return std::nullopt;
  ProgressBar bar(talk, "certifying");
  const SignalsWait signals_wait;
  const IndexedMesh written = as_written(result, options);
  const unsigned threads = options.common.threads;
  DistancesAsWritten distances;
  distances.surface = metrics::largest_distances(
      input, written, accuracy, {threads, part_of(bar, 0, 0.9), target.error_limit().value_or(no_limit)});
  distances.borders = metrics::largest_border_distances(
      input, written, accuracy, {threads, part_of(bar, 0.9, 1), target.border_error_limit().value_or(no_limit)});
  return distances;
}

double proven_distance(const metrics::LargestDistances& largest) {
  return std::max(largest.forward.at_most, largest.backward.at_most);
}

bool are_within(const DecimateTarget& target, const DistancesAsWritten& distances) {
  return proven_distance(distances.surface) <= *target.error_limit() &&
         (!distances.borders || proven_distance(*distances.borders) <= *target.border_error_limit());
}

}  // namespace whittle::app
