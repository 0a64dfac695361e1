#include "commands/simplify/simplify_report.hh"

#include "commands/simplify/proven_distances.hh"
#include "options/targets.hh"
#include "system/system.hh"

namespace whittle::app {
namespace {

Json surface_json(const SurfaceCounts& counts) {
  return {{"components", counts.components},
          {"nonmanifold_edges", counts.nonmanifold_edges},
          {"nonmanifold_vertices", counts.nonmanifold_vertices}};
}

Json output_json(const SimplifyCommand& options, const SimplifyRecord& record, const metrics::Topology& topology) {
  Json json = {{"path", options.output}, {"vertices", topology.vertices}, {"faces", topology.faces}};
  add_topology(json, topology);
  json["vanished_components"] = record.outcome.simplified.result.n_vanished_components;
  json["vanished_regions"] = record.outcome.vanished.regions;
  json["vanished_charts"] = record.outcome.vanished.n_charts;
  json["folded_texture_faces"] = record.outcome.simplified.n_folded_texture_faces;
  json["pruned_components"] = record.plan.n_pruned_parts;
  json["self_intersections"] =
      record.outcome.n_intersections_after ? Json(*record.outcome.n_intersections_after) : Json(nullptr);
  json["coincident_faces"] = record.outcome.simplified.result.n_coincident_faces;
  return json;
}

Json threshold_pairs_json(const ThresholdPairCounts& pairs) {
  return {{"considered", pairs.considered},
          {"contracted", pairs.contracted},
          {"threshold", pairs.threshold},
          {"capped", pairs.capped}};
}

/// All are null with OpenMesh's decimater, which doesn't count refusals.
Json refusals_json(const SimplifyCommand& options, const RefusalCounts& refused) {
  Json json;
  for (const RefusalRow& row : all_refusals) {
    json[std::string(row.key)] = options.engine == Engine::openmesh ? Json(nullptr) : Json(refused[row.refusal]);
  }
  return json;
}

/// Null if nothing was proven.
Json proof_json(const SimplifyRecord& record) {
  if (!record.outcome.distances) return nullptr;
  Json json = max_error_json(*record.outcome.distances, record.plan.target, record.plan.diagonal);
  json["tolerances"] = record.plan.options.decimate.tolerances.size();
  json["certificate_bytes"] =
      record.outcome.certificate.empty() ? Json(nullptr) : Json(record.outcome.certificate.size());
  return json;
}

}  // namespace

Json simplify_json(const SimplifyCommand& options, const SimplifyRecord& record) {
  const IndexedMesh& mesh = record.outcome.simplified.mesh;
  const DecimateResult& result = record.outcome.simplified.result;
  Json json = new_report();
  json["input"] = input_json(record.plan.scene, record.plan.diagonal);
  json["input"]["self_intersections"] =
      record.outcome.n_intersections_before ? Json(*record.outcome.n_intersections_before) : Json(nullptr);
  if (options.engine == Engine::flat) json["input"].update(surface_json(result.before));
  json["options"] = simplify_options_json(options);
  json["output"] = output_json(options, record, metrics::topology(mesh));
  json["target"] = target_json(options.request.targets, record.plan.target);
  if (options.request.tolerance_map) json["target"]["tolerance_map"] = *options.request.tolerance_map;
  json["target"]["met"] = record.outcome.met;
  const std::string_view ended_by = option_that_ended(result.stop);
  if (!record.outcome.met && !ended_by.empty()) json["target"]["ended_by"] = ended_by;
  json["stop"] = to_string(result.stop);
  json["max_error"] = proof_json(record);
  json["curve"] = options.curve ? curve_json(record.curve) : Json(nullptr);
  json["contractions"] = result.n_contractions;
  json["threshold_pairs"] = threshold_pairs_json(result.threshold_pairs);
  json["max_cost"] = result.max_cost;
  json["why_in_one_pass"] = result.why_in_one_pass.empty() ? Json(nullptr) : Json(result.why_in_one_pass);
  json["rejections"] = refusals_json(options, result.refusals);
  json["refused_at_end"] = refusals_json(options, result.refused_at_end);
  json["polish"] =
      *record.plan.options.polish_passes > 0 ? polish_json(record.outcome.simplified.polish) : Json(nullptr);
  json["seconds"] = {{"read", record.read_seconds},
                     {"decimate", record.decimate_seconds()},
                     {"polish", record.outcome.seconds.polish},
                     {"certify", record.outcome.seconds.certify},
                     {"curve", record.curve_seconds},
                     {"write", record.write_seconds},
                     {"total", record.total_seconds}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = record.warnings;
  return json;
}

}  // namespace whittle::app
