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

std::optional<metrics::LargestDistances> distances_as_written(const IndexedMesh& input, const IndexedMesh& result,
                                                              const SimplifyCommand& options,
                                                              std::optional<double> limit, const Talk& talk) {
  if (result.faces.empty()) return std::nullopt;
  ProgressBar bar(talk, "certifying");
  const SignalsWait signals_wait;
  const IndexedMesh written = as_written(result, options);
  return metrics::largest_distances(
      input, written, accuracy,
      {options.common.threads, part_of(bar, 0, 1), limit.value_or(std::numeric_limits<double>::infinity())});
}

double proven_distance(const metrics::LargestDistances& largest) {
  return std::max(largest.forward.at_most, largest.backward.at_most);
}

}  // namespace whittle::app
