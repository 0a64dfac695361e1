#include "commands/simplify/simplify_texts.hh"

#include "commands/mesh_kind.hh"
#include "commands/simplify/proven_distances.hh"
#include "files/input.hh"
#include "files/report.hh"
#include "terminal/table.hh"
#include "whittle/core/parts.hh"

namespace whittle::app {
namespace {

std::string threshold_pairs(const ThresholdPairCounts& pairs) {
  return "threshold " + significant(pairs.threshold) + ": " + std::to_string(pairs.considered) + " pairs" +
         (pairs.capped ? ", the nearest of each vertex" : "") + ", " + std::to_string(pairs.contracted) + " contracted";
}

std::size_t count_parts(const IndexedMesh& mesh) { return find_parts(mesh.positions.size(), mesh.faces).count; }

/// ", 25 -> 3 parts": with a threshold, parts may join.
std::string parts_text(const SimplifyRecord& record) {
  if (record.threshold == 0) return "";
  return ", " + std::to_string(count_parts(record.input.read.mesh)) + " -> " +
         counted(count_parts(record.simplified.mesh), "part", "parts");
}

/// ", ended by '--max-error',"
std::string ended_by(StopReason stop) {
  const std::string_view option = option_that_ended(stop);
  return option.empty() ? "" : ", ended by '" + std::string(option) + "',";
}

}  // namespace

std::string refusals(const SimplifyCommand& options, const Rejections& refused) {
  if (options.engine == Engine::openmesh) return "OpenMesh doesn't say what it refused";
  std::string text = "refused: " + std::to_string(refused.link) + " by topology, " + std::to_string(refused.flip) +
                     " by turning a face, ";
  if (options.simplify.decimate.min_radius_ratio) text += std::to_string(refused.shape) + " by shape, ";
  if (options.simplify.decimate.feature_angle_deg) text += std::to_string(refused.feature) + " by features, ";
  if (options.targets.max_error) text += std::to_string(refused.error) + " by error, ";
  if (options.self_intersections == SelfIntersections::refuse)
    text += std::to_string(refused.intersection) + " by intersecting, ";
  return text + std::to_string(refused.locked) + " locked";
}

void say_details(const SimplifyCommand& options, const Talk& talk, const SimplifyRecord& record) {
  if (!talk.is_verbose()) return;
  const DecimateResult& result = record.simplified.result;
  talk.detail("contractions: " + std::to_string(result.n_contractions) + ", greatest cost " +
              significant(result.max_cost) + ", stopped by: " + std::string(to_string(result.stop)));
  if (!result.why_in_one_pass.empty())
    talk.detail("in one pass, not in blocks: " + std::string(result.why_in_one_pass));
  if (options.has_cost_by_effort && *options.simplify.tries_plain_quadrics && record.simplified.cost == Cost::quadric)
    talk.detail(std::string("by plain quadrics, which came nearer") +
                (is_mostly_flat(record.input.read.mesh) ? ": much of the mesh is flat" : ""));
  talk.detail(refusals(options, result.rejections));
  if (record.threshold > 0) talk.detail(threshold_pairs(result.threshold_pairs));
  const bool is_polished = *options.simplify.polish_passes > 0;
  if (is_polished) talk.detail("polish: " + polish_text(record.simplified.polish));
  if (record.distances) {
    const NamesOfRun names{record.input.name, shown_output(options.output), record.diagonal};
    for (const std::string& line : distance_lines(*record.distances, record.target, names)) talk.detail(line);
  }
  talk.detail("read " + seconds_text(record.seconds.read) + ", decimate " + seconds_text(record.seconds.decimate) +
              (is_polished ? ", polish " + seconds_text(record.seconds.polish) : "") +
              (record.distances ? ", certify " + seconds_text(record.seconds.certify) : "") + ", write " +
              seconds_text(record.seconds.write));
  say_effort(talk, record.seconds.total);
}

std::string summary(const SimplifyCommand& options, const SimplifyRecord& record) {
  const IndexedMesh& before = record.input.read.mesh;
  const DecimateResult& after = record.simplified.result;
  return shown_output(options.output) + ": " + std::to_string(before.faces.size()) + " -> " +
         faces_text(after.n_faces) + ", " + std::to_string(before.positions.size()) + " -> " +
         vertices_text(after.n_vertices) + parts_text(record) +
         (record.n_intersections_after ? ", " + std::to_string(*record.n_intersections_before) + " -> " +
                                             std::to_string(*record.n_intersections_after) + " self-intersections"
                                       : "") +
         (record.distances
              ? ", at most " + length_text_rounded_up(proven_distance(record.distances->surface), record.diagonal) +
                    " off"
              : "") +
         (record.met ? "" : ended_by(after.stop)) + " in " + seconds_text(record.seconds.total);
}

}  // namespace whittle::app
