#include "run/proof.hh"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "run/observe.hh"
#include "whittle/metrics/certificate.hh"
#include "whittle/scene/write_scene.hh"

namespace whittle {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Of the largest distances.
constexpr double accuracy = 1e-3;

Slack slack_of(const Plan& plan, const Decimation& result) {
  if (plan.shown) return {};
  return {plan.stretch, widest_gap_as_written(plan.request.output, plan.scene, result.mesh)};
}

/// What is read again of the file.
IndexedMesh mesh_as_written(const Plan& plan, const Decimation& result) {
  const Request& request = plan.request;
  return request.proves_file() ? scene_as_written(request.output, plan.scene, result.mesh, request.reading)
                               : as_written(request.output, plan.scene, result.mesh, request.reading);
}

bool keeps_tolerances(const Plan& plan, const DistancesAsWritten& distances) {
  const std::vector<double>& tolerances = plan.options.decimate.tolerances;
  if (tolerances.empty()) return true;
  const metrics::Certification certification =
      metrics::certify(plan.proven_surface(), distances.written, *plan.target.error_limit(),
                       {plan.threads(), {}, tolerances, distances.vertex_map});
  return certification.verdict == Verdict::proven;
}

}  // namespace

void Slack::add_to(metrics::LargestDistances& distances) const {
  for (double* bound : {&distances.forward.at_most, &distances.backward.at_most}) *bound = stretch * (*bound + gap);
}

double Slack::within(double limit) const {
  const bool is_any = stretch > 1 || gap > 0;
  return is_any ? std::max(0.0, limit / stretch * (1 - 1e-12) - gap) : limit;
}

std::optional<DistancesAsWritten> distances_as_written(const Plan& plan, const Decimation& result,
                                                       const RunObserver& observer) {
  if (result.mesh.faces.empty()) return std::nullopt;
  const IndexedMesh& input = plan.proven_surface();
  const DecimateTarget& target = plan.target;
  const unsigned threads = plan.threads();
  DistancesAsWritten distances;
  distances.written = mesh_as_written(plan, result);
  if (distances.written.faces.empty()) return std::nullopt;
  const Slack slack = slack_of(plan, result);
  if (!plan.shown && distances.written.positions.size() == result.mesh.positions.size()) {
    distances.vertex_map = result.vertex_map;
  }
  distances.surface = metrics::largest_distances(
      input, distances.written, accuracy,
      {threads, observed(observer, "certifying", 0, 0.9), slack.within(target.error_limit().value_or(no_limit))});
  distances.borders = metrics::largest_border_distances(input, distances.written, accuracy,
                                                        {threads, observed(observer, "certifying", 0.9, 1),
                                                         slack.within(target.border_error_limit().value_or(no_limit))});
  slack.add_to(distances.surface);
  if (distances.borders) slack.add_to(*distances.borders);
  return distances;
}

std::string certificate_as_written(const Plan& plan, const DistancesAsWritten& distances, const RunObserver& observer) {
  const DecimateTarget& target = plan.target;
  metrics::CertifiedDistances at_most;
  at_most.surface = target.error_limit().value_or(proven_distance(distances.surface));
  at_most.borders =
      target.border_error_limit().value_or(distances.borders ? proven_distance(*distances.borders) : no_limit);
  const std::optional<std::string> certificate = metrics::make_certificate(
      plan.proven_surface(), distances.written, at_most,
      {plan.threads(), observed(observer, "certifying", 0, 1), plan.options.decimate.tolerances, distances.vertex_map});
  if (!certificate) throw std::runtime_error(plan.scene.path + ": the steps of the proof are not found");
  return *certificate;
}

double proven_distance(const metrics::LargestDistances& largest) {
  return std::max(largest.forward.at_most, largest.backward.at_most);
}

bool keep_limits(const Plan& plan, const DistancesAsWritten& distances) {
  return proven_distance(distances.surface) <= *plan.target.error_limit() &&
         (!distances.borders || proven_distance(*distances.borders) <= *plan.target.border_error_limit()) &&
         keeps_tolerances(plan, distances);
}

}  // namespace whittle
