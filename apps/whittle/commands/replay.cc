#include "whittle/progressive/replay.hh"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/recording/recording_input.hh"
#include "commands/subcommands.hh"
#include "files/mesh_output.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "system/system.hh"
#include "terminal/table.hh"
#include "whittle/core/progress.hh"

namespace whittle::app {
namespace {

using progressive::Replay;

/// Levels at even distances.
struct Series {
  double from, to;  ///< shares of the contractions
  std::uint64_t n;
};

struct ReplayCommand {
  RecordingInput recording;
  std::string output;
  std::optional<std::uint64_t> faces, vertices;
  std::optional<double> cost, at;
  std::optional<Series> series;
  FileOptions files;
  gltf::WriteOptions gltf;
  CommonOptions common;
};

/// A level that was written.
struct ReplayLevel {
  std::string path;
  std::size_t n_contractions;
  std::uint64_t n_vertices, n_faces;
  double cost;
};

struct ReplayRun {
  RecordingFacts recording;
  std::vector<ReplayLevel> levels;
  double read_seconds = 0, replay_seconds = 0, write_seconds = 0;
  std::vector<std::string> warnings;
};

constexpr Range share_range{0, 1};

Series parse_series(std::string_view text) {
  const std::size_t first = text.find(':');
  const std::size_t second = first == std::string_view::npos ? first : text.find(':', first + 1);
  if (second == std::string_view::npos) {
    throw std::invalid_argument("'" + std::string(text) + "' is not of the form A:B:N, such as 0:1:50");
  }
  constexpr std::uint64_t fewest = 2;
  constexpr std::uint64_t most = 1'000'000;
  return {parse_number(text.substr(0, first), share_range, "A"),
          parse_number(text.substr(first + 1, second - first - 1), share_range, "B"),
          parse_count(text.substr(second + 1), fewest, most)};
}

/// \throw std::runtime_error if there is no such level
std::size_t level_of(const ReplayCommand& options, const Replay& replay) {
  if (options.cost) return replay.level_of_cost(*options.cost);
  if (options.at) return replay.level_at(*options.at);
  if (options.faces) return level_of_faces(options.recording, replay, *options.faces);
  return level_of_vertices(options.recording, replay, *options.vertices);
}

std::vector<std::size_t> levels_of(const ReplayCommand& options, const Replay& replay) {
  if (!options.series) return {level_of(options, replay)};
  const auto& [from, to, n] = *options.series;
  std::vector<std::size_t> levels;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double share = from + (to - from) * static_cast<double>(i) / static_cast<double>(n - 1);
    levels.push_back(replay.level_at(share));
  }
  return levels;
}

Json replay_json(const ReplayRun& run, double total_seconds) {
  Json json = new_report();
  json["recording"] = recording_json(run.recording);
  json["levels"] = Json::array();
  for (const ReplayLevel& level : run.levels) {
    json["levels"].push_back({{"path", level.path},
                              {"contractions", level.n_contractions},
                              {"vertices", level.n_vertices},
                              {"faces", level.n_faces},
                              {"max_cost", level.cost}});
  }
  json["seconds"] = {{"read", run.read_seconds},
                     {"replay", run.replay_seconds},
                     {"write", run.write_seconds},
                     {"total", total_seconds}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = run.warnings;
  return json;
}

void check(const ReplayCommand& options) {
  const int n_given = int{options.faces.has_value()} + int{options.vertices.has_value()} +
                      int{options.cost.has_value()} + int{options.at.has_value()} + int{options.series.has_value()};
  if (n_given != 1) throw UsageError("one of --faces, --vertices, --cost, --at and --steps is needed, and only one");
  check_number(options.output, "--steps", options.series.has_value());
  const std::size_t n = options.series ? options.series->n : 1;
  std::vector<std::string> meshes;
  std::vector<Output> outputs;
  for (std::size_t i = 0; i < n; ++i) {
    meshes.push_back(numbered(options.output, i, n));
    outputs.push_back({"--output", meshes.back()});
  }
  if (options.common.json) outputs.push_back({"--json", *options.common.json});
  check_recording_outputs(options.recording, meshes, outputs, options.files, options.common);
}

/// Without the file that it comes from, a level has the texture coordinates of other formats.
void write_level(const ReplayCommand& options, const std::string& path, RecordedRun& recorded, IndexedMesh mesh,
                 OutputFiles& files, const Talk& talk, ReplayRun& run) {
  if (recorded.texcoords_grow_down && !recorded.input.document) flip_texcoords(mesh);
  write_result(files, output_of(path, options.files, options.gltf), recorded.input, mesh, talk, run.warnings);
}

void write_levels(const ReplayCommand& options, RecordedRun& recorded, OutputFiles& files, const Talk& talk,
                  ReplayRun& run) {
  Replay& replay = recorded.replay;
  const std::vector<std::size_t> levels = levels_of(options, replay);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Stopwatch replaying;
    replay.go_to(levels[i]);
    Decimation level = replay.decimation();
    run.replay_seconds += replaying.seconds();
    const Stopwatch writing;
    const std::string path = numbered(options.output, i, levels.size());
    write_level(options, path, recorded, std::move(level.mesh), files, talk, run);
    run.write_seconds += writing.seconds();
    run.levels.push_back(
        {path, level.result.n_contractions, level.result.n_vertices, level.result.n_faces, level.result.max_cost});
  }
}

ExitCode run_replay(const Given& /*given*/, ReplayCommand options) {
  check(options);
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  ReplayRun run;
  RecordedRun recorded =
      read_recorded_run(options.recording, options.files, options.common.threads, talk, run.recording);
  run.read_seconds = watch.seconds();
  OutputFiles files(options.common.force);
  files.protect(recorded.input.needed_files);
  write_levels(options, recorded, files, talk, run);
  commit_with_report(files, options.common, [&] { return replay_json(run, watch.seconds()); });
  const ReplayLevel& last = run.levels.back();
  const std::string what =
      options.series ? counted(run.levels.size(), "level", "levels") + ", the last of " + faces_text(last.n_faces)
                     : faces_text(last.n_faces) + ", " + vertices_text(last.n_vertices);
  talk.say(shown_output(options.output) + ": " + what + " in " + seconds_text(watch.seconds()));
  say_effort(talk, watch.seconds());
  return ExitCode::done;
}

OptionRows level_rows(ReplayCommand& options) {
  const auto set_series = [&options](std::string_view text) { options.series = parse_series(text); };
  return in_group(
      {{.names = "--faces", .access = count(options.faces), .help = "the first level of at most N faces"},
       {.names = "--vertices", .access = count(options.vertices), .help = "the first level of at most N vertices"},
       {.names = "--cost",
        .access = number(options.cost, {0}, "C"),
        .help = "the last level to which no contraction costs more than C, in the unit of the run's cost"},
       {.names = "--at",
        .access = number(options.at, share_range, "T"),
        .help = "the level after this share of the contractions: 0 is the input, 1 the result of the run"},
       {.names = "--steps",
        .access = {"A:B:N", set_series, [] { return OptionValue{}; }},
        .help = "N levels at even distances, from --at A to --at B; '{i}' in --output stands for the number of each"}},
      "Levels (one of these)");
}

OptionRows replay_rows(ReplayCommand& options) {
  OptionRows rows{recording_argument(options.recording)};
  append(rows, level_rows(options));
  append(rows, {output_row(options.output, "the level: a file, replaced if it exists, or '-' for standard output"),
                recording_input_row(options.recording,
                                    ", or for what the mesh in REC lacks, such as the materials of glTF")});
  append(rows, file_rows(options.files));
  append(rows, gltf_rows(options.gltf));
  append(rows, common_rows(options.common));
  return rows;
}

}  // namespace

void setup_replay(CLI::App& app, Command& command) {
  const SubcommandText text{"replay", "Write any level of detail out of a recording of 'simplify'.",
                            "REC -o OUT LEVEL [OPTION]...",
                            "Examples:\n"
                            "  whittle simplify dragon.ply -o small.ply --ratio 1% --record dragon.rec\n"
                            "  whittle replay dragon.rec --faces 20000 -o medium.ply\n"
                            "  whittle replay dragon.rec --steps 0:1:50 -o 'frame_{i}.ply'"};
  ReplayCommand defaults;
  defaults.files.reads_documents = defaults.files.writes_documents = true;
  add_subcommand(app, text, defaults, replay_rows, run_replay, command);
}

}  // namespace whittle::app
