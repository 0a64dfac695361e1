#include <bit>
#include <optional>
#include <string>
#include <vector>

#include "commands/subcommands.hh"
#include "files/input.hh"
#include "files/mesh_output.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "pictures/bake_scene.hh"
#include "pictures/compare_pictures.hh"
#include "system/system.hh"
#include "terminal/errors.hh"
#include "terminal/progress_bar.hh"
#include "terminal/table.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/progress.hh"

namespace whittle::app {
namespace {

struct BakeCommand {
  std::string detailed;
  std::string coarse;
  std::string output;
  std::optional<std::uint64_t> texture_size;
  bool makes_normal_map = true;
  FileOptions files;
  CommonOptions common;
};

struct BakeRun {
  Input detailed;
  Input coarse;
  std::optional<BakedScene> baked;
  double bake_seconds = 0;
  double write_seconds = 0;
  std::vector<std::string> warnings;
};

void check(const BakeCommand& options) {
  if (options.output != standard_stream && !options.output.ends_with(".glb")) {
    throw UsageError("--output: the result is glTF, in a file whose name ends with .glb, or '-' for standard output");
  }
  if (options.texture_size && !std::has_single_bit(*options.texture_size)) {
    throw UsageError("--texture-size: " + std::to_string(*options.texture_size) +
                     " is no power of two, such as 1024 or 2048");
  }
  const std::vector<std::string> inputs{options.detailed, options.coarse};
  check_formats(inputs, {}, options.files);
  std::vector<Output> outputs{{"--output", options.output}};
  if (options.common.json) outputs.push_back({"--json", *options.common.json});
  check_outputs(outputs, inputs, options.common.force);
}

BakeRun baked_files(const BakeCommand& options, const Talk& talk) {
  BakeRun run;
  run.detailed = read_input(options.detailed, options.files, options.common.threads, talk, io::AttributeScope::all);
  run.coarse = read_input(options.coarse, options.files, options.common.threads, talk, io::AttributeScope::all);
  const Stopwatch watch;
  ProgressBar bar(talk, "baking");
  run.baked = bake_scene(run.detailed, run.coarse,
                         {options.texture_size, options.makes_normal_map, options.common.threads, part_of(bar, 0, 1)});
  run.bake_seconds = watch.seconds();
  for (const std::vector<std::string>& warnings : {run.detailed.warnings, run.coarse.warnings, run.baked->warnings}) {
    run.warnings.insert(run.warnings.end(), warnings.begin(), warnings.end());
  }
  return run;
}

OptionRows setting_rows(BakeCommand& options) {
  OptionRows rows{{.names = "--texture-size",
                   .access = count(options.texture_size, least_texture_size, largest_texture_size),
                   .help = "texels along a side of the new texture, a power of two",
                   .standard = "by HIGH's texture, at most 4096",
                   .key = "texture_size"},
                  {.names = "--no-normal-map",
                   .access = flag(options.makes_normal_map, false),
                   .help = "make no map of HIGH's normals",
                   .key = "normal_map"}};
  append(rows, input_rows(options.files));
  return rows;
}

Json bake_json(BakeCommand& options, const BakeRun& run, double total_seconds) {
  const auto diagonal = [](const Input& input) { return diagonal_of(bounds_of(input.read.mesh)); };
  const BakedScene& baked = *run.baked;
  Json json = new_report();
  json["detailed"] = input_json(run.detailed, diagonal(run.detailed));
  json["coarse"] = input_json(run.coarse, diagonal(run.coarse));
  json["output"] = {{"path", options.output}, {"vertices", baked.n_vertices}, {"faces", baked.n_faces}};
  json["options"] = options_json(setting_rows(options));
  json["texture"] = {{"size", baked.texture_size},
                     {"charts", baked.n_charts},
                     {"normal_map", baked.has_normal_map},
                     {"missed_share", baked.missed_share}};
  json["seconds"] = {{"read", run.detailed.seconds + run.coarse.seconds},
                     {"bake", run.bake_seconds},
                     {"write", run.write_seconds},
                     {"total", total_seconds}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = run.warnings;
  return json;
}

ExitCode run_bake(const Given& /*given*/, BakeCommand options) {
  require_pictures();
  check(options);
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  BakeRun run = baked_files(options, talk);
  for (const std::string& warning : run.baked->warnings) talk.warning(warning);
  const Stopwatch writing;
  OutputFiles files(options.common.force);
  files.protect(run.detailed.needed_files);
  files.protect(run.coarse.needed_files);
  const std::string bytes = run.baked->asset.write_glb();
  files.write(options.output, [&bytes](std::ostream& out) { out << bytes; });
  run.write_seconds = writing.seconds();
  commit_with_report(files, options.common, [&] { return bake_json(options, run, watch.seconds()); });
  const std::string size = std::to_string(run.baked->texture_size);
  talk.say(shown_output(options.output) + ": " + faces_text(run.baked->n_faces) + ", " +
           vertices_text(run.baked->n_vertices) + ", " + counted(run.baked->n_charts, "chart", "charts") +
           " on a texture of " + size + " x " + size + " in " + seconds_text(watch.seconds()));
  say_effort(talk, watch.seconds());
  return ExitCode::done;
}

OptionRows bake_rows(BakeCommand& options) {
  OptionRows rows{
      file_argument("HIGH", options.detailed, "the detailed file, with a texture or with colours at vertices"),
      file_argument("LOW", options.coarse, "a simplified mesh of HIGH; its look doesn't count"),
      output_row(options.output, "a .glb file, replaced if it exists, or '-' for standard output")};
  append(rows, setting_rows(options));
  append(rows, common_rows(options.common));
  return rows;
}

}  // namespace

void setup_bake(CLI::App& app, Command& command) {
  const SubcommandText text{"bake", "Draw the colours of a mesh on a simplified one, with a new texture.",
                            "HIGH LOW -o OUT [OPTION]...",
                            "Examples:\n"
                            "  whittle simplify scan.glb -o low.ply --faces 5000 --attributes position-only\n"
                            "  whittle bake scan.glb low.ply -o small.glb\n"
                            "  whittle bake scan.ply low.ply -o small.glb --texture-size 2048"};
  BakeCommand defaults;
  defaults.files.reads_documents = true;
  defaults.files.scope = SceneScope::scene;
  add_subcommand(app, text, defaults, bake_rows, run_bake, command);
}

}  // namespace whittle::app
