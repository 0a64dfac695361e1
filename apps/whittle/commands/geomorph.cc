#include "whittle/progressive/geomorph.hh"

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "commands/recording/recording_input.hh"
#include "commands/subcommands.hh"
#include "files/mesh_output.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "system/system.hh"
#include "terminal/errors.hh"
#include "terminal/table.hh"
#include "whittle/core/progress.hh"

namespace whittle::app {
namespace {

using progressive::Geomorph;
using progressive::NormalBlend;
using progressive::Replay;

constexpr std::array<Choice<NormalBlend>, 2> normal_blends{
    {{"spherical", NormalBlend::spherical}, {"linear", NormalBlend::linear}}};

struct GeomorphCommand {
  RecordingInput recording;
  std::string output;
  std::optional<std::uint64_t> from, to;  ///< numbers of faces; empty: the first level, the last one
  std::optional<std::uint64_t> n_frames;
  NormalBlend normal_blend = NormalBlend::spherical;
  FileOptions files;
  CommonOptions common;
};

struct GeomorphRun {
  RecordingFacts recording;
  std::vector<std::string> paths;
  std::uint64_t n_vertices = 0, n_fine_faces = 0, n_coarse_faces = 0;
  double read_seconds = 0, geomorph_seconds = 0, write_seconds = 0;
  std::vector<std::string> warnings;
};

void check(const GeomorphCommand& options, GeomorphRun& run) {
  check_number(options.output, "--frames", options.n_frames.has_value());
  if (!options.n_frames && options.output != standard_stream && !options.output.ends_with(".glb")) {
    throw UsageError(
        "--output: a geomorph is written as glTF, to a file whose name ends with .glb; --frames writes meshes");
  }
  const std::size_t n = options.n_frames.value_or(1);
  std::vector<Output> outputs;
  for (std::size_t i = 0; i < n; ++i) {
    run.paths.push_back(numbered(options.output, i, n));
    outputs.push_back({"--output", run.paths.back()});
  }
  if (options.common.json) outputs.push_back({"--json", *options.common.json});
  check_recording_outputs(options.recording, options.n_frames ? run.paths : std::vector<std::string>(), outputs,
                          options.files, options.common);
}

Geomorph geomorph_of(const GeomorphCommand& options, Replay& replay) {
  const std::size_t fine = options.from ? level_of_faces(options.recording, replay, *options.from) : 0;
  const std::size_t coarse = options.to ? level_of_faces(options.recording, replay, *options.to) : replay.n_steps();
  if (coarse < fine) throw UsageError("--to: the level to go to has more faces than the one to come from");
  try {
    return {replay, fine, coarse};
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(options.recording.path + ": " + error.what() +
                             "; go to an earlier level, or record without '--effort best'");
  }
}

void write_geomorph(const GeomorphCommand& options, const Geomorph& geomorph, OutputFiles& files, const Talk& talk,
                    GeomorphRun& run) {
  if (!options.n_frames) {
    files.write(run.paths.front(), [&geomorph](std::ostream& out) { write_glb(out, geomorph); });
    return;
  }
  Scene scene;
  scene.path = standard_stream;  // without a folder that textures would be copied from
  scene.read.notes = run.recording.notes;
  for (std::size_t i = 0; i < run.paths.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(run.paths.size() - 1);
    write_result(files, output_of(run.paths[i], options.files), scene, geomorph.at(share, options.normal_blend), talk,
                 run.warnings);
  }
}

void warn_of_left_out(const GeomorphCommand& options, const Talk& talk, GeomorphRun& run) {
  if (run.recording.left_out.empty()) return;
  run.warnings.push_back(about(shown_output(options.output), "left out: " + listed(run.recording.left_out)));
  talk.warning(run.warnings.back());
}

Json geomorph_json(const GeomorphRun& run, double total_seconds) {
  Json json = new_report();
  json["recording"] = recording_json(run.recording);
  json["paths"] = run.paths;
  json["vertices"] = run.n_vertices;
  json["from_faces"] = run.n_fine_faces;
  json["to_faces"] = run.n_coarse_faces;
  json["seconds"] = {{"read", run.read_seconds},
                     {"geomorph", run.geomorph_seconds},
                     {"write", run.write_seconds},
                     {"total", total_seconds}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = run.warnings;
  return json;
}

ExitCode run_geomorph(const Given& given, GeomorphCommand options) {
  GeomorphRun run;
  check(options, run);
  const Talk talk = options.common.talk();
  run.warnings = given.idle;
  for (const std::string& warning : run.warnings) talk.warning(warning);
  const Stopwatch watch;
  Replay replay = read_replay(options.recording, options.files, options.common.threads, talk, run.recording);
  run.read_seconds = watch.seconds();
  warn_of_left_out(options, talk, run);
  const Stopwatch morphing;
  const Geomorph geomorph = geomorph_of(options, replay);
  run.n_vertices = geomorph.fine().positions.size();
  run.n_fine_faces = geomorph.fine().faces.size();
  run.n_coarse_faces = geomorph.n_coarse_faces();
  run.geomorph_seconds = morphing.seconds();
  const Stopwatch writing;
  OutputFiles files(options.common.force);
  write_geomorph(options, geomorph, files, talk, run);
  run.write_seconds = writing.seconds();
  commit_with_report(files, options.common, [&] { return geomorph_json(run, watch.seconds()); });
  const std::string frames = options.n_frames ? counted(*options.n_frames, "frame", "frames") + " " : std::string();
  talk.say(shown_output(options.output) + ": " + frames + "from " + faces_text(run.n_fine_faces) + " to " +
           std::to_string(run.n_coarse_faces) + " in " + seconds_text(watch.seconds()));
  say_effort(talk, watch.seconds());
  return ExitCode::done;
}

OptionRows geomorph_rows(GeomorphCommand& options) {
  constexpr std::uint64_t fewest = 2;
  constexpr std::uint64_t most = 1'000'000;
  OptionRows rows{
      recording_argument(options.recording),
      output_row(options.output,
                 "a .glb file with a morph target, replaced if it exists, or '-' for standard output; with --frames, "
                 "meshes"),
      {.names = "--from",
       .access = count(options.from),
       .help = "begin at the first level of at most N faces",
       .standard = "the input"},
      {.names = "--to",
       .access = count(options.to),
       .help = "end at the first level of at most N faces",
       .standard = "the last level"},
      {.names = "--frames",
       .access = count(options.n_frames, fewest, most),
       .help = "write N meshes on the way, both ends among them; '{i}' in OUT stands for the number of each"},
      {.names = "--normal-blend",
       .access = choice(options.normal_blend, normal_blends),
       .help = "how normals turn in --frames: at a constant speed, or as glTF does",
       .idle = {{.without = {"--frames"}}}},
      recording_input_row(options.recording)};
  append(rows, file_rows(options.files));
  for (OptionRow& row : rows) {
    const std::string name = long_name(row);
    if (name == "--ascii" || name == "--output-format") row.idle.push_back({.without = {"--frames"}});
  }
  append(rows, common_rows(options.common));
  return rows;
}

}  // namespace

void setup_geomorph(CLI::App& app, Command& command) {
  const SubcommandText text{"geomorph", "Write a continuous way between two levels of a recording, as glTF.",
                            "REC -o OUT [OPTION]...",
                            "Examples:\n"
                            "  whittle simplify dragon.ply -o small.ply --ratio 1% --record dragon.rec\n"
                            "  whittle geomorph dragon.rec --from 50000 --to 10000 -o morph.glb\n"
                            "  whittle geomorph dragon.rec --from 50000 --frames 48 -o 'frame_{i}.ply'"};
  GeomorphCommand defaults;
  defaults.files.reads_documents = true;
  add_subcommand(app, text, defaults, geomorph_rows, run_geomorph, command);
}

}  // namespace whittle::app
