#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "commands/stage_bars.hh"
#include "commands/subcommands.hh"
#include "files/input.hh"
#include "files/mesh_output.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "system/system.hh"
#include "terminal/interruption.hh"
#include "terminal/table.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/progress.hh"
#include "whittle/core/text/text.hh"
#include "whittle/pipeline/levels.hh"
#include "whittle/pipeline/request.hh"
#include "whittle/pipeline/run.hh"
#include "whittle/scene/scene_document.hh"

namespace whittle::app {
namespace {

struct LodCommand {
  std::string input;
  std::string output;
  LevelTargets targets;
  Effort effort = Effort::normal;
  Fit fit = Fit::balanced;
  FileOptions files;
  gltf::WriteOptions gltf;
  CommonOptions common;
};

/// A level, and where it is written.
struct LodLevel : Level {
  std::string path;
};

struct LodRun {
  Input input;
  double diagonal = 0;
  std::vector<LodLevel> levels;
  double levels_seconds = 0, write_seconds = 0;
  std::vector<std::string> warnings;
};

/// A list with commas. \param parse turns one of its texts into a value, or throws std::invalid_argument
template <class T, class Parse>
OptionAccess list(std::vector<T>& values, const std::string& meta, Parse parse) {
  const auto set = [&values, parse](std::string_view text) {
    values.clear();
    for (const std::string_view part : parts_of(text)) values.push_back(parse(part));
  };
  return {meta, set, [] { return OptionValue{}; }};
}

Length parse_above_zero(std::string_view text) {
  const Length length = parse_length(text, "E");
  if (!(length.value > 0)) throw std::invalid_argument("a length has to be above 0");
  return length;
}

OptionRows level_rows(LodCommand& options) {
  return in_group(
      {{.names = "--ratios",
        .access = list(options.targets.ratios, "R,...", parse_ratio),
        .help = "levels with these shares of the vertices: 0.5,0.25 or 50%,25%"},
       {.names = "--face-ratios",
        .access = list(options.targets.face_ratios, "R,...", parse_ratio),
        .help = "levels with these shares of the faces"},
       {.names = "--faces",
        .access = list(options.targets.faces, "N,...", [](std::string_view text) { return parse_count(text); }),
        .help = "levels with these numbers of faces"},
       {.names = "--errors",
        .access = list(options.targets.errors, "E,...", parse_above_zero),
        .help = "levels of few faces that are proven to be within these distances of IN, and IN of them: model units, "
                "or percentages of the diagonal such as 0.1%,0.5%"},
       {.names = "--distances",
        .access = list(options.targets.distances, "D,...", parse_above_zero),
        .help = "levels of few faces for a camera at these distances: seen from there and from farther away, a level "
                "is proven to be within --target-pixels of IN. Model units, or percentages of the diagonal such as "
                "200%,1000%"}},
      "Levels (one of these)");
}

/// How large errors look.
OptionRows view_rows(CameraView& view) {
  constexpr Range above_zero{0, std::numeric_limits<double>::infinity(), false};
  return {{.names = "--target-pixels",
           .access = number(view.target_pixels, above_zero, "P"),
           .help = "largest error on the screen, pixels: of --distances, and where levels in one glTF file take over",
           .key = "target_pixels"},
          {.names = "--view-height",
           .access = number(view.height, above_zero, "H"),
           .help = "height of the screen, pixels",
           .key = "view_height"},
          {.names = "--fov",
           .access = number(view.fov_deg, {0, 180, false, false}, "DEG"),
           .help = "field of view of --distances from the lower to the upper edge of the screen, degrees",
           .key = "fov"}};
}

/// How levels are made and written.
OptionRows setting_rows(LodCommand& options) {
  OptionRows rows = view_rows(options.targets.view);
  append(rows, {effort_row(options.effort), fit_row(options.fit)});
  append(rows, file_rows(options.files));
  append(rows, gltf_rows(options.gltf));
  return rows;
}

OptionRows lod_rows(LodCommand& options) {
  OptionRows rows{mesh_argument(options.input, options.files)};
  append(rows, level_rows(options));
  rows.push_back(output_row(
      options.output,
      "the levels: files, replaced if they exist; '{faces}' and '{vertices}' in it stand for the counts of each, '{i}' "
      "for its number, from 0. Without any of these one glTF file: IN, with the levels as levels of detail "
      "(MSFT_lod)"));
  append(rows, setting_rows(options));
  append(rows, common_rows(options.common));
  return rows;
}

/// The path of level i: words in braces are replaced.
std::string path_of(std::string path, std::size_t i, std::uint64_t n_faces, std::uint64_t n_vertices) {
  path = replaced(std::move(path), "{i}", std::to_string(i));
  path = replaced(std::move(path), "{faces}", std::to_string(n_faces));
  return replaced(std::move(path), "{vertices}", std::to_string(n_vertices));
}

/// Whether all levels go into one glTF file.
bool is_one_file(const LodCommand& options) {
  return path_of(options.output, 0, 1, 2) == options.output && writes_document(options.output, options.files);
}

/// The file for what all levels have in common: a template's words become one, "shared".
std::string shared_path_of(const std::string& output) {
  const std::size_t first = output.find('{');
  const std::size_t last = output.rfind('}');
  if (first == std::string::npos || last == std::string::npos || last < first) return {};
  const std::string name = output.substr(0, first) + "shared" + output.substr(last + 1);
  return name.substr(0, name.rfind('.')) + ".bin";
}

/// The file of a level, or of all.
SceneOutput level_output(const LodCommand& options, const std::string& path) {
  SceneOutput output = output_of(path, options.files, options.gltf);
  output.level_error_rel = options.targets.view.error_rel();
  if (!is_one_file(options)) output.shared_path = shared_path_of(options.output);
  return output;
}

/// \throw UsageError if the scene hasn't more faces than a number
std::vector<LodLevel> levels_of(const LodCommand& options, const SimplifyOptions& simplify, LodRun& run) {
  const SceneOutput output = level_output(options, path_of(options.output, 0, 1, 2));
  const SceneReadOptions reading = read_options(options.files, options.common.threads);
  std::vector<LodLevel> levels;
  try {
    Levels made = make_levels(run.input, options.targets, options.effort, simplify, output, reading);
    for (Level& level : made.levels) levels.push_back({std::move(level), {}});
    run.warnings.insert(run.warnings.end(), made.warnings.begin(), made.warnings.end());
  } catch (const std::invalid_argument& problem) {
    throw UsageError((options.targets.faces.empty() ? "" : "--faces: ") + std::string(problem.what()));
  } catch (const Cancelled&) {
    // The signal that cancelled it is thrown by whoever waits for it.
  }
  return levels;
}

/// \throw UsageError if two files would be written to the same place
void name_levels(const LodCommand& options, LodRun& run) {
  for (std::size_t i = 0; i < run.levels.size(); ++i) {
    LodLevel& level = run.levels[i];
    const IndexedMesh& mesh = level.simplified.mesh;
    level.path = path_of(options.output, i, mesh.faces.size(), mesh.positions.size());
    if (!is_one_file(options) && i > 0 && level.path == run.levels[i - 1].path) {
      throw UsageError("two levels would be written to " + level.path + "; use '{i}' in --output");
    }
  }
  if (is_one_file(options)) return;
  std::vector<Output> outputs;
  for (const LodLevel& level : run.levels) outputs.push_back({"--output", level.path});
  if (options.common.json) outputs.push_back({"--json", *options.common.json});
  check_outputs(outputs, {options.input}, options.common.force);
}

Json lod_json(LodCommand& options, const LodRun& run, double total_seconds) {
  Json json = new_report();
  json["input"] = input_json(run.input, run.diagonal);
  json["options"] = options_json(setting_rows(options));
  json["levels"] = Json::array();
  for (const LodLevel& level : run.levels) {
    Json one = {{"path", level.path},
                {"vertices", level.simplified.mesh.positions.size()},
                {"faces", level.simplified.mesh.faces.size()},
                {"max_cost", level.simplified.result.max_cost}};
    one["max_error"] = level.error ? Json(*level.error) : Json(nullptr);
    one["distance"] = level.distance ? Json(*level.distance) : Json(nullptr);
    json["levels"].push_back(std::move(one));
  }
  json["seconds"] = {{"read", run.input.seconds},
                     {"levels", run.levels_seconds},
                     {"write", run.write_seconds},
                     {"total", total_seconds}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = run.warnings;
  return json;
}

/// \throw UsageError if a view is given that nothing depends on
void check_view(const Given& given, const LodCommand& options) {
  if (!options.targets.distances.empty()) return;
  if (given.is_given("--fov")) throw UsageError("--fov is for --distances");
  if (is_one_file(options)) return;
  for (const char* const option : {"--target-pixels", "--view-height"}) {
    if (!given.is_given(option)) continue;
    throw UsageError(std::string(option) + " is for --distances, and for levels in one glTF file");
  }
}

void check(const LodCommand& options) {
  if (options.targets.n_kinds() != 1) {
    throw UsageError("one of --ratios, --face-ratios, --faces, --errors and --distances is needed, and only one");
  }
  if (path_of(options.output, 0, 1, 2) == options.output && !is_one_file(options)) {
    throw UsageError(
        "--output needs '{faces}', '{vertices}' or '{i}' in it, such as 'out_{faces}.ply', or has to be one glTF file");
  }
  check_formats({options.input}, {options.output}, options.files);
  check_rounding(options.output, options.files, options.gltf);
  std::vector<Output> outputs{{"--output", options.output}};
  if (options.common.json) outputs.push_back({"--json", *options.common.json});
  check_outputs(outputs, {options.input}, options.common.force);
}

SimplifyOptions library_options(const LodCommand& options, StageBars& bars) {
  SimplifyOptions simplify;
  simplify.fit = options.fit;
  simplify.decimate.threads = options.common.threads;
  simplify.decimate.progress = [&bars](const Progress& progress) { return bars.update(progress); };
  return simplify;
}

void write_into_one_file(const LodCommand& options, const Talk& talk, OutputFiles& files, LodRun& run) {
  std::vector<const IndexedMesh*> levels;
  for (const LodLevel& level : run.levels) levels.push_back(&level.simplified.mesh);
  write_levels(files, level_output(options, options.output), run.input, levels, talk, run.warnings);
}

void write_files(LodCommand& options, const Talk& talk, const Stopwatch& since_start, LodRun& run) {
  const Stopwatch writing;
  OutputFiles files(options.common.force);
  files.protect(run.input.needed_files);
  if (is_one_file(options)) {
    write_into_one_file(options, talk, files, run);
  } else {
    for (const LodLevel& level : run.levels) {
      write_result(files, level_output(options, level.path), run.input, level.simplified.mesh, talk, run.warnings);
    }
  }
  run.write_seconds = writing.seconds();
  commit_with_report(files, options.common, [&] { return lod_json(options, run, since_start.seconds()); });
}

/// \throw UsageError for one file of levels, if its nodes have levels already
void check_input(const LodCommand& options, const Scene& input) {
  if (!is_one_file(options) || !keeps_meshes(input)) return;
  const std::string mesh = input.document->mesh_with_levels();
  if (mesh.empty()) return;
  throw UsageError(input.name + ": " + mesh +
                   " has levels of detail already (MSFT_lod); use '{i}' in --output to write a file a level");
}

/// "p_0.ply: 100 faces, 52 vertices, within 0.1 (1 %), which is 1 pixel at 17.3 (173 %)"
std::string text_of(const LodLevel& level, std::size_t number, const LodCommand& options, const LodRun& run) {
  const IndexedMesh& mesh = level.simplified.mesh;
  std::string line = level.path;
  if (is_one_file(options)) line += ": level " + std::to_string(number + 1);
  line += ": " + faces_text(mesh.faces.size()) + ", " + vertices_text(mesh.positions.size());
  if (level.error) line += ", within " + length_text_rounded_up(*level.error, run.diagonal);
  if (level.distance) {
    const double pixels = options.targets.view.target_pixels;
    line += ", which is " + significant(pixels) + (pixels == 1 ? " pixel" : " pixels") + " at " +
            length_text_rounded_up(*level.distance, run.diagonal);
  }
  return line;
}

ExitCode run_lod(const Given& given, LodCommand options) {
  options.files.scope = scope_for(path_of(options.output, 0, 1, 2), options.files);
  check(options);
  check_view(given, options);
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  LodRun run;
  run.input = read_input(options.input, options.files, options.common.threads, talk, io::AttributeScope::all);
  check_input(options, run.input);
  run.warnings = run.input.warnings;
  run.diagonal = diagonal_of(bounds_of(run.input.read.mesh));
  const std::vector<std::uint8_t> held = held_borders(run.input, options.common.threads, talk, run.warnings);
  const std::size_t n_told = run.warnings.size();
  const Stopwatch working;
  {
    StageBars bars(talk);
    const SignalsWait signals_wait;
    SimplifyOptions simplify = library_options(options, bars);
    simplify.decimate.locked = held;
    run.levels = levels_of(options, simplify, run);
    SignalsWait::throw_if_pending();
  }
  for (std::size_t i = n_told; i < run.warnings.size(); ++i) talk.warning(run.warnings[i]);
  run.levels_seconds = working.seconds();
  name_levels(options, run);
  write_files(options, talk, watch, run);
  for (std::size_t i = 0; i < run.levels.size(); ++i) talk.say(text_of(run.levels[i], i, options, run));
  say_effort(talk, watch.seconds());
  return ExitCode::done;
}

}  // namespace

void setup_lod(CLI::App& app, Command& command) {
  const SubcommandText text{"lod", "Write several levels of detail out of one run.", "IN -o OUT LEVELS [OPTION]...",
                            "Examples:\n"
                            "  whittle lod dragon.ply --ratios 50%,25%,10% -o 'dragon_{faces}.ply'\n"
                            "  whittle lod helmet.glb --ratios 50%,10% -o helmet_levels.glb\n"
                            "  whittle lod part.stl --errors 0.1%,0.5%,1% -o 'part_{i}.obj'\n"
                            "  whittle lod helmet.glb --distances 200%,1000% -o 'helmet_{i}.gltf'"};
  LodCommand defaults;
  defaults.files.reads_documents = defaults.files.writes_documents = true;
  add_subcommand(app, text, defaults, lod_rows, run_lod, command);
}

}  // namespace whittle::app
