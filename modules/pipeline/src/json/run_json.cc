#include <string>
#include <utility>
#include <variant>

#include "whittle/pipeline/json.hh"
#include "whittle/version.hh"

// What is reported of runs.

namespace whittle {
namespace {

struct ToJson {
  Json operator()(std::monostate) const { return nullptr; }
  template <class T>
  Json operator()(const T& value) const {
    return value;
  }
};

void add_distances(Json& json, const metrics::LargestDistances& largest, double diagonal) {
  add_length(json, "proven", proven_distance(largest), diagonal);
  json["forward"] = largest_json(largest.forward, diagonal);
  json["backward"] = largest_json(largest.backward, diagonal);
}

Json surface_json(const SurfaceCounts& counts) {
  return {{"components", counts.components},
          {"nonmanifold_edges", counts.nonmanifold_edges},
          {"nonmanifold_vertices", counts.nonmanifold_vertices}};
}

Json count_json(const std::optional<std::size_t>& n) { return n ? Json(*n) : Json(nullptr); }

Json output_json(const Plan& plan, const Outcome& outcome) {
  const metrics::Topology topology = metrics::topology(outcome.simplified.mesh);
  Json json = {{"path", plan.request.output.path}, {"vertices", topology.vertices}, {"faces", topology.faces}};
  add_topology(json, topology);
  json["vanished_components"] = outcome.simplified.result.n_vanished_components;
  json["vanished_regions"] = outcome.vanished.regions;
  json["vanished_charts"] = outcome.vanished.n_charts;
  json["folded_texture_faces"] = outcome.simplified.n_folded_texture_faces;
  json["pruned_components"] = plan.n_pruned_parts;
  json["self_intersections"] = count_json(outcome.n_intersections_after);
  json["coincident_faces"] = outcome.simplified.result.n_coincident_faces;
  return json;
}

Json threshold_pairs_json(const ThresholdPairCounts& pairs) {
  return {{"considered", pairs.considered},
          {"contracted", pairs.contracted},
          {"threshold", pairs.threshold},
          {"capped", pairs.capped}};
}

/// All are null with another decimater than ours, which counts no refusals.
Json refusals_json(const Request& request, const RefusalCounts& refused) {
  Json json;
  for (const RefusalRow& row : all_refusals) {
    json[std::string(row.key)] = request.decimater ? Json(nullptr) : Json(refused[row.refusal]);
  }
  return json;
}

/// Null if nothing was proven.
Json proof_json(const Plan& plan, const Outcome& outcome) {
  if (!outcome.distances) return nullptr;
  Json json = max_error_json(*outcome.distances, plan.target, plan.diagonal);
  json["tolerances"] = plan.options.decimate.tolerances.size();
  json["certificate_bytes"] = outcome.certificate.empty() ? Json(nullptr) : Json(outcome.certificate.size());
  return json;
}

}  // namespace

Json new_report() { return {{"schema", 1}, {"program", "whittle " WHITTLE_VERSION_STRING}}; }

Json options_json(const OptionRows& rows) {
  Json json;
  for (const OptionRow& row : rows) {
    if (row.key.empty()) continue;
    json[row.key] = std::visit(ToJson{}, row.reported ? row.reported() : row.access.get());
  }
  return json;
}

Json target_json(const Targets& targets, const DecimateTarget& target) {
  Json json = Json::object();
  if (target.n_faces()) json["faces"] = *target.n_faces();
  if (target.n_vertices()) json["vertices"] = *target.n_vertices();
  if (targets.ratio) json["ratio"] = *targets.ratio;
  if (targets.face_ratio) json["face_ratio"] = *targets.face_ratio;
  if (target.cost_limit()) json["max_cost"] = *target.cost_limit();
  if (target.error_limit()) json["max_error"] = *target.error_limit();
  if (targets.max_border_error && target.border_error_limit()) json["max_error_borders"] = *target.border_error_limit();
  return json;
}

Json max_error_json(const DistancesAsWritten& distances, const DecimateTarget& target, double diagonal) {
  Json json;
  json["asked"] = target.error_limit() ? Json(*target.error_limit()) : Json(nullptr);
  add_distances(json, distances.surface, diagonal);
  json["borders"] = nullptr;
  if (distances.borders) add_distances(json["borders"], *distances.borders, diagonal);
  return json;
}

Json run_json(const Plan& plan, const Outcome& outcome, Json options) {
  const Request& request = plan.request;
  const DecimateResult& result = outcome.simplified.result;
  Json json;
  json["input"] = input_json(plan.scene, plan.diagonal);
  json["input"]["self_intersections"] = count_json(outcome.n_intersections_before);
  if (!request.decimater) json["input"].update(surface_json(result.before));
  json["options"] = std::move(options);
  json["output"] = output_json(plan, outcome);
  json["target"] = target_json(request.targets, plan.target);
  if (request.tolerance_map) json["target"]["tolerance_map"] = *request.tolerance_map;
  json["target"]["met"] = outcome.met;
  const std::string_view ended_by = option_that_ended(result.stop);
  if (!outcome.met && !ended_by.empty()) json["target"]["ended_by"] = ended_by;
  json["stop"] = to_string(result.stop);
  json["max_error"] = proof_json(plan, outcome);
  json["contractions"] = result.n_contractions;
  json["threshold_pairs"] = threshold_pairs_json(result.threshold_pairs);
  json["max_cost"] = result.max_cost;
  json["why_in_one_pass"] = result.why_in_one_pass.empty() ? Json(nullptr) : Json(result.why_in_one_pass);
  json["rejections"] = refusals_json(request, result.refusals);
  json["refused_at_end"] = refusals_json(request, result.refused_at_end);
  json["polish"] = *plan.options.polish_passes > 0 ? polish_json(outcome.simplified.polish) : Json(nullptr);
  return json;
}

}  // namespace whittle
