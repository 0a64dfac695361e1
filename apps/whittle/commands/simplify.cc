#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "commands/new_intersections.hh"
#include "commands/regions/names.hh"
#include "commands/regions/regions.hh"
#include "commands/simplify/advice.hh"
#include "commands/simplify/per_mesh.hh"
#include "commands/simplify/simplify_files.hh"
#include "commands/simplify/simplify_record.hh"
#include "commands/simplify/simplify_report.hh"
#include "commands/simplify/simplify_runs.hh"
#include "commands/simplify/simplify_texts.hh"
#include "commands/stage_bars.hh"
#include "commands/subcommands.hh"
#include "whittle/scene/gltf_file.hh"
#include "files/input.hh"
#include "files/mesh_output.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "files/tolerance_map.hh"
#include "openmesh/openmesh_engine.hh"
#include "terminal/errors.hh"
#include "terminal/interruption.hh"
#include "terminal/stopwatch.hh"
#include "terminal/table.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/parts.hh"
#include "whittle/core/wedges.hh"
#include "whittle/engine/automatic_threshold.hh"
#include "whittle/io/border_gaps.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/shape.hh"

namespace whittle::app {
namespace {

/// Drops small parts from the input.
void prune(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  io::ReadResult& read = record.input.read;
  PrunedMesh pruned = without_small_parts(std::move(read.mesh), options.request.prune->in_units(record.diagonal));
  if (pruned.mesh.faces.empty()) {
    throw UnsupportedMesh(record.input.name + ": nothing is left without the parts smaller than " +
                          to_string(*options.request.prune) + "; choose a smaller --prune");
  }
  for (Index& v : read.vertex_map) v = v == invalid_index ? v : pruned.vertex_map[v];
  read.mesh = std::move(pruned.mesh);
  record.n_pruned_parts = pruned.n_dropped_parts;
  if (pruned.n_dropped_parts == 0) return;
  talk.say(record.input.name + ": dropped " + counted(pruned.n_dropped_parts, "small part", "small parts") + ", " +
           faces_text(pruned.n_dropped_faces));
}

/// Those of --tolerance-map, else those that the file has.
std::vector<double> tolerances_of(const SimplifyCommand& options, const Talk& talk, const SimplifyRecord& record) {
  const io::ReadResult& read = record.input.read;
  if (options.tolerances) return read_tolerance_map(*options.tolerances, read, record.diagonal);
  std::vector<double> tolerances = tolerances_of_file(read, record.input.name);
  if (!tolerances.empty()) talk.say(record.input.name + ": keeps to its vertices' property 'tolerance'");
  return tolerances;
}

/// The threshold in model units. Warns if it is automatic and no parts lie near one another.
double resolve_threshold(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  if (!options.request.threshold.is_automatic) return options.request.threshold.length.in_units(record.diagonal);
  const double threshold = automatic_threshold(record.input.read.mesh, options.common.threads);
  if (threshold == 0) {
    record.warnings.push_back(record.input.name +
                              ": no parts lie near one another, '--threshold auto' contracts edges alone");
    talk.warning(record.warnings.back());
  }
  return threshold;
}

/// The options for the library, with the fields that depend on the mesh.
SimplifyOptions resolved(const SimplifyCommand& options, const SimplifyRecord& record) {
  SimplifyOptions result = options.request.simplify;
  DecimateOptions& decimate = result.decimate;
  if (record.threshold > 0) decimate.pairs.threshold = record.threshold;
  if (record.diagonal > 0) {
    decimate.feature_tolerance = options.request.feature_tolerance.in_units(record.diagonal) / record.diagonal;
  }
  decimate.locked = record.held;
  decimate.threads = options.common.threads;
  decimate.keep_steps = options.recording || options.curve || options.page || options.pictures.is_given();
  return result;
}

/// Signals end the program at once while OpenMesh's decimater runs. It would check for them too rarely, and there are
/// no temporary files yet.
Simplification simplify_in_openmesh(const SimplifyOptions& options, const SimplifyRecord& record) {
  const IndexedMesh& mesh = record.input.read.mesh;
  const Stopwatch decimating;
  Simplification result{decimate_in_openmesh(mesh, record.input.name, record.target, options.decimate),
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
                           const SimplifyRecord& record) {
  StageBars bars(talk);
  SimplifyOptions library_options = resolved(options, record);
  library_options.decimate.progress = [&bars](const Progress& progress) { return bars.update(progress); };
  if (options.engine == Engine::openmesh) return simplify_in_openmesh(library_options, record);
  const SignalsWait signals_wait;
  Simplification result =
      options.request.is_per_mesh
          ? simplify_per_mesh(record.input, record.targets_per_mesh, options.request.effort, library_options)
          : simplify(record.input.read.mesh, target, options.request.effort, library_options);
  SignalsWait::throw_if_pending();
  return result;
}

/// Takes over a result. \return whether it keeps the limits of the error as it is written, which is proven
bool take_if_within(Simplification result, const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  const Stopwatch certifying;
  record.distances = distances_as_written(record.input, result, options, record.target, talk);
  const bool is_kept =
      record.distances && are_within(record.target, *record.distances) &&
      keeps_tolerances(record.input.read.mesh, *record.distances, options, record.target, record.tolerances);
  record.seconds.certify += certifying.seconds();
  record.seconds.decimate += result.decimate_seconds;
  record.seconds.polish += result.polish_seconds;
  record.simplified = std::move(result);
  return is_kept;
}

/// The input as it is.
Simplification uncontracted(const SimplifyCommand& options, const Talk& talk, const SimplifyRecord& record) {
  SimplifyCommand as_it_is = options;
  as_it_is.request.simplify.polish_passes = 0;
  Simplification result =
      simplify_to(DecimateTarget::faces(record.input.read.mesh.faces.size()), as_it_is, talk, record);
  result.result.stop = StopReason::error;
  return result;
}

std::string why_not_within(const SimplifyCommand& options, const SimplifyRecord& record) {
  const double limit = *record.target.error_limit();
  const double at_least = record.distances ? std::max(record.distances->surface.forward.at_least,
                                                      record.distances->surface.backward.at_least)
                                           : 0;
  return record.input.name + ": an error of " + shortest(limit) + " at most can't be proven as " +
         shown_output(options.output) + " would be written, not even of all faces of the input; " +
         (at_least > limit ? "rounding moves them by " + significant(at_least) +
                                 "; choose a larger --max-error, or a format that keeps every digit"
                           : "choose a larger --max-error");
}

/// Keeps to the largest error as the result is written: if rounding takes it over that, tries again with less. The
/// input itself is the last that is tried.
void simplify_within_error(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  const double limit = *record.target.error_limit();
  const double border_limit = *record.target.border_error_limit();
  for (const double share : {1 - 1e-6, 0.99, 0.9, 0.5}) {
    SimplifyCommand with_share = options;
    with_share.request.simplify.decimate.tolerances = record.tolerances;
    for (double& tolerance : with_share.request.simplify.decimate.tolerances) tolerance *= share;
    const DecimateTarget target = record.target.or_max_error(share * limit, share * border_limit);
    if (take_if_within(simplify_to(target, with_share, talk, record), options, talk, record)) return;
  }
  if (take_if_within(uncontracted(options, talk, record), options, talk, record)) return;
  throw std::runtime_error(why_not_within(options, record));
}

void simplify_without_limit(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  record.simplified = simplify_to(record.target, options, talk, record);
  record.seconds.decimate += record.simplified.decimate_seconds;
  record.seconds.polish = record.simplified.polish_seconds;
  if (!options.request.certify && !options.certificate) return;
  const Stopwatch certifying;
  record.distances = distances_as_written(record.input, record.simplified, options, record.target, talk);
  record.seconds.certify = certifying.seconds();
}

void simplify_input(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  if (record.target.error_limit()) {
    simplify_within_error(options, talk, record);
  } else {
    simplify_without_limit(options, talk, record);
  }
  if (!options.certificate) return;
  if (!record.distances) throw std::runtime_error(record.input.name + ": no face is left to write a certificate of");
  const Stopwatch certifying;
  record.certificate = certificate_as_written(record.input.read.mesh, *record.distances, options, record.target,
                                              record.tolerances, talk);
  record.seconds.certify += certifying.seconds();
}

/// Takes over the warnings of the library, except those that the report has elsewhere.
void take_warnings(const Talk& talk, SimplifyRecord& record) {
  for (const Warning& warning : record.simplified.result.warnings) {
    if (warning.kind == WarningKind::pairs_capped) continue;  // `threshold_pairs.capped`
    record.warnings.push_back(record.input.name + ": " + warning.text);
    talk.warning(record.warnings.back());
  }
}

/// What stood in the way of the target, and what lifts it.
std::string obstacle(const SimplifyCommand& options, const SimplifyRecord& record) {
  const DecimateResult& result = record.simplified.result;
  if (const std::string_view limit = option_that_ended(result.stop); !limit.empty()) {
    return '\'' + std::string(limit) + "' ended it";
  }
  const std::string refused = refusals(options, result.refusals) + "; ";
  if (options.engine == Engine::openmesh) return refused + "'--engine flat' may get further";
  const std::string left = reasons_at_end(result.refused_at_end);
  if (left.empty()) return refused + "nothing is left that may be contracted";
  if (options.request.is_per_mesh) return refused + "the pairs left: " + left;
  return refused + "the pairs left: " + left + "; " +
         advice(record.input.read.mesh, record.simplified, record.target, resolved(options, record).decimate,
                keeps_meshes(record.input));
}

std::string shortfall(const SimplifyCommand& options, const SimplifyRecord& record) {
  const DecimateResult& result = record.simplified.result;
  std::string where;
  if (options.request.is_per_mesh) {
    const auto above = meshes_above(record.targets_per_mesh, *record.input.gltf, record.simplified.mesh);
    if (!above.empty())
      where = " by " + above.front() + (above.size() > 1 ? " and " + std::to_string(above.size() - 1) + " more" : "");
  }
  return record.input.name + ": target not met" + where + ": " + to_string(counts_of(record.target)) + " asked, " +
         faces_text(result.n_faces) + " and " + vertices_text(result.n_vertices) + " reached; " +
         obstacle(options, record);
}

/// A limit of the error that allows nothing at all may surprise.
void warn_of_nothing_contracted(const Talk& talk, SimplifyRecord& record) {
  const DecimateResult& result = record.simplified.result;
  if (result.stop != StopReason::error || result.n_contractions > 0) return;
  const std::string left = reasons_at_end(result.refused_at_end);
  record.warnings.push_back(
      record.input.name + ": nothing is contracted, as no fewer faces are found that keep within " +
      length_text(*record.target.error_limit(), record.diagonal) + (left.empty() ? "" : "; the pairs left: " + left));
  talk.warning(record.warnings.back());
}

/// Whether a twentieth of the vertices and more lie on open borders.
bool has_much_border(const IndexedMesh& mesh) {
  const auto is_border = detail::border_vertices(mesh.faces, mesh.positions.size());
  return 20 * static_cast<std::size_t>(std::count(is_border.begin(), is_border.end(), 1)) >= mesh.positions.size();
}

void warn_of_vanished(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  record.vanished = find_vanished(record.input, record.simplified, options.request.simplify.decimate.regions);
  for (const std::string& text : texts_of(record.vanished)) {
    record.warnings.push_back(record.input.name + ": " + text);
    talk.warning(record.warnings.back());
  }
}

void warn_of_folds(const Talk& talk, SimplifyRecord& record) {
  const std::size_t n = record.simplified.n_folded_texture_faces;
  if (n == 0) return;
  record.warnings.push_back(record.input.name + ": " + faces_text(n) + (n == 1 ? " is" : " are") +
                            " folded over on the texture");
  talk.warning(record.warnings.back());
}

/// The penalty for valences makes vertices with three edges rare, but refuses none.
void warn_of_valence_three(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  if (options.request.simplify.decimate.valence_weight == 0 || record.simplified.mesh.faces.empty()) return;
  std::size_t n_vertices = 0;
  for (const auto& [valence, count] : metrics::shape(record.simplified.mesh).valence.histogram) {
    if (valence <= 3) n_vertices += count;
  }
  if (n_vertices == 0) return;
  record.warnings.push_back(record.input.name + ": " + std::to_string(n_vertices) +
                            (n_vertices == 1 ? " vertex has" : " vertices have") +
                            " only three edges: they had them before, or nothing else was left to contract");
  talk.warning(record.warnings.back());
}

/// Narrow gaps between borders keep a mesh from getting small: what rounding has taken apart can't merge.
void warn_of_gaps(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  if (keeps_meshes(record.input)) return;  // they are not welded to each other
  const bool is_welded_exactly = options.files.weld && record.input.weld_tolerance == 0;
  if (!is_welded_exactly || !has_much_border(record.simplified.mesh)) return;
  IndexedMesh mesh = record.input.read.mesh;
  const double tolerance = io::find_border_gaps(mesh).tolerance();
  if (tolerance == 0) return;
  const std::size_t n_welded = io::weld_gaps(mesh, tolerance).welded_vertices;
  if (n_welded == 0) return;
  record.warnings.push_back(record.input.name + ": gaps between borders; '--weld auto' welds " +
                            std::to_string(n_welded) + " vertices that lie at most " + significant(tolerance) +
                            " apart");
  talk.warning(record.warnings.back());
}

void warn_of_new_intersections(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  const bool is_refused = options.request.self_intersections == SelfIntersections::refuse;
  const auto warn = [&](const std::string& text, const std::string& advice) {
    if (text.empty()) return;
    record.warnings.push_back(record.input.name + ": " + text + (is_refused ? "" : advice));
    talk.warning(record.warnings.back());
  };
  const NewIntersections found =
      find_new_intersections(record.input.read.mesh, record.simplified, options.common.threads);
  warn(found.of_parts, "; '--self-intersections refuse' keeps parts apart");
  warn(found.of_walls, "; '--self-intersections refuse' prevents it");
}

void warn_of_result(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  warn_of_nothing_contracted(talk, record);
  warn_of_vanished(options, talk, record);
  warn_of_folds(talk, record);
  warn_of_valence_three(options, talk, record);
  const bool is_weld_named = record.shortfall.find("--weld auto") != std::string::npos;
  if (!is_weld_named) warn_of_gaps(options, talk, record);
  warn_of_new_intersections(options, talk, record);
}

void measure_curve(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  if (!options.curve) return;
  const Stopwatch watch;
  constexpr std::size_t samples = 100'000;
  const IndexedMesh input = recorded_input(record);
  progressive::Replay replay(input, record.simplified.steps, Normals::drop);
  record.curve = measure_curve(replay, samples, options.common.threads, talk);
  record.seconds.curve = watch.seconds();
}

void count_intersections(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  if (options.request.self_intersections == SelfIntersections::allow) return;
  const auto count = [&](const IndexedMesh& mesh, double from, double to, ProgressBar& bar) {
    if (mesh.faces.empty()) return std::size_t{0};
    return metrics::self_intersections(mesh, options.common.threads, part_of(bar, from, to)).size();
  };
  ProgressBar bar(talk, "counting intersections");
  record.n_intersections_before = count(record.input.read.mesh, 0, 0.8, bar);
  record.n_intersections_after = count(record.simplified.mesh, 0.8, 1, bar);
}

/// OpenMesh's engine takes one value of an attribute a vertex.
io::AttributeScope attributes_to_read(const SimplifyCommand& options) {
  return options.engine == Engine::openmesh ? io::AttributeScope::per_vertex : io::AttributeScope::all;
}

/// Leaves positions, faces, and what the file says of these.
void drop_attributes(io::ReadResult& read) {
  IndexedMesh& mesh = read.mesh;
  mesh.wedges.clear();
  mesh.normals.clear();
  mesh.colors.clear();
  mesh.attributes.clear();
  mesh.face_attributes.clear();
  mesh.face_groups.clear();
  mesh.group_names.clear();
  const bool has_float32_positions = read.notes.has_float32_positions;
  read.notes = {};
  read.notes.has_float32_positions = has_float32_positions;
}

/// \pre what was read has not been pruned
void set_target(const SimplifyCommand& options, SimplifyRecord& record) {
  const IndexedMesh& mesh = record.input.read.mesh;
  record.target = resolve(options.request.targets, mesh.positions.size(), mesh.faces.size(), record.diagonal);
  if (!options.request.is_per_mesh) return;
  record.targets_per_mesh = targets_per_mesh(options.request.targets, record.input, record.diagonal);
  record.target = sum_of(record.targets_per_mesh);
}

/// Writes a glTF file without triangles with all that is in it.
/// \throw UnsupportedMesh if a file is asked for that says something of a run
ExitCode pass_through(SimplifyCommand& options, const Talk& talk, const Stopwatch& since_start, SimplifyRecord& record,
                      Json* report) {
  const std::string why = record.input.name + ": " + why_no_faces(record.input.read);
  for (const SideFile& file : side_files(options)) {
    if (*file.path) throw UnsupportedMesh(why + "; there is nothing to write for " + file.option);
  }
  record.target = resolve(options.request.targets, 0, 0, record.diagonal);
  record.simplified.cost = options.request.simplify.decimate.effective_cost();
  options.request.simplify.decimate.cost = record.simplified.cost;
  record.simplified.result.stop = record.target.is_reached_at(0, 0) ? StopReason::target : StopReason::exhausted;
  record.met = is_met(record.target, record.simplified.result.stop);
  record.warnings.push_back(why + "; there is nothing to simplify, and all of it is written as it was");
  talk.warning(record.warnings.back());
  write_files(options, talk, since_start, record, report);
  say_details(options, talk, record);
  talk.say(summary(options, record));
  return ExitCode::done;
}

/// One run, of `options.input`. \param report becomes the report, even without --json; may be null
ExitCode simplify_one(SimplifyCommand options, Json* report) {
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  SimplifyRecord record;
  options.files.takes_no_triangles = options.files.scope != SceneScope::scene;
  const unsigned threads = options.common.threads;
  record.input = options.joins ? read_joined(options.inputs, options.files, threads, talk, attributes_to_read(options))
                               : read_input(options.input, options.files, threads, talk, attributes_to_read(options));
  if (!options.request.keeps_attributes) drop_attributes(record.input.read);
  take_categories(options.request.categories, record.input);
  record.seconds.read = record.input.seconds;
  record.warnings = options.warnings;
  for (const std::string& warning : options.warnings) talk.warning(warning);
  record.warnings.insert(record.warnings.end(), record.input.warnings.begin(), record.input.warnings.end());
  for (const std::string& warning : input_warnings(options, record.input)) {
    record.warnings.push_back(warning);
    talk.warning(warning);
  }
  if (record.input.read.mesh.faces.empty()) return pass_through(options, talk, watch, record, report);
  record.diagonal = diagonal_of(bounds_of(record.input.read.mesh));
  set_target(options, record);
  check_regions(options.request.simplify.decimate.regions, record.input);
  if (options.request.prune) prune(options, talk, record);
  record.held = held_borders(record.input, options.common.threads, talk, record.warnings);
  if (record.target.error_limit()) record.tolerances = tolerances_of(options, talk, record);

  const Stopwatch watch_threshold;
  record.threshold = resolve_threshold(options, talk, record);
  record.seconds.decimate = watch_threshold.seconds();
  if (options.has_cost_by_effort) {
    SimplifyOptions open = resolved(options, record);
    open.decimate.cost.reset();
    options.request.simplify.decimate.cost =
        with_effort(options.request.effort, std::move(open), record.input.read.mesh, record.target).decimate.cost;
  }
  simplify_input(options, talk, record);
  options.request.simplify.decimate.cost = record.simplified.cost;
  take_warnings(talk, record);
  record.met = is_met(record.target, record.simplified.result.stop);

  if (!record.met) record.shortfall = shortfall(options, record);
  warn_of_result(options, talk, record);
  count_intersections(options, talk, record);
  measure_curve(options, talk, record);
  if (!record.met) record.warnings.push_back(record.shortfall);
  write_files(options, talk, watch, record, report);

  say_details(options, talk, record);
  talk.say(summary(options, record));
  if (record.met) return ExitCode::done;
  if (!options.strict) {
    talk.warning(record.shortfall);
    return ExitCode::done;
  }
  talk.error(record.shortfall);
  return ExitCode::target_not_met;
}

ExitCode run_simplify(const Given& given, SimplifyCommand command) {
  command = settled(std::move(command));
  refuse_count_of_verbose(command);
  check_options(command);
  std::vector<SimplifyCommand> runs = runs_of(command);
  check_files(runs);
  for (SimplifyCommand& run : runs) run.warnings = idle_options(given, run);
  if (!is_named_by_stem(command)) return simplify_one(runs.front(), nullptr);
  for (SimplifyCommand& run : runs) run.common.json.reset();  // there is one report of all
  return run_each(command, runs, simplify_one);
}

}  // namespace

void setup_simplify(CLI::App& app, Command& command) {
  const SubcommandText text{"simplify", "Make a mesh smaller and keep its shape.", "IN... -o OUT TARGET... [OPTION]...",
                            "Examples:\n"
                            "  whittle simplify dragon.ply -o small.ply --ratio 10%\n"
                            "  whittle simplify part.stl -o part.obj --faces 5000 --strict --json report.json\n"
                            "  whittle simplify *.stl -o 'out/{stem}.ply' --face-ratio 10%\n"
                            "  whittle simplify bone_*.stl --join -o hand.ply --face-ratio 10%\n"
                            "  whittle simplify - -o - --format ply --faces 5000 < in.ply > out.ply"};
  SimplifyCommand defaults;
  defaults.files.reads_documents = defaults.files.writes_documents = true;
  add_subcommand(app, text, defaults, simplify_rows, run_simplify, command);
}

}  // namespace whittle::app
