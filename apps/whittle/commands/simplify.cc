#include <algorithm>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "commands/simplify/advice.hh"
#include "commands/simplify/as_written.hh"
#include "commands/simplify/proven_distances.hh"
#include "commands/simplify/simplify_options.hh"
#include "commands/simplify/simplify_runs.hh"
#include "commands/stage_bars.hh"
#include "commands/subcommands.hh"
#include "files/input.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "files/tolerance_map.hh"
#include "openmesh/openmesh_engine.hh"
#include "options/values.hh"
#include "terminal/errors.hh"
#include "terminal/interruption.hh"
#include "terminal/stopwatch.hh"
#include "terminal/table.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/parts.hh"
#include "whittle/engine/automatic_threshold.hh"
#include "whittle/io/border_gaps.hh"
#include "whittle/metrics/meeting_parts.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/shape.hh"

namespace whittle::app {
namespace {

struct Seconds {
  double read = 0;
  double decimate = 0;
  double polish = 0;
  double certify = 0;
  double write = 0;
  double total = 0;
};

/// A run, and what the messages and the report say about it.
struct Run {
  Input input;
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  double diagonal = 0;             ///< of the input's bounding box
  std::vector<double> tolerances;  ///< of the input's vertices, model units; or empty
  std::size_t n_pruned_parts = 0;
  double threshold = 0;  ///< of threshold pairs, model units; 0 = none
  Simplification simplified;
  std::optional<DistancesAsWritten> distances;  ///< if they are to be proven
  std::string certificate;                      ///< if it is to be written
  bool met = false;
  std::optional<std::size_t> n_intersections_before;  ///< pairs of faces, if they were counted
  std::optional<std::size_t> n_intersections_after;
  std::vector<std::string> warnings;
  Seconds seconds;
};

/// Drops small parts from the input.
void prune(const SimplifyCommand& options, const Talk& talk, Run& run) {
  io::ReadResult& read = run.input.read;
  PrunedMesh pruned = without_small_parts(std::move(read.mesh), options.prune->in_units(run.diagonal));
  if (pruned.mesh.faces.empty()) {
    throw UnsupportedMesh(run.input.name + ": nothing is left without the parts smaller than " +
                          to_string(*options.prune) + "; choose a smaller --prune");
  }
  for (Index& v : read.vertex_map) v = v == invalid_index ? v : pruned.vertex_map[v];
  read.mesh = std::move(pruned.mesh);
  run.n_pruned_parts = pruned.n_dropped_parts;
  if (pruned.n_dropped_parts == 0) return;
  talk.say(run.input.name + ": dropped " + counted(pruned.n_dropped_parts, "small part", "small parts") + ", " +
           faces_text(pruned.n_dropped_faces));
}

/// Those of --tolerance-map, else those that the file has.
std::vector<double> tolerances_of(const SimplifyCommand& options, const Talk& talk, const Run& run) {
  const io::ReadResult& read = run.input.read;
  if (options.targets.tolerances) return read_tolerance_map(*options.targets.tolerances, read, run.diagonal);
  std::vector<double> tolerances = tolerances_of_file(read, run.input.name);
  if (!tolerances.empty()) talk.say(run.input.name + ": keeps to its vertices' property 'tolerance'");
  return tolerances;
}

/// The threshold in model units. Warns if it is automatic and no parts lie near one another.
double resolve_threshold(const SimplifyCommand& options, const Talk& talk, Run& run) {
  if (!options.threshold.is_automatic) return options.threshold.length.in_units(run.diagonal);
  const double threshold = automatic_threshold(run.input.read.mesh, options.common.threads);
  if (threshold == 0) {
    run.warnings.push_back(run.input.name +
                           ": no parts lie near one another, '--threshold auto' contracts edges alone");
    talk.warning(run.warnings.back());
  }
  return threshold;
}

/// The options for the library, with the fields that depend on the mesh.
SimplifyOptions resolved(const SimplifyCommand& options, const Run& run) {
  SimplifyOptions result = options.simplify;
  DecimateOptions& decimate = result.decimate;
  if (run.threshold > 0) decimate.pairs.threshold = run.threshold;
  if (run.diagonal > 0) {
    decimate.feature_tolerance = options.feature_tolerance.in_units(run.diagonal) / run.diagonal;
  }
  decimate.threads = options.common.threads;
  return result;
}

/// Signals end the program at once while OpenMesh's decimater runs. It would check for them too rarely, and there are
/// no temporary files yet.
Simplification simplify_in_openmesh(const SimplifyOptions& options, const Run& run) {
  const IndexedMesh& mesh = run.input.read.mesh;
  const Stopwatch decimating;
  Simplification result{decimate_in_openmesh(mesh, run.input.name, run.target, options.decimate),
                        options.decimate.effective_cost(),
                        {},
                        0,
                        0};
  result.decimate_seconds = decimating.seconds();
  const Stopwatch polishing;
  const SignalsWait signals_wait;
  result.polish = polish_decimation(mesh, options, result);
  SignalsWait::throw_if_pending();
  result.polish_seconds = polishing.seconds();
  return result;
}

Simplification simplify_to(const DecimateTarget& target, const SimplifyCommand& options, const Talk& talk,
                           const Run& run) {
  StageBars bars(talk);
  SimplifyOptions library_options = resolved(options, run);
  library_options.decimate.progress = [&bars](const Progress& progress) { return bars.update(progress); };
  if (options.engine == Engine::openmesh) return simplify_in_openmesh(library_options, run);
  const SignalsWait signals_wait;
  Simplification result = simplify(run.input.read.mesh, target, options.effort, library_options);
  SignalsWait::throw_if_pending();
  return result;
}

/// Keeps to the largest error as the result is written: if rounding takes it over that, tries again with less.
void simplify_within_error(const SimplifyCommand& options, const Talk& talk, Run& run) {
  const double limit = *run.target.error_limit();
  const double border_limit = *run.target.border_error_limit();
  for (const double share : {1 - 1e-6, 0.99, 0.9, 0.5}) {
    SimplifyCommand with_share = options;
    with_share.simplify.decimate.tolerances = run.tolerances;
    for (double& tolerance : with_share.simplify.decimate.tolerances) tolerance *= share;
    Simplification result =
        simplify_to(run.target.or_max_error(share * limit, share * border_limit), with_share, talk, run);
    const Stopwatch certifying;
    run.distances = distances_as_written(run.input.read.mesh, result, options, run.target, talk);
    const bool is_kept = run.distances && are_within(run.target, *run.distances) &&
                         keeps_tolerances(run.input.read.mesh, *run.distances, options, run.target, run.tolerances);
    run.seconds.certify += certifying.seconds();
    run.seconds.decimate += result.decimate_seconds;
    run.seconds.polish += result.polish_seconds;
    run.simplified = std::move(result);
    if (is_kept) return;
  }
  throw std::runtime_error(run.input.name + ": an error of " + shortest(limit) + " at most can't be proven as " +
                           shown_output(options.output) +
                           " would be written; choose a larger --max-error, or a format that keeps every digit");
}

void simplify_without_limit(const SimplifyCommand& options, const Talk& talk, Run& run) {
  run.simplified = simplify_to(run.target, options, talk, run);
  run.seconds.decimate += run.simplified.decimate_seconds;
  run.seconds.polish = run.simplified.polish_seconds;
  if (!options.certify && !options.certificate) return;
  const Stopwatch certifying;
  run.distances = distances_as_written(run.input.read.mesh, run.simplified, options, run.target, talk);
  run.seconds.certify = certifying.seconds();
}

void simplify_input(const SimplifyCommand& options, const Talk& talk, Run& run) {
  if (run.target.error_limit()) {
    simplify_within_error(options, talk, run);
  } else {
    simplify_without_limit(options, talk, run);
  }
  if (!options.certificate) return;
  if (!run.distances) throw std::runtime_error(run.input.name + ": no face is left to write a certificate of");
  const Stopwatch certifying;
  run.certificate =
      certificate_as_written(run.input.read.mesh, *run.distances, options, run.target, run.tolerances, talk);
  run.seconds.certify += certifying.seconds();
}

/// Takes over the warnings of the library, except those that the report has elsewhere.
void take_warnings(const Talk& talk, Run& run) {
  for (const Warning& warning : run.simplified.result.warnings) {
    if (warning.kind == WarningKind::pairs_capped) continue;  // `threshold_pairs.capped`
    run.warnings.push_back(run.input.name + ": " + warning.text);
    talk.warning(run.warnings.back());
  }
}

/// Writes a line for every vertex of the file: its number in the result, or -1.
void write_map(std::ostream& out, const Run& run) {
  for (const Index read : run.input.read.vertex_map) {
    const Index written = read == invalid_index ? invalid_index : run.simplified.vertex_map[read];
    if (written == invalid_index) {
      out << "-1\n";
    } else {
      out << written << '\n';
    }
  }
}

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

/// What stood in the way of the target, and what lifts it.
std::string obstacle(const SimplifyCommand& options, const Run& run) {
  const DecimateResult& result = run.simplified.result;
  const std::string refused = refusals(options, result.rejections) + "; ";
  if (options.engine == Engine::openmesh) return refused + "'--engine flat' may get further";
  const std::string left = reasons_at_end(result.refused_at_end);
  if (left.empty()) return refused + "nothing is left that may be contracted";
  return refused + "the pairs left: " + left + "; " +
         advice(run.input.read.mesh, run.simplified, run.target, resolved(options, run).decimate);
}

std::string shortfall(const SimplifyCommand& options, const Run& run) {
  const DecimateResult& result = run.simplified.result;
  return run.input.name + ": target not met: " + to_string(run.target) + " asked, " + faces_text(result.n_faces) +
         " and " + vertices_text(result.n_vertices) + " reached; " + obstacle(options, run);
}

Json surface_json(const SurfaceCounts& counts) {
  return {{"components", counts.components},
          {"nonmanifold_edges", counts.nonmanifold_edges},
          {"nonmanifold_vertices", counts.nonmanifold_vertices}};
}

Json output_json(const SimplifyCommand& options, const Run& run, const metrics::Topology& topology) {
  Json json = {{"path", options.output}, {"vertices", topology.vertices}, {"faces", topology.faces}};
  add_topology(json, topology);
  json["vanished_components"] = run.simplified.result.n_vanished_components;
  json["pruned_components"] = run.n_pruned_parts;
  json["self_intersections"] = run.n_intersections_after ? Json(*run.n_intersections_after) : Json(nullptr);
  json["coincident_faces"] = run.simplified.result.n_coincident_faces;
  return json;
}

Json threshold_pairs_json(const ThresholdPairCounts& pairs) {
  return {{"considered", pairs.considered},
          {"contracted", pairs.contracted},
          {"threshold", pairs.threshold},
          {"capped", pairs.capped}};
}

/// All are null with OpenMesh's decimater, which doesn't count refusals.
Json rejections_json(const SimplifyCommand& options, const Rejections& refused) {
  if (options.engine == Engine::openmesh) {
    return {{"flip", nullptr},   {"link", nullptr},         {"shape", nullptr}, {"feature", nullptr},
            {"locked", nullptr}, {"intersection", nullptr}, {"error", nullptr}};
  }
  return {{"flip", refused.flip},       {"link", refused.link},     {"shape", refused.shape},
          {"feature", refused.feature}, {"locked", refused.locked}, {"intersection", refused.intersection},
          {"error", refused.error}};
}

/// Null if nothing was proven.
Json max_error_json(const Run& run) {
  if (!run.distances) return nullptr;
  Json json = max_error_json(*run.distances, run.target, run.diagonal);
  json["tolerances"] = run.tolerances.size();
  json["certificate_bytes"] = run.certificate.empty() ? Json(nullptr) : Json(run.certificate.size());
  return json;
}

Json simplify_json(const SimplifyCommand& options, const Run& run) {
  const IndexedMesh& mesh = run.simplified.mesh;
  const DecimateResult& result = run.simplified.result;
  Json json = new_report();
  json["input"] = input_json(run.input, run.diagonal);
  json["input"]["self_intersections"] = run.n_intersections_before ? Json(*run.n_intersections_before) : Json(nullptr);
  if (options.engine == Engine::flat) json["input"].update(surface_json(result.before));
  json["options"] = options_json(options);
  json["output"] = output_json(options, run, metrics::topology(mesh));
  json["target"] = target_json(options.targets, run.target);
  json["target"]["met"] = run.met;
  json["stop"] = to_string(result.stop);
  json["max_error"] = max_error_json(run);
  json["contractions"] = result.n_contractions;
  json["threshold_pairs"] = threshold_pairs_json(result.threshold_pairs);
  json["max_cost"] = result.max_cost;
  json["why_in_one_pass"] = result.why_in_one_pass.empty() ? Json(nullptr) : Json(result.why_in_one_pass);
  json["rejections"] = rejections_json(options, result.rejections);
  json["refused_at_end"] = rejections_json(options, result.refused_at_end);
  json["polish"] = *options.simplify.polish_passes > 0 ? polish_json(run.simplified.polish) : Json(nullptr);
  json["seconds"] = {{"read", run.seconds.read},     {"decimate", run.seconds.decimate},
                     {"polish", run.seconds.polish}, {"certify", run.seconds.certify},
                     {"write", run.seconds.write},   {"total", run.seconds.total}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = run.warnings;
  return json;
}

/// Whether a twentieth of the vertices and more lie on open borders.
bool has_much_border(const IndexedMesh& mesh) {
  const auto is_border = detail::border_vertices(mesh.faces, mesh.positions.size());
  return 20 * static_cast<std::size_t>(std::count(is_border.begin(), is_border.end(), 1)) >= mesh.positions.size();
}

/// The penalty for valences makes vertices with three edges rare, but refuses none.
void warn_of_valence_three(const SimplifyCommand& options, const Talk& talk, Run& run) {
  if (options.simplify.decimate.valence_weight == 0 || run.simplified.mesh.faces.empty()) return;
  std::size_t n_vertices = 0;
  for (const auto& [valence, count] : metrics::shape(run.simplified.mesh).valence.histogram) {
    if (valence <= 3) n_vertices += count;
  }
  if (n_vertices == 0) return;
  run.warnings.push_back(run.input.name + ": " + std::to_string(n_vertices) +
                         (n_vertices == 1 ? " vertex has" : " vertices have") +
                         " only three edges: they had them before, or nothing else was left to contract");
  talk.warning(run.warnings.back());
}

/// Narrow gaps between borders keep a mesh from getting small: what rounding has taken apart can't merge.
void warn_of_gaps(const SimplifyCommand& options, const Talk& talk, Run& run) {
  const bool is_welded_exactly = options.files.weld && run.input.weld_tolerance == 0;
  if (!is_welded_exactly || !has_much_border(run.simplified.mesh)) return;
  IndexedMesh mesh = run.input.read.mesh;
  const double tolerance = io::find_border_gaps(mesh).tolerance();
  if (tolerance == 0) return;
  const std::size_t n_welded = io::weld_gaps(mesh, tolerance).welded_vertices;
  if (n_welded == 0) return;
  run.warnings.push_back(run.input.name + ": gaps between borders; '--weld auto' welds " + std::to_string(n_welded) +
                         " vertices that lie at most " + significant(tolerance) + " apart");
  talk.warning(run.warnings.back());
}

void warn_of_meeting_parts(const SimplifyCommand& options, const Talk& talk, Run& run) {
  if (run.simplified.mesh.faces.empty()) return;
  const std::size_t n = metrics::newly_meeting_parts(run.input.read.mesh, run.simplified.mesh,
                                                     run.simplified.vertex_map, options.common.threads)
                            .size();
  if (n == 0) return;
  const bool is_refused = options.self_intersections == SelfIntersections::refuse;
  run.warnings.push_back(run.input.name + ": " + std::to_string(n) +
                         (n == 1 ? " pair of parts intersects" : " pairs of parts intersect") + " that didn't before" +
                         (is_refused ? "" : "; '--self-intersections refuse' keeps parts apart"));
  talk.warning(run.warnings.back());
}

void count_intersections(const SimplifyCommand& options, const Talk& talk, Run& run) {
  if (options.self_intersections == SelfIntersections::allow) return;
  const auto count = [&](const IndexedMesh& mesh, double from, double to, ProgressBar& bar) {
    if (mesh.faces.empty()) return std::size_t{0};
    return metrics::self_intersections(mesh, options.common.threads, part_of(bar, from, to)).size();
  };
  ProgressBar bar(talk, "counting intersections");
  run.n_intersections_before = count(run.input.read.mesh, 0, 0.8, bar);
  run.n_intersections_after = count(run.simplified.mesh, 0.8, 1, bar);
}

/// Writes the result, the map and the report. All of them appear, or none does.
/// \param report becomes the report, even without --json; may be null
void write_files(const SimplifyCommand& options, const Talk& talk, const Stopwatch& since_start, Run& run,
                 Json* report) {
  const Stopwatch watch;
  OutputFiles files;
  write_mesh(files, options.output, options.files, run.simplified.mesh, talk, run.warnings);
  if (options.map) files.write(*options.map, [&run](std::ostream& out) { write_map(out, run); });
  if (options.certificate) {
    files.write(*options.certificate, [&run](std::ostream& out) { out << run.certificate; });
  }
  run.seconds.write = watch.seconds();
  run.seconds.total = since_start.seconds();
  const Json json = report != nullptr || options.common.json ? simplify_json(options, run) : Json();
  commit_with_report(files, options.common, options.common.json ? to_text(json) : std::string());
  if (report != nullptr) *report = json;
}

std::string threshold_pairs(const ThresholdPairCounts& pairs) {
  return "threshold " + significant(pairs.threshold) + ": " + std::to_string(pairs.considered) + " pairs" +
         (pairs.capped ? ", the nearest of each vertex" : "") + ", " + std::to_string(pairs.contracted) + " contracted";
}

void say_details(const SimplifyCommand& options, const Talk& talk, const Run& run) {
  if (!talk.is_verbose()) return;
  const DecimateResult& result = run.simplified.result;
  talk.detail("contractions: " + std::to_string(result.n_contractions) + ", greatest cost " +
              significant(result.max_cost) + ", stopped by: " + std::string(to_string(result.stop)));
  if (!result.why_in_one_pass.empty())
    talk.detail("in one pass, not in blocks: " + std::string(result.why_in_one_pass));
  if (options.has_cost_by_effort && *options.simplify.tries_plain_quadrics && run.simplified.cost == Cost::quadric)
    talk.detail("by plain quadrics, which came nearer: much of the mesh is flat");
  talk.detail(refusals(options, result.rejections));
  if (run.threshold > 0) talk.detail(threshold_pairs(result.threshold_pairs));
  const bool is_polished = *options.simplify.polish_passes > 0;
  if (is_polished) talk.detail("polish: " + polish_text(run.simplified.polish));
  if (run.distances) {
    const NamesOfRun names{run.input.name, shown_output(options.output), run.diagonal};
    for (const std::string& line : distance_lines(*run.distances, run.target, names)) talk.detail(line);
  }
  talk.detail("read " + seconds_text(run.seconds.read) + ", decimate " + seconds_text(run.seconds.decimate) +
              (is_polished ? ", polish " + seconds_text(run.seconds.polish) : "") +
              (run.distances ? ", certify " + seconds_text(run.seconds.certify) : "") + ", write " +
              seconds_text(run.seconds.write));
  say_effort(talk, run.seconds.total);
}

std::string summary(const SimplifyCommand& options, const Run& run) {
  const IndexedMesh& before = run.input.read.mesh;
  const DecimateResult& after = run.simplified.result;
  return shown_output(options.output) + ": " + std::to_string(before.faces.size()) + " -> " +
         faces_text(after.n_faces) + ", " + std::to_string(before.positions.size()) + " -> " +
         vertices_text(after.n_vertices) +
         (run.n_intersections_after ? ", " + std::to_string(*run.n_intersections_before) + " -> " +
                                          std::to_string(*run.n_intersections_after) + " self-intersections"
                                    : "") +
         (run.distances
              ? ", at most " + length_text_rounded_up(proven_distance(run.distances->surface), run.diagonal) + " off"
              : "") +
         " in " + seconds_text(run.seconds.total);
}

std::vector<std::string> lost_in_openmesh(const SimplifyCommand& options, const Input& input) {
  std::vector<std::string> warnings;
  const auto add = [&](const char* what) {
    warnings.push_back(input.name + ": " + what + " are not carried by --engine openmesh");
  };
  if (!input.read.mesh.normals.empty() && options.simplify.decimate.normals != Normals::drop) add("vertex normals");
  if (!input.read.mesh.colors.empty()) add("vertex colours");
  return warnings;
}

/// One run, of `options.input`. \param report becomes the report, even without --json; may be null
ExitCode simplify_one(SimplifyCommand options, Json* report) {
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  Run run;
  run.input = read_input(options.input, options.files, options.common.threads, talk);
  run.seconds.read = run.input.seconds;
  run.warnings = options.warnings;
  for (const std::string& warning : options.warnings) talk.warning(warning);
  run.warnings.insert(run.warnings.end(), run.input.warnings.begin(), run.input.warnings.end());
  if (options.engine == Engine::openmesh) {
    for (const std::string& lost : lost_in_openmesh(options, run.input)) {
      run.warnings.push_back(lost);
      talk.warning(lost);
    }
  }
  run.diagonal = metrics::bounds(run.input.read.mesh).diagonal();
  run.target =
      resolve(options.targets, run.input.read.mesh.positions.size(), run.input.read.mesh.faces.size(), run.diagonal);
  if (options.prune) prune(options, talk, run);
  if (run.target.error_limit()) run.tolerances = tolerances_of(options, talk, run);

  const Stopwatch watch_threshold;
  run.threshold = resolve_threshold(options, talk, run);
  run.seconds.decimate = watch_threshold.seconds();
  if (options.has_cost_by_effort) {
    SimplifyOptions open = resolved(options, run);
    open.decimate.cost.reset();
    options.simplify.decimate.cost =
        with_effort(options.effort, std::move(open), run.input.read.mesh, run.target).decimate.cost;
  }
  simplify_input(options, talk, run);
  options.simplify.decimate.cost = run.simplified.cost;
  take_warnings(talk, run);
  run.met = is_met(run.target, run.simplified.result.stop);

  warn_of_valence_three(options, talk, run);
  if (run.met) warn_of_gaps(options, talk, run);
  warn_of_meeting_parts(options, talk, run);
  count_intersections(options, talk, run);
  const std::string missed = run.met ? std::string() : shortfall(options, run);
  if (!run.met) run.warnings.push_back(missed);
  write_files(options, talk, watch, run, report);

  say_details(options, talk, run);
  talk.say(summary(options, run));
  if (run.met) return ExitCode::done;
  if (!options.strict) {
    talk.warning(missed);
    return ExitCode::done;
  }
  talk.error(missed);
  return ExitCode::target_not_met;
}

ExitCode run_simplify(const CLI::App& app, const SimplifyCommand& command) {
  check_options(app, command);
  std::vector<SimplifyCommand> runs = runs_of(command);
  check_files(runs);
  for (SimplifyCommand& run : runs) run.warnings = idle_options(app, run);
  if (!is_named_by_stem(command)) return simplify_one(runs.front(), nullptr);
  for (SimplifyCommand& run : runs) run.common.json.reset();  // there is one report of all
  return run_each(command, runs, simplify_one);
}

}  // namespace

void setup_simplify(CLI::App& app, Command& command) {
  const auto options = std::make_shared<SimplifyCommand>();
  CLI::App* sub = app.add_subcommand("simplify", "Make a mesh smaller and keep its shape.");
  add_simplify_options(*sub, *options);
  set_usage(*sub, "IN... -o OUT TARGET... [OPTION]...");
  sub->footer(
      "Examples:\n"
      "  whittle simplify dragon.ply -o small.ply --ratio 10%\n"
      "  whittle simplify part.stl -o part.obj --faces 5000 --strict --json report.json\n"
      "  whittle simplify *.stl -o 'out/{stem}.ply' --face-ratio 10%\n"
      "  whittle simplify - -o - --format ply --faces 5000 < in.ply > out.ply");
  sub->callback(
      [sub, options, &command] { command = [sub, options] { return run_simplify(*sub, settled(*options)); }; });
}

}  // namespace whittle::app
