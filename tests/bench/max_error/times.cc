#include "bench/max_error/times.hh"

#include <algorithm>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/results/statistics.hh"
#include "whittle/core/flat_arrays.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/metrics/certificate.hh"
#include "whittle/simplify/simplify.hh"
#include "whittle/verify/verify.hh"

namespace whittle::bench {
namespace {

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Seconds of each work in each round. A first round that doesn't count comes before, unless it takes long: then it is
/// the only one.
std::vector<std::vector<double>> seconds_in_rounds(const std::vector<std::function<void()>>& works,
                                                   const TimeOptions& options) {
  std::vector<std::vector<double>> seconds(works.size());
  for (int round = 0; round <= options.rounds; ++round) {
    if (round == 1) {
      const auto is_slow = [&options](const std::vector<double>& first) { return first.front() > options.slow_s; };
      if (std::any_of(seconds.begin(), seconds.end(), is_slow)) break;
      for (std::vector<double>& of_work : seconds) of_work.clear();
    }
    for (std::size_t i = 0; i < works.size(); ++i) seconds[i].push_back(seconds_of(works[i]));
  }
  return seconds;
}

Simplification simplified(const IndexedMesh& input, const DecimateTarget& target, unsigned threads) {
  SimplifyOptions options;
  options.decimate.threads = threads;
  return simplify(input, target, Effort::normal, options);
}

}  // namespace

TimeBeside time_beside(const IndexedMesh& input, double max_error, std::size_t n_faces, const TimeOptions& options) {
  const auto seconds =
      seconds_in_rounds({[&] { simplified(input, DecimateTarget::max_error(max_error), options.threads); },
                         [&] { simplified(input, DecimateTarget::faces(n_faces), options.threads); }},
                        options);
  return {spread_of(seconds[0]).median, spread_of(seconds[1]).median, median_ratio(seconds[0], seconds[1])};
}

Row time_pair(const IndexedMesh& input, const TimeOptions& options) {
  const DecimateTarget target = DecimateTarget::faces(input.faces.size() / 10);
  const Simplification run = simplified(input, target, options.threads);
  const IndexedMesh& result = run.mesh;
  const metrics::LargestDistances largest = metrics::largest_distances(input, result, 1e-3);
  const double max_error = 1.01 * std::max(largest.forward.at_most, largest.backward.at_most);
  const auto certificate = metrics::make_certificate(input, result, {max_error});
  if (!certificate) throw std::runtime_error("the pair with a tenth of the faces is not proven");
  const verify::Triangles in{flat_positions(input), flat_faces(input)};
  const verify::Triangles out{flat_positions(result), flat_faces(result)};
  const auto verified = [&] {
    if (!verify::verify(in, out, *certificate, options.threads).holds)
      throw std::runtime_error("the certificate of the pair with a tenth of the faces doesn't hold");
  };
  const auto seconds = seconds_in_rounds(
      {[&] { simplified(input, target, options.threads); },
       [&] { metrics::certify(input, result, max_error, {.threads = options.threads}); },
       [&] { metrics::certify(input, result, max_error, {.threads = options.threads, .vertex_map = run.vertex_map}); },
       [&] { metrics::make_certificate(input, result, {max_error}, {.threads = options.threads}); }, verified},
      options);
  Row row;
  row.n_input = input.faces.size();
  row.error_rel = max_error / diagonal_of(input.positions);
  row.n_faces = result.faces.size();
  const auto median = [&seconds](std::size_t i) { return spread_of(seconds[i]).median; };
  row.pair = {median(0), median(1), median(2), median(3), median(4)};
  return row;
}

}  // namespace whittle::bench
