#include <algorithm>

#include "whittle/engine/decimate.hh"

namespace whittle {

std::string_view to_string(StopReason reason) {
  switch (reason) {
    case StopReason::target:
      return "target";
    case StopReason::cost:
      return "cost";
    case StopReason::error:
      return "error";
    case StopReason::exhausted:
      return "exhausted";
    case StopReason::cancelled:
      return "cancelled";
  }
  return "";
}

ThresholdPairCounts& ThresholdPairCounts::operator+=(const ThresholdPairCounts& other) {
  considered += other.considered;
  contracted += other.contracted;
  threshold = std::max(threshold, other.threshold);
  capped = capped || other.capped;
  return *this;
}

SurfaceCounts& SurfaceCounts::operator+=(const SurfaceCounts& other) {
  components += other.components;
  nonmanifold_edges += other.nonmanifold_edges;
  nonmanifold_vertices += other.nonmanifold_vertices;
  return *this;
}

DecimateResult& DecimateResult::operator+=(const DecimateResult& other) {
  n_contractions += other.n_contractions;
  n_vertices += other.n_vertices;
  n_faces += other.n_faces;
  max_cost = std::max(max_cost, other.max_cost);
  stop = std::max(stop, other.stop);  // `target` is the least
  if (why_in_one_pass.empty()) why_in_one_pass = other.why_in_one_pass;
  refusals += other.refusals;
  refused_at_end += other.refused_at_end;
  n_degenerate_faces += other.n_degenerate_faces;
  n_coincident_faces += other.n_coincident_faces;
  threshold_pairs += other.threshold_pairs;
  before += other.before;
  after += other.after;
  n_vanished_components += other.n_vanished_components;
  for (const Warning& warning : other.warnings) {
    const auto is_same = [&](const Warning& w) { return w.kind == warning.kind; };
    if (std::none_of(warnings.begin(), warnings.end(), is_same)) warnings.push_back(warning);
  }
  return *this;
}

}  // namespace whittle
