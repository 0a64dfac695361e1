#include "commands/simplify/simplify_options.hh"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include "commands/page/make_page.hh"
#include "files/input.hh"
#include "files/mesh_output.hh"
#include "files/output.hh"
#include "openmesh/openmesh_engine.hh"
#include "terminal/errors.hh"
#include "whittle/pipeline/json.hh"
#include "whittle/pipeline/plan.hh"

namespace whittle::app {
namespace {

constexpr std::array<Choice<Engine>, 2> engines{{{"flat", Engine::flat}, {"openmesh", Engine::openmesh}}};

constexpr char file_group[] = "Files";

const char* const files_of_a_run[] = {"--record", "--curve", "--page", "--live", "--frames", "--animate"};

/// \param others the rows of all other options
OptionRow engine_row(Engine& engine, const OptionRows& others) {
  OptionRow row{.names = "--engine",
                .access = choice(engine, engines),
                .group = "Cost",
                .help = "where the work is done; openmesh: the same cost as a module in OpenMesh's own decimater",
                .key = "engine"};
  const auto refuse = [&row](const std::string& other, const char* why) {
    row.conflicts.push_back({"openmesh", other, why});
  };
  for (const char* other : {"--order exact", "--order approximate"}) {
    refuse(other, "OpenMesh's decimater has an order of its own");
  }
  refuse("--max-cost", "OpenMesh looks at a cost when it is queued, not when its turn comes");
  for (const char* other : {"--threshold", "--max-pairs", "--across-walls"}) {
    refuse(other, "OpenMesh's decimater contracts edges alone");
  }
  refuse("--topology free", "a half-edge mesh keeps its topology");
  constexpr char own[] = "only Whittle's own loop does that";
  for (const OptionRow& other : others) {
    if (other.own_decimater) refuse(side_of(other, *other.own_decimater), own);
  }
  for (const char* other : files_of_a_run) refuse(other, own);
  return row;
}

/// Options for files besides the result.
OptionRows side_file_rows(SimplifyCommand& options) {
  const std::string stem = "; '{stem}' as in OUT";
  OptionRow certificate = side_file_row("--certificate", options.certificate,
                                        "write the proof of the largest distance, for 'whittle verify'" + stem);
  certificate.conflicts = {{"", "--join", "'verify' reads one IN"}, {"", "--prune", "the proof is about all of IN"}};
  OptionRows rows{
      side_file_row(
          "--map", options.map,
          "write, for each vertex of IN, the number of its vertex in OUT, from 0, or -1: a line a vertex" + stem),
      side_file_row("--map-back", options.map_back,
                    "write, for each vertex of OUT, the numbers of its vertices in IN, from 0: a line a vertex" + stem),
      certificate,
      side_file_row("--curve", options.curve,
                    "write the error at the levels from IN to OUT, as a table (.csv) or a drawing (.svg)" + stem),
      side_file_row("--page", options.page,
                    "write a page for a browser: both meshes, the steps between them, and the refused pairs" + stem),
      side_file_row("--live", options.live,
                    "write that page at once, and again while the run goes on: a browser shows how it goes" + stem)};
  append(rows, frame_rows(options.pictures));
  append(rows, {side_file_row("--record", options.recording, "write the steps of the run, for 'whittle replay'" + stem),
                {.names = "--no-embed",
                 .access = flag(options.embeds_input, false),
                 .help = "leave IN out of the recording: it is smaller, and 'replay' needs IN",
                 .conflicts = {{"", "--join", "'replay' reads one IN"},
                               {"", "--prune", "the recording is of IN without its small parts"}},
                 .idle = {{.without = {"--record"}}}},
                {.names = "--zstd",
                 .access = flag(options.compresses_recording),
                 .help = "compress the recording with zstd",
                 .idle = {{.without = {"--record"}}}}});
  return rows;
}

OptionRows output_rows(SimplifyCommand& options) {
  OptionRows rows{output_row(options.output,
                             "the result: a file, replaced if it exists, or '-' for standard output; '{stem}' in it "
                             "stands for the name of IN without folder and extension"),
                  {.names = "--join",
                   .access = flag(options.joins),
                   .help = "make one mesh of all IN: each stays a part of its own",
                   .key = "join"}};
  append(rows, file_rows(options.files));
  append(rows, side_file_rows(options));
  append(rows, gltf_rows(options.gltf));
  return in_group(std::move(rows), file_group);
}

}  // namespace

OptionRows simplify_rows(SimplifyCommand& options) {
  OptionRows rows = option_rows(options.request);
  const auto after_targets =
      std::find_if(rows.begin(), rows.end(), [](const OptionRow& row) { return row.group != target_group; });
  OptionRows own{{.names = "--strict",
                  .access = flag(options.strict),
                  .group = target_group,
                  .help = "end with status 3 when the target was not met",
                  .key = "strict"}};
  append(own, output_rows(options));
  rows.insert(after_targets, std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  rows.insert(rows.begin(),
              meshes_argument(options.inputs, options.files, "several if OUT has '{stem}', or with --join"));
  rows.push_back(engine_row(options.engine, rows));
  for (OptionRow& row : rows) {
    if (row.names != "--per-mesh") continue;
    for (const char* file : files_of_a_run) row.conflicts.push_back({"", file, "each mesh has a run of its own"});
  }
  append(rows, common_rows(options.common));
  return rows;
}

Request request_of(const SimplifyCommand& run) {
  Request request = run.request;
  request.makes_certificate = run.certificate.has_value();
  request.keeps_steps = run.recording || run.curve || run.page || run.live || run.pictures.is_given();
  // OpenMesh's engine takes one value of an attribute a vertex.
  const bool is_flat = run.engine == Engine::flat;
  request.reading =
      read_options(run.files, run.common.threads, is_flat ? io::AttributeScope::all : io::AttributeScope::per_vertex);
  if (!is_flat) {
    request.decimater = [](const Scene& scene, const DecimateTarget& target, const DecimateOptions& options) {
      return decimate_in_openmesh(scene.read.mesh, scene.name, target, options);
    };
  }
  return request;
}

/// \throw UsageError for options that don't go with a proof about a scene as it is shown
void check_proof_of_scene(const SimplifyCommand& options) {
  const std::string rounded = "the proof of what " + rounding_options(options.gltf) + " writes";
  const std::string proof = options.certificate ? "--certificate" : rounded;
  if (options.request.prune) throw UsageError("'--prune': " + proof + " is about all of IN");
  if (options.request.tolerance_map) {
    throw UsageError("'--tolerance-map': " + proof + " counts a vertex of glTF as often as the scene shows it");
  }
}

/// \throw UsageError for options that don't go with glTF, or with glTF alone
void check_gltf(const SimplifyCommand& options) {
  const bool is_written = writes_document(options.output, options.files);
  check_rounding(options.output, options.files, options.gltf);
  const auto is_read_as_gltf = [&](const std::string& path) { return reads_document(path, options.files); };
  const bool is_read = std::any_of(options.inputs.begin(), options.inputs.end(), is_read_as_gltf);
  if (options.request.is_per_mesh && !std::all_of(options.inputs.begin(), options.inputs.end(), is_read_as_gltf)) {
    throw UsageError("--per-mesh is for inputs in glTF, which may have several meshes");
  }
  if (is_read && options.joins) {
    throw UsageError("--join doesn't take glTF, which may have several meshes: 'whittle convert' makes OBJ of it");
  }
  if (is_written && (options.map || options.map_back)) {
    throw UsageError("--map and --map-back don't take glTF: its vertices are those of primitives");
  }
  Request request = request_of(options);
  request.output.gltf = options.gltf;
  if (is_read && options.files.scope != SceneScope::scene && request.proves_file()) check_proof_of_scene(options);
  if (is_read && options.files.scope != SceneScope::scene &&
      (options.request.threshold.is_automatic || options.request.threshold.length.value > 0)) {
    throw UsageError("--threshold doesn't take glTF that stays glTF: a mesh may lie at several places");
  }
  if (is_read && options.engine == Engine::openmesh) throw UsageError("--engine openmesh doesn't take glTF");
}

void check_options(const SimplifyCommand& options) {
  check_targets(options.request.targets, "--faces, --vertices, --ratio, --face-ratio, --max-cost and --max-error");
  if (options.page || options.live) require_page();
  if (options.live == standard_stream) throw UsageError("--live writes its page again and again, which takes a file");
  require_frames(options.pictures);
  check_gltf(options);
  if (options.curve && !options.curve->ends_with(".csv") && !options.curve->ends_with(".svg")) {
    throw UsageError("--curve: '" + *options.curve + "' ends neither with .csv nor with .svg");
  }
  const DecimateOptions decimate = options_by_effort(request_of(options)).decimate;
  const CostTraits& traits = cost_traits(decimate.effective_cost());
  const std::string_view why = traits.why_not.threshold_in_exact_order;
  if (options.request.has_threshold() && decimate.effective_order() == Order::exact && !why.empty()) {
    throw UsageError("'--threshold' and '--order exact' don't go together with '--cost " + std::string(traits.name) +
                     "': " + std::string(why));
  }
}

std::vector<std::string> idle_options(const Given& given, const SimplifyCommand& options) {
  std::vector<std::string> warnings = given.idle;
  if (given.is_given("--fit") && options_by_effort(request_of(options)).polish_passes == 0U) {
    warnings.emplace_back("'--fit' does nothing without polish");
  }
  return warnings;
}

void check_files(std::vector<SimplifyCommand> runs) {
  std::vector<std::string> inputs;
  std::vector<std::string> meshes;
  std::vector<Output> outputs;
  for (SimplifyCommand& run : runs) {
    if (run.joins) inputs = run.inputs;
    if (!run.joins) inputs.push_back(run.input);
    meshes.push_back(run.output);
    outputs.push_back({"--output", run.output});
    const std::vector<Output> frames = frame_outputs(std::exchange(run.pictures, {}));
    outputs.insert(outputs.end(), frames.begin(), frames.end());
    for (const SideFile& file : side_files(run)) {
      if (*file.path) outputs.push_back({file.option, **file.path});
    }
  }
  const SimplifyCommand& any = runs.front();
  if (any.common.json) outputs.push_back({"--json", *any.common.json});
  check_formats(inputs, meshes, any.files);
  check_outputs(outputs, inputs, any.common.force);
}

nlohmann::ordered_json simplify_options_json(SimplifyCommand options) {
  nlohmann::ordered_json json = options_json(simplify_rows(options));
  if (options.engine == Engine::openmesh) json["order"] = nullptr;  // OpenMesh's decimater has one of its own
  return json;
}

}  // namespace whittle::app
