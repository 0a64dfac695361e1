#include "whittle/polish/polish.hh"

#include <string>
#include <vector>

#include "commands/subcommands.hh"
#include "files/input.hh"
#include "files/mesh_output.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "system/system.hh"
#include "terminal/interruption.hh"
#include "terminal/progress_bar.hh"
#include "terminal/table.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/progress.hh"
#include "whittle/pipeline/json.hh"
#include "whittle/pipeline/polish_to_reference.hh"

namespace whittle::app {
namespace {

struct PolishCommand {
  std::string reference;
  std::string input;
  std::string output;
  FileOptions files;
  gltf::WriteOptions gltf;
  unsigned passes = 3;
  Fit fit = Fit::balanced;
  CommonOptions common;
};

struct PolishRun {
  Input reference;
  Input input;
  IndexedMesh mesh;
  PolishResult result;
  double polish_seconds = 0;
  double write_seconds = 0;
  std::vector<std::string> warnings;
};

OptionRows polish_rows(PolishCommand& options) {
  OptionRows rows{file_argument("REF", options.reference, "the mesh it was made from, or '-' for standard input"),
                  file_argument("IN", options.input, "the simplified mesh, or '-' for standard input"),
                  output_row(options.output, "the result: a file, replaced if it exists, or '-' for standard output"),
                  {.names = "--passes",
                   .access = count(options.passes, 0, 1000),
                   .help = "number of fitting passes; they stop when one no longer reduces the error",
                   .key = "passes"},
                  fit_row(options.fit)};
  append(rows, file_rows(options.files));
  append(rows, gltf_rows(options.gltf));
  append(rows, common_rows(options.common));
  return rows;
}

Json polish_report(PolishCommand& options, const PolishRun& run, double total_seconds) {
  const double diagonal = diagonal_of(bounds_of(run.reference.read.mesh));
  Json json = new_report();
  json["reference"] = input_json(run.reference, diagonal);
  json["input"] = input_json(run.input, diagonal_of(bounds_of(run.input.read.mesh)));
  json["options"] = options_json(polish_rows(options));
  json["output"] = {{"path", options.output}};
  json["polish"] = polish_json(run.result);
  json["seconds"] = {{"read", run.reference.seconds + run.input.seconds},
                     {"polish", run.polish_seconds},
                     {"write", run.write_seconds},
                     {"total", total_seconds}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = run.warnings;
  return json;
}

/// The result and the report appear together, or neither does.
void write_files(PolishCommand& options, const Talk& talk, const Stopwatch& since_start, PolishRun& run) {
  const Stopwatch watch;
  OutputFiles files(options.common.force);
  files.protect(run.reference.needed_files);
  files.protect(run.input.needed_files);
  write_result(files, output_of(options.output, options.files, options.gltf), run.input, run.mesh, talk, run.warnings);
  run.write_seconds = watch.seconds();
  commit_with_report(files, options.common, [&] { return polish_report(options, run, since_start.seconds()); });
}

void check(const PolishCommand& options) {
  check_formats({options.reference, options.input}, {options.output}, options.files);
  std::vector<Output> outputs{{"--output", options.output}};
  if (options.common.json) outputs.push_back({"--json", *options.common.json});
  check_outputs(outputs, {options.reference, options.input}, options.common.force);
}

/// \throw Interrupted
void polish_input(const PolishCommand& options, const Talk& talk, PolishRun& run) {
  run.mesh = run.input.read.mesh;
  PolishRequest request{.passes = options.passes, .fit = options.fit, .threads = options.common.threads};
  request.locked = held_borders(run.input, options.common.threads, talk, run.warnings);
  ProgressBar bar(talk, "polishing");
  request.progress = part_of(bar, 0, 1);
  const SignalsWait signals_wait;
  try {
    run.result = polish_to_reference(run.reference.read.mesh, run.mesh, request);
  } catch (const Cancelled&) {
    // The signal that cancelled the search is thrown below.
  }
  SignalsWait::throw_if_pending();
}

ExitCode run_polish(const Given& /*given*/, PolishCommand options) {
  options.files.scope = scope_for(options.output, options.files);
  check(options);
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  PolishRun run;
  const auto all = io::AttributeScope::all;
  run.reference = read_input(options.reference, options.files, options.common.threads, talk, all);
  run.input = read_input(options.input, options.files, options.common.threads, talk, all);
  run.warnings = run.reference.warnings;
  run.warnings.insert(run.warnings.end(), run.input.warnings.begin(), run.input.warnings.end());
  const Stopwatch polishing;
  polish_input(options, talk, run);
  run.polish_seconds = polishing.seconds();
  write_files(options, talk, watch, run);
  const std::string what = options.passes == 0 ? "left as it was, no pass was asked for" : polish_text(run.result);
  talk.say(shown_output(options.output) + ": " + what + " in " + seconds_text(watch.seconds()));
  say_effort(talk, watch.seconds());
  return ExitCode::done;
}

}  // namespace

void setup_polish(CLI::App& app, Command& command) {
  const SubcommandText text{"polish", "Fit a simplified mesh, anyone's, to the mesh it was made from.",
                            "REF IN -o OUT [OPTION]...",
                            "Examples:\n"
                            "  whittle polish dragon.ply small.ply -o better.ply\n"
                            "  whittle polish part.stl part_of_another_program.obj -o part.obj --passes 1 --json -"};
  PolishCommand defaults;
  defaults.files.reads_documents = defaults.files.writes_documents = true;
  add_subcommand(app, text, defaults, polish_rows, run_polish, command);
}

}  // namespace whittle::app
