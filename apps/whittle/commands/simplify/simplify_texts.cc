#include "commands/simplify/simplify_texts.hh"

#include <algorithm>

#include "commands/mesh_kind.hh"
#include "commands/simplify/proven_distances.hh"
#include "files/input.hh"
#include "files/report.hh"
#include "terminal/table.hh"
#include "whittle/core/parts.hh"
#include "whittle/core/two_sided.hh"

namespace whittle::app {
namespace {

std::string threshold_pairs(const ThresholdPairCounts& pairs) {
  return "threshold " + significant(pairs.threshold) + ": " + std::to_string(pairs.considered) + " pairs" +
         (pairs.capped ? ", the nearest of each vertex" : "") + ", " + std::to_string(pairs.contracted) + " contracted";
}

std::size_t count_parts(const IndexedMesh& mesh) { return find_parts(mesh.positions.size(), mesh.faces).count; }

/// ", 25 -> 3 parts": with a threshold, parts may join.
std::string parts_text(const SimplifyRecord& record) {
  if (record.plan.threshold() == 0) return "";
  return ", " + std::to_string(count_parts(record.plan.scene.read.mesh)) + " -> " +
         counted(count_parts(record.outcome.simplified.mesh), "part", "parts");
}

/// ", ended by '--max-error',"
std::string ended_by(StopReason stop) {
  const std::string_view option = option_that_ended(stop);
  return option.empty() ? "" : ", ended by '" + std::string(option) + "',";
}

}  // namespace

void say_details(const SimplifyCommand& options, const Talk& talk, const SimplifyRecord& record) {
  if (!talk.is_verbose()) return;
  const DecimateResult& result = record.outcome.simplified.result;
  talk.detail("contractions: " + std::to_string(result.n_contractions) + ", greatest cost " +
              significant(result.max_cost) + ", stopped by: " + std::string(to_string(result.stop)));
  if (!result.why_in_one_pass.empty())
    talk.detail("in one pass, not in blocks: " + std::string(result.why_in_one_pass));
  const SimplifyOptions& settled = record.plan.options;
  if (record.outcome.simplified.cost != *settled.decimate.cost)
    talk.detail(std::string("by plain quadrics, which came nearer") +
                (is_mostly_flat(record.plan.scene.read.mesh) ? ": much of the mesh is flat" : ""));
  talk.detail(refusals_text(record.plan, result.refusals));
  if (record.plan.threshold() > 0) talk.detail(threshold_pairs(result.threshold_pairs));
  const bool is_polished = *record.plan.options.polish_passes > 0;
  if (is_polished) talk.detail("polish: " + polish_text(record.outcome.simplified.polish));
  if (record.outcome.distances) {
    const NamesOfRun names{record.plan.scene.name, shown_output(options.output), record.plan.diagonal};
    for (const std::string& line : distance_lines(*record.outcome.distances, record.plan.target, names))
      talk.detail(line);
  }
  talk.detail("read " + seconds_text(record.read_seconds) + ", decimate " + seconds_text(record.decimate_seconds()) +
              (is_polished ? ", polish " + seconds_text(record.outcome.seconds.polish) : "") +
              (record.outcome.distances ? ", certify " + seconds_text(record.outcome.seconds.certify) : "") +
              ", write " + seconds_text(record.write_seconds));
  say_effort(talk, record.total_seconds);
}

std::string summary(const SimplifyCommand& options, const SimplifyRecord& record) {
  const IndexedMesh& before = record.plan.scene.read.mesh;
  const DecimateResult& after = record.outcome.simplified.result;
  return shown_output(options.output) + ": " + std::to_string(before.faces.size()) + " -> " +
         faces_text(after.n_faces) + ", " + std::to_string(before.positions.size()) + " -> " +
         vertices_text(after.n_vertices) + parts_text(record) +
         (record.outcome.n_intersections_after
              ? ", " + std::to_string(*record.outcome.n_intersections_before) + " -> " +
                    std::to_string(*record.outcome.n_intersections_after) + " self-intersections"
              : "") +
         (record.outcome.distances
              ? ", at most " +
                    length_text_rounded_up(proven_distance(record.outcome.distances->surface), record.plan.diagonal) +
                    " off"
              : "") +
         (record.outcome.met ? "" : ended_by(after.stop)) + " in " + seconds_text(record.total_seconds);
}

std::vector<std::string> warnings_of_engine(const SimplifyCommand& options, const Scene& scene) {
  std::vector<std::string> warnings;
  if (options.engine == Engine::flat) return warnings;
  const auto add = [&](const char* what) {
    warnings.push_back(about(scene.name, std::string(what) + " are not carried by --engine openmesh"));
  };
  const IndexedMesh& mesh = scene.read.mesh;
  if (!mesh.normals.empty() && options.request.simplify.decimate.normals != Normals::drop) add("vertex normals");
  if (!mesh.colors.empty()) add("vertex colours");
  return warnings;
}

}  // namespace whittle::app
