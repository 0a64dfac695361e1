#include "commands/simplify/as_written.hh"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "files/mesh_output.hh"
#include "files/report.hh"
#include "terminal/interruption.hh"
#include "terminal/progress_bar.hh"
#include "whittle/metrics/certificate.hh"

namespace whittle::app {
namespace {

/// Of the largest distances.
constexpr double accuracy = 1e-3;

/// Points of the file are at most this far from those of what was looked at.
void add_gap(double gap, metrics::LargestDistances& distances) {
  distances.forward.at_most += gap;
  distances.backward.at_most += gap;
}

}  // namespace

std::optional<DistancesAsWritten> distances_as_written(const Input& input, const Decimation& result,
                                                       const SimplifyCommand& options, const DecimateTarget& target,
                                                       const Talk& talk) {
  constexpr double no_limit = std::numeric_limits<double>::infinity();
  if (result.mesh.faces.empty()) return std::nullopt;
  ProgressBar bar(talk, "certifying");
  const SignalsWait signals_wait;
  const unsigned threads = options.common.threads;
  DistancesAsWritten distances;
  const SceneOutput output = output_of(options.output, options.files);
  distances.written = as_written(output, input, result.mesh, read_options(options.files, threads));
  // The file may have a vertex several times, and not quite at one place.
  const double gap = widest_gap_as_written(output, input, result.mesh);
  const auto without_gap = [gap](double limit) { return gap > 0 ? std::max(0.0, limit * (1 - 1e-12) - gap) : limit; };
  if (distances.written.positions.size() == result.mesh.positions.size()) distances.vertex_map = result.vertex_map;
  distances.surface =
      metrics::largest_distances(input.read.mesh, distances.written, accuracy,
                                 {threads, part_of(bar, 0, 0.9), without_gap(target.error_limit().value_or(no_limit))});
  distances.borders = metrics::largest_border_distances(
      input.read.mesh, distances.written, accuracy,
      {threads, part_of(bar, 0.9, 1), without_gap(target.border_error_limit().value_or(no_limit))});
  add_gap(gap, distances.surface);
  if (distances.borders) add_gap(gap, *distances.borders);
  return distances;
}

std::string certificate_as_written(const IndexedMesh& input, const DistancesAsWritten& distances,
                                   const SimplifyCommand& options, const DecimateTarget& target,
                                   std::span<const double> tolerances, const Talk& talk) {
  ProgressBar bar(talk, "certifying");
  const SignalsWait signals_wait;
  metrics::CertifiedDistances at_most;
  at_most.surface = target.error_limit().value_or(proven_distance(distances.surface));
  at_most.borders = target.border_error_limit().value_or(distances.borders ? proven_distance(*distances.borders)
                                                                           : std::numeric_limits<double>::infinity());
  const std::optional<std::string> certificate =
      metrics::make_certificate(input, distances.written, at_most,
                                {options.common.threads, part_of(bar, 0, 1), tolerances, distances.vertex_map});
  if (!certificate) throw std::runtime_error(options.input + ": the steps of the proof are not found");
  return *certificate;
}

double proven_distance(const metrics::LargestDistances& largest) {
  return std::max(largest.forward.at_most, largest.backward.at_most);
}

bool are_within(const DecimateTarget& target, const DistancesAsWritten& distances) {
  return proven_distance(distances.surface) <= *target.error_limit() &&
         (!distances.borders || proven_distance(*distances.borders) <= *target.border_error_limit());
}

bool keeps_tolerances(const IndexedMesh& input, const DistancesAsWritten& distances, const SimplifyCommand& options,
                      const DecimateTarget& target, std::span<const double> tolerances) {
  if (tolerances.empty()) return true;
  const metrics::Certification certification = metrics::certify(
      input, distances.written, *target.error_limit(), {options.common.threads, {}, tolerances, distances.vertex_map});
  return certification.verdict == Verdict::proven;
}

}  // namespace whittle::app
