#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/page/live/live_page.hh"
#include "commands/simplify/simplify_files.hh"
#include "commands/simplify/simplify_record.hh"
#include "commands/simplify/simplify_report.hh"
#include "commands/simplify/simplify_runs.hh"
#include "commands/simplify/simplify_texts.hh"
#include "commands/stage_bars.hh"
#include "commands/subcommands.hh"
#include "files/failure.hh"
#include "files/input.hh"
#include "files/mesh_output.hh"
#include "pictures/moment_pictures.hh"
#include "terminal/errors.hh"
#include "terminal/interruption.hh"
#include "whittle/core/progress.hh"

namespace whittle::app {
namespace {

/// Says warnings, and keeps them for the report.
void warn(const std::vector<std::string>& warnings, const Talk& talk, SimplifyRecord& record) {
  for (const std::string& warning : warnings) talk.warning(warning);
  record.warnings.insert(record.warnings.end(), warnings.begin(), warnings.end());
}

Input read(const SimplifyCommand& options, const Request& request, const Talk& talk) {
  const unsigned threads = options.common.threads;
  const io::AttributeScope attributes = request.reading.attributes;
  return options.joins ? read_joined(options.inputs, options.files, threads, talk, attributes)
                       : read_input(options.input, options.files, threads, talk, attributes);
}

void make_plan(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  Request request = request_of(options);
  request.output = output_of(options.output, options.files, options.gltf);
  Input input = read(options, request, talk);
  record.read_seconds = input.seconds;
  warn(options.warnings, talk, record);
  record.warnings.insert(record.warnings.end(), input.warnings.begin(), input.warnings.end());  // they are said
  const Stopwatch watch;
  record.plan = plan(std::move(input), request);
  record.plan_seconds = watch.seconds();
  for (const std::string& note : record.plan.notes) talk.say(note);
  warn(warnings_of_engine(options, record.plan.scene), talk, record);
  warn(record.plan.warnings, talk, record);
}

/// \throw UnsupportedMesh if a file is asked for that says something of a run, and there is nothing to simplify
void refuse_files_of_no_run(SimplifyCommand options, const Plan& plan) {
  if (plan.has_faces()) return;
  for (const SideFile& file : side_files(options)) {
    if (!*file.path) continue;
    throw UnsupportedMesh(plan.scene.name + ": " + why_no_faces(plan.scene.read) + "; there is nothing to write for " +
                          file.option);
  }
}

/// What shows a run while it goes on.
struct Watchers {
  std::optional<LivePage> page;
  std::optional<MomentPictures> pictures;

  /// \return whether the run goes on
  bool update(const RunProgress& progress) {
    return (!page || page->update(progress)) && (!pictures || pictures->update(progress));
  }
  void throw_if_failed() const {
    if (page) page->throw_if_failed();
    if (pictures) pictures->throw_if_failed();
  }
};

/// Signals end the program at once while OpenMesh's decimater runs. It would check for them too rarely, and there are
/// no temporary files yet.
void run_plan(const SimplifyCommand& options, const Talk& talk, Watchers& watchers, SimplifyRecord& record) {
  StageBars bars(talk);
  const bool waits = options.engine == Engine::flat;
  std::optional<SignalsWait> signals_wait;
  if (waits) signals_wait.emplace();
  try {
    record.outcome = run(
        record.plan, [&](const RunProgress& progress) { return bars.update(progress) && watchers.update(progress); });
  } catch (const Cancelled&) {
    SignalsWait::throw_if_pending();
    watchers.throw_if_failed();
    throw;
  }
  if (waits) SignalsWait::throw_if_pending();
}

void warn_of_outcome(const Talk& talk, SimplifyRecord& record) {
  if (record.outcome.shortfall) record.shortfall = shortfall_text(record.plan, record.outcome);
  std::vector<std::string> warnings;
  for (const RunWarning& warning : record.outcome.warnings) warnings.push_back(warning.text);
  warn(warnings, talk, record);
}

void measure_curve(const SimplifyCommand& options, const Talk& talk, SimplifyRecord& record) {
  if (!options.curve) return;
  const Stopwatch watch;
  constexpr std::size_t samples = 100'000;
  const IndexedMesh input = recorded_input(record);
  progressive::Replay replay(input, record.outcome.simplified.steps, Normals::drop);
  record.curve = measure_curve(replay, samples, options.common.threads, talk);
  record.curve_seconds = watch.seconds();
}

/// Copies the planned options into the request, for the report.
void take_settled(const SimplifyRecord& record, Request& request) {
  request.simplify.decimate.cost = record.outcome.simplified.cost;
  request.simplify.polish_passes = record.plan.options.polish_passes;
  request.simplify.flips = record.plan.options.flips;
}

/// \return the exit status
ExitCode say_outcome(const SimplifyCommand& options, const Talk& talk, const SimplifyRecord& record) {
  say_details(options, talk, record);
  talk.say(summary(options, record));
  if (record.outcome.met || record.shortfall.empty()) return ExitCode::done;
  if (options.strict) {
    talk.error(record.shortfall);
    return ExitCode::target_not_met;
  }
  talk.warning(record.shortfall);
  return ExitCode::done;
}

/// All that comes after the plan.
void run_and_write(SimplifyCommand& options, const Talk& talk, const Stopwatch& watch, Watchers& watchers,
                   SimplifyRecord& record, Json* report) {
  if (options.pictures.is_given()) watchers.pictures.emplace(options.pictures, record.plan, watch);
  run_plan(options, talk, watchers, record);
  take_settled(record, options.request);
  warn_of_outcome(talk, record);
  if (watchers.page) watchers.page->show(record.outcome.simplified.mesh, "measuring and writing");
  measure_curve(options, talk, record);
  if (!record.shortfall.empty()) record.warnings.push_back(record.shortfall);
  write_files(options, talk, watch, record, report);
  if (watchers.pictures) watchers.pictures->keep();
}

/// The same. The page of a run that fails says why.
void run_to_the_end(SimplifyCommand& options, const Talk& talk, const Stopwatch& watch, SimplifyRecord& record,
                    Json* report) {
  Watchers watchers;
  if (options.live) watchers.page.emplace(*options.live, record.plan, options.output, options.common.force, watch);
  try {
    run_and_write(options, talk, watch, watchers, record, report);
  } catch (const Interrupted&) {
    if (watchers.page) watchers.page->end("interrupted");
    throw;
  } catch (const Cancelled&) {  // by a signal, while something was measured
    if (watchers.page) watchers.page->end("interrupted");
    SignalsWait::throw_if_pending();
    throw;
  } catch (...) {
    if (watchers.page) watchers.page->end(current_failure().problem);
    throw;
  }
}

/// One run, of `options.input`. \param report becomes the report, even without --json; may be null
ExitCode simplify_one(SimplifyCommand options, Json* report) {
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  options.files.takes_no_triangles = options.files.scope != SceneScope::scene;
  SimplifyRecord record;
  make_plan(options, talk, record);
  refuse_files_of_no_run(options, record.plan);
  run_to_the_end(options, talk, watch, record, report);
  return say_outcome(options, talk, record);
}

ExitCode run_simplify(const Given& given, SimplifyCommand command) {
  command.files.scope = scope_for(command.output, command.files, command.request.keeps_attributes);
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
