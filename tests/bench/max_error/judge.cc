#include "bench/max_error/judge.hh"

#include <algorithm>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

#include "bench/max_error/sampled_distance.hh"
#include "bench/processes/forked.hh"
#include "bench/results/csv.hh"
#include "whittle/core/flat_arrays.hh"
#include "whittle/metrics/certificate.hh"
#include "whittle/simplify/simplify.hh"
#include "whittle/verify/verify.hh"
#ifdef WHITTLE_BENCH_HAS_CGAL
#include "bench/max_error/cgal_distance.hh"
#endif

namespace whittle::bench {
namespace {

constexpr double accuracy = 1e-3;       ///< of the largest distances, relative
constexpr double cgal_accuracy = 0.01;  ///< of CGAL's, over E
constexpr double rounding = 1e-6;       ///< between two ways to compute one distance, over E

double both_ways(const IndexedMesh& a, const IndexedMesh& b, std::size_t n_samples) {
  constexpr std::uint64_t seed = 1;
  return std::max(sampled_distance(a, FaceTree(b), n_samples, seed), sampled_distance(b, FaceTree(a), n_samples, seed));
}

/// The distance of the point that is farthest, computed anew.
double distance_found(const metrics::LargestDistances& largest, const IndexedMesh& a, const IndexedMesh& b) {
  const bool is_forward = largest.forward.at_least > largest.backward.at_least;
  const metrics::FarPoint& far = (is_forward ? largest.forward : largest.backward).where;
  return far.face == invalid_index ? 0 : FaceTree(is_forward ? b : a).distance(far.point);
}

std::optional<double> distance_by_cgal([[maybe_unused]] const IndexedMesh& a, [[maybe_unused]] const IndexedMesh& b,
                                       [[maybe_unused]] double bound, [[maybe_unused]] double limit_s,
                                       std::vector<std::string>& remarks) {
#ifdef WHITTLE_BENCH_HAS_CGAL
  try {
    const std::string bytes = run_forked(
        [&] {
          const double distance = cgal_distance(a, b, bound);
          return std::string(reinterpret_cast<const char*>(&distance), sizeof(distance));
        },
        limit_s);
    double distance = 0;
    std::memcpy(&distance, bytes.data(), sizeof(distance));
    return distance;
  } catch (const std::exception& error) {
    remarks.push_back(std::string("CGAL's distance: ") + error.what());
  }
#else
  remarks.push_back("CGAL isn't built in");
#endif
  return std::nullopt;
}

void judge_borders(const IndexedMesh& input, const IndexedMesh& result, double max_error, std::size_t n_samples,
                   Proof& proof) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto largest = metrics::largest_border_distances(input, result, accuracy, {.limit = max_error});
  if (largest) proof.borders = std::max(largest->forward.at_most, largest->backward.at_most) / max_error;
  const IndexedMesh before = border_as_faces(input);
  const IndexedMesh after = border_as_faces(result);
  if (before.faces.empty() && after.faces.empty()) return;
  const bool has_one = before.faces.empty() || after.faces.empty();
  proof.sampled_borders = has_one ? infinity : both_ways(before, after, n_samples) / max_error;
}

/// Looks at the certificate and whether threads change a byte.
void judge_certificate(const IndexedMesh& input, const IndexedMesh& result, double max_error, Proof& proof) {
  std::optional<std::string> certificate;
  for (const unsigned threads : {1U, 2U, 3U}) {
    SimplifyOptions options;
    options.decimate.threads = threads;
    const IndexedMesh again = simplify(input, DecimateTarget::max_error(max_error), Effort::normal, options).mesh;
    auto bytes = metrics::make_certificate(input, again, {max_error, max_error}, {.threads = threads});
    proof.has_same_bytes = proof.has_same_bytes && again.positions == result.positions && again.faces == result.faces &&
                           (threads == 1 || bytes == certificate);
    certificate = std::move(bytes);
  }
  if (!certificate) return;
  proof.certificate_bytes = certificate->size();
  const verify::Triangles in{flat_positions(input), flat_faces(input)};
  const verify::Triangles out{flat_positions(result), flat_faces(result)};
  const verify::Verification verification = verify::verify(in, out, *certificate);
  proof.holds = verification.holds && verification.max_error == max_error;
}

}  // namespace

Proof judged(const IndexedMesh& input, const IndexedMesh& result, double max_error, const JudgeOptions& options,
             std::vector<std::string>& remarks) {
  Proof proof;
  const metrics::LargestDistances largest = metrics::largest_distances(input, result, accuracy, {.limit = max_error});
  proof.certified = std::max(largest.forward.at_most, largest.backward.at_most) / max_error;
  proof.found = distance_found(largest, input, result) / max_error;
  proof.sampled = both_ways(input, result, options.samples) / max_error;
  if (const auto distance = distance_by_cgal(input, result, cgal_accuracy * max_error, options.limit_s, remarks))
    proof.by_cgal = *distance / max_error;
  judge_borders(input, result, max_error, options.samples, proof);
  judge_certificate(input, result, max_error, proof);
  return proof;
}

std::vector<std::string> violations(const Proof& proof) {
  std::vector<std::string> all;
  const auto require = [&all](bool is_so, const std::string& violation) {
    if (!is_so) all.push_back(violation);
  };
  const auto times = [](double value) { return formatted("%.6f", value) + " E"; };
  require(proof.certified <= 1, "what is proven is " + times(proof.certified));
  require(proof.found <= proof.certified + rounding, "a point is " + times(proof.found) + " away");
  require(proof.sampled <= proof.certified + rounding, "a sample is " + times(proof.sampled) + " away");
  if (proof.by_cgal) require(*proof.by_cgal <= proof.certified + cgal_accuracy, "CGAL finds " + times(*proof.by_cgal));
  if (proof.borders) require(*proof.borders <= 1, "what is proven of borders is " + times(*proof.borders));
  if (proof.sampled_borders)
    require(proof.borders && *proof.sampled_borders <= *proof.borders + rounding,
            "a sample of a border is " + times(*proof.sampled_borders) + " away");
  require(proof.certificate_bytes > 0, "there is no certificate");
  require(proof.certificate_bytes == 0 || proof.holds, "the verifier refuses the certificate");
  require(proof.has_same_bytes, "bytes depend on the number of threads");
  return all;
}

}  // namespace whittle::bench
