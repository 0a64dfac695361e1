#include "commands/simplify/simplify_options.hh"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "commands/page/frames.hh"
#include "commands/page/make_page.hh"
#include "commands/regions/names.hh"
#include "files/gltf_file.hh"
#include "files/input.hh"
#include "files/mesh_output.hh"
#include "files/output.hh"
#include "options/attribute_weights.hh"
#include "options/efforts.hh"
#include "options/fits.hh"
#include "options/values.hh"
#include "terminal/errors.hh"

namespace whittle::app {
namespace {

constexpr auto costs = [] {
  std::array<Choice<Cost>, all_cost_traits.size()> choices{};
  for (std::size_t i = 0; i < choices.size(); ++i) choices[i] = {all_cost_traits[i].name, all_cost_traits[i].cost};
  return choices;
}();
constexpr std::array<Choice<Order>, 2> orders{{{"exact", Order::exact}, {"approximate", Order::approximate}}};
constexpr std::array<Choice<Weights>, 3> weights{
    {{"area", Weights::area}, {"uniform", Weights::uniform}, {"area-angle", Weights::area_angle}}};
constexpr std::array<Choice<Placement>, 3> placements{
    {{"optimal", Placement::optimal}, {"midpoint", Placement::midpoint}, {"endpoint", Placement::endpoint}}};
constexpr std::array<Choice<Seams>, 2> seams{{{"weighted", Seams::weighted}, {"keep", Seams::keep}}};
constexpr std::array<Choice<Boundary>, 3> boundaries{
    {{"weighted", Boundary::weighted}, {"locked", Boundary::locked}, {"free", Boundary::free}}};
constexpr std::array<Choice<Topology>, 2> topologies{{{"keep", Topology::keep}, {"free", Topology::free}}};
constexpr std::array<Choice<SelfIntersections>, 3> self_intersections{
    {{"allow", SelfIntersections::allow}, {"count", SelfIntersections::count}, {"refuse", SelfIntersections::refuse}}};
constexpr std::array<Choice<Normals>, 3> normals{
    {{"keep", Normals::keep}, {"recompute", Normals::recompute}, {"drop", Normals::drop}}};
constexpr std::array<Choice<bool>, 2> attribute_words{{{"keep", true}, {"position-only", false}}};
constexpr std::array<Choice<Engine>, 2> engines{{{"flat", Engine::flat}, {"openmesh", Engine::openmesh}}};

constexpr Range angle_range{0, 180, false};
constexpr Range ratio_range{0, 1};

constexpr char pair_group[] = "Pairs and parts";
constexpr char cost_group[] = "Cost";
constexpr char guard_group[] = "Borders, features and guards";
constexpr char file_group[] = "Files";

CLI::Option* add_number(CLI::App& app, const std::string& name, const std::string& value_name, double& target,
                        const Range& range, const std::string& description) {
  return add_value(
             app, name, value_name, target,
             [range, value_name](std::string_view text) { return parse_number(text, range, value_name); },
             description + ", " + to_string(range, value_name))
      ->default_str(shortest(target));
}

/// A default that depends on the cost, for the help: "75; 60 with memoryless".
template <class Text>
std::string defaults_by_cost(const Text& text) {
  const std::string usual = text(cost_traits(Cost::quadric));
  std::string others;
  for (const CostTraits& traits : all_cost_traits) {
    if (text(traits) == usual) continue;
    others += (others.empty() ? "; " : ", ") + text(traits) + " with " + std::string(traits.name);
  }
  return usual + others;
}

void add_pair_options(CLI::App& app, SimplifyCommand& options) {
  PairOptions& pairs = options.simplify.decimate.pairs;
  add_value(
      app, "-t,--threshold", "T|auto", options.threshold,
      [](std::string_view text) { return parse_automatic_length(text, "T"); },
      "also contract vertices closer than T that no edge joins: model units, a percentage of the diagonal such as "
      "1%, or 'auto' to choose T from the distances between parts")
      ->default_str("0")
      ->group(pair_group);
  add_value(
      app, "--max-pairs", "K", pairs.max_pairs,
      [](std::string_view text) {
        const std::uint64_t n = parse_count(text, 0, std::numeric_limits<std::uint32_t>::max());
        return n == 0 ? std::nullopt : std::optional(static_cast<std::uint32_t>(n));
      },
      "of the vertices closer than T only the K nearest of each, 0: all")
      ->default_str(std::to_string(*pairs.max_pairs))
      ->group(pair_group);
  app.add_flag("--across-walls", pairs.across_walls, "also contract vertices on both sides of a wall thinner than T")
      ->default_str("off")
      ->group(pair_group);
  add_choice<Topology>(
      app, "--topology", options.simplify.decimate.topology, topologies,
      "keep: contracting an edge closes no tunnel, opens no hole and lets no part vanish; free: it may")
      ->group(pair_group);
  add_value(
      app, "--prune", "S", options.prune, [](std::string_view text) { return parse_length(text, "S"); },
      "first drop the parts whose bounding box has a diagonal below S: model units, or a percentage of the whole "
      "mesh's")
      ->default_str("off")
      ->group(pair_group);
}

void add_attribute_weight(CLI::App& app, AttributeWeights& by_kind) {
  add_value(
      app, "--attribute-weight", "KIND=W", by_kind,
      [&by_kind](std::string_view text) { return parse_attribute_weights(text, by_kind); },
      "how much an error of an attribute counts beside the shape, of kinds uv, normal, color, morph and joints, and "
      "how firmly seams are held; several with commas between, 0: not at all, W >= 0")
      ->default_str(to_string(by_kind))
      ->group(cost_group);
}

void add_cost_options(CLI::App& app, SimplifyCommand& options) {
  DecimateOptions& decimate = options.simplify.decimate;
  QuadricOptions& quadric = decimate.quadric;
  add_choice<Effort>(app, "--effort", options.effort, efforts, effort_meaning)->group(cost_group);
  add_value(
      app, "--cost", words_of<Cost>(costs), decimate.cost,
      [](std::string_view text) { return parse_choice<Cost>(text, costs); },
      "what ranks and places: distance to the planes merged so far, or to those around as they are, change "
      "of volume, or the length of edges alone")
      ->default_str("by --effort; quadric with --engine openmesh, and with what only it has")
      ->group(cost_group);
  add_choice<Weights>(
      app, "--weights", quadric.weights, weights,
      "how much the plane of a face counts at its corners: its area, 1, or its area times the angle over pi")
      ->group(cost_group);
  add_choice<Placement>(app, "--placement", quadric.placement, placements,
                        "where the merged vertex goes: where the cost is least, halfway, or to the better end")
      ->group(cost_group);
  add_number(
      app, "--valence", "W", decimate.valence_weight, {0},
      "how much a contraction costs more that leaves vertices with fewer than 5 edges or more than 7 (on borders 3 "
      "and 5)")
      ->group(cost_group);
  add_number(app, "--isotropic", "W", decimate.isotropy, {0, 1}, "from error alone (0) to even edges alone (1)")
      ->group(cost_group);
  add_value(
      app, "--order", words_of<Order>(orders), decimate.order,
      [](std::string_view text) { return parse_choice<Order>(text, orders); },
      "exact: always the cheapest next; approximate: faster for costs other than plain quadrics")
      ->default_str(defaults_by_cost(
          [](const CostTraits& traits) { return std::string(word_of<Order>(orders, traits.default_order)); }))
      ->group(cost_group);
  add_attribute_weight(app, decimate.attribute_weights);
  add_value(
      app, "--polish", "N", options.simplify.polish_passes,
      [](std::string_view text) { return static_cast<unsigned>(parse_count(text, 0, 1000)); },
      "passes that fit the result to the mesh it came from, at each pause and in the end; one that doesn't help is "
      "taken back, and ends them (0: none)")
      ->default_str("by --effort; 0 with a --placement of its own")
      ->group(cost_group);
  add_choice<Fit>(app, "--fit", options.simplify.fit, fits, fit_meaning)->group(cost_group);
  add_choice<Engine>(app, "--engine", options.engine, engines,
                     "where the work is done; openmesh: the same cost as a module in OpenMesh's own decimater")
      ->group(cost_group);
}

void add_guard_options(CLI::App& app, SimplifyCommand& options) {
  DecimateOptions& decimate = options.simplify.decimate;
  add_choice<Boundary>(app, "--boundary", decimate.boundary, boundaries,
                       "open borders are held by a weight, don't move at all, or move freely")
      ->group(guard_group);
  add_number(app, "--boundary-weight", "W", decimate.quadric.boundary_weight, {0},
             "how firmly weighted borders are held, a factor on the squared length of a border edge")
      ->group(guard_group);
  add_value(
      app, "--feature-angle", "DEG", decimate.feature_angle_deg,
      [](std::string_view text) {
        const double degrees = parse_number(text, angle_range, "DEG");
        return degrees < 180 ? std::optional(degrees) : std::nullopt;
      },
      "edges sharper than DEG degrees are features: their lines stay, and no others get so sharp (180: none), " +
          to_string(angle_range, "DEG"))
      ->default_str("180")
      ->group(guard_group);
  add_value(
      app, "--feature-tolerance", "T", options.feature_tolerance,
      [](std::string_view text) { return parse_length(text, "T"); },
      "how far a feature line may come to lie from where it was: model units, or a percentage of the diagonal")
      ->default_str(to_string(options.feature_tolerance))
      ->group(guard_group);
  add_value(
      app, "--max-normal-flip", "DEG", decimate.max_normal_flip_deg,
      [](std::string_view text) { return parse_number(text, angle_range, "DEG"); },
      "refuse a contraction that turns a face further than DEG degrees (180: never), " + to_string(angle_range, "DEG"))
      ->default_str(
          defaults_by_cost([](const CostTraits& traits) { return shortest(traits.default_max_normal_flip_deg); }))
      ->group(guard_group);
  add_value(
      app, "--min-radius-ratio", "X", decimate.min_radius_ratio,
      [](std::string_view text) {
        const double ratio = parse_number(text, ratio_range, "X");
        return ratio > 0 ? std::optional(ratio) : std::nullopt;
      },
      "refuse a contraction that leaves a face with a smaller ratio of inner to outer circle, 1 for an equilateral "
      "one, unless it was thinner before (0: never), " +
          to_string(ratio_range, "X"))
      ->default_str("0")
      ->group(guard_group);
}

void add_self_intersections(CLI::App& app, SelfIntersections& target) {
  add_choice<SelfIntersections>(app, "--self-intersections", target, self_intersections,
                                "allow: warn if parts come to intersect, or walls to cross, that didn't; count: also "
                                "count all intersecting faces, before and after; refuse: also refuse contractions that "
                                "would make faces intersect")
      ->group(guard_group);
}

/// "length^4"
std::string unit_of(const CostTraits& traits) {
  return traits.dimension == 1 ? "length" : "length^" + shortest(traits.dimension);
}

/// "its unit is length^4 with quadric (…), length^5 with memoryless, …"
std::string unit_by_cost() {
  std::string text;
  for (const CostTraits& traits : all_cost_traits) {
    text += (text.empty() ? "its unit is " : ", ") + unit_of(traits) + " with " + std::string(traits.name);
    if (traits.cost == Cost::quadric) text += " (length^2 with uniform weights, in between with --isotropic)";
  }
  return text + ", in model units";
}

/// Null with OpenMesh's decimater, which has an order of its own.
nlohmann::ordered_json order_json(const SimplifyCommand& options) {
  if (options.engine == Engine::openmesh) return nullptr;
  return word_of<Order>(orders, options.simplify.decimate.effective_order());
}

bool has_threshold(const SimplifyCommand& options) {
  return options.threshold.is_automatic || options.threshold.length.value > 0;
}

void add_attribute_options(CLI::App& app, SimplifyCommand& options) {
  add_compress(app, options.compresses_gltf, file_group);
  add_choice<bool>(app, "--attributes", options.keeps_attributes, attribute_words,
                   "texture coordinates, colours, materials and all else but positions: keep them, with their seams, "
                   "or drop them")
      ->group(file_group);
  add_value(
      app, "--categories", "auto|none|NAME,...", options.categories,
      [](std::string_view text) { return parse_names(text); },
      "which numbers of vertices name things, as ids and classes do, and are never blended, by name; auto: those whose "
      "name or type says so, and reals that are all whole")
      ->default_str("auto")
      ->group(file_group);
  add_choice<Seams>(
      app, "--seams", options.simplify.decimate.seams, seams,
      "borders of charts, materials and regions are held by a weight, or stay where they are, with their corners")
      ->group(file_group);
  add_value(
      app, "--regions", "auto|none|NAME,...", options.simplify.decimate.regions,
      [](std::string_view text) { return parse_names(text); },
      "what of faces besides materials has borders that are seams: groups, objects, smoothing groups (g, o, s), face "
      "properties and face colours of PLY, by name; auto: those that name things")
      ->default_str("auto")
      ->group(file_group);
  add_choice<Normals>(app, "--normals", options.simplify.decimate.normals, normals,
                      "vertex normals: those of IN, those of the faces of the result, or none")
      ->group(file_group);
  add_value(
      app, "--crease-angle", "DEG", options.simplify.decimate.crease_angle_deg,
      [](std::string_view text) { return parse_number(text, angle_range, "DEG"); },
      "normals that are computed anew break at edges whose faces turn by DEG degrees or more (180: none), " +
          to_string(angle_range, "DEG"))
      ->default_str(shortest(options.simplify.decimate.crease_angle_deg))
      ->group(file_group);
}

void add_output(CLI::App& app, SimplifyCommand& options) {
  add_value(
      app, "-o,--output", "OUT", options.output, [](std::string_view text) { return std::string(text); },
      "the result: a file, replaced if it exists, or '-' for standard output; '{stem}' in it stands for the name of IN "
      "without folder and extension")
      ->required()
      ->group(file_group);
  app.add_flag("--join", options.joins, "make one mesh of all IN: each stays a part of its own")
      ->default_str("off")
      ->group(file_group);
}

}  // namespace

void add_simplify_options(CLI::App& app, SimplifyCommand& options) {
  options.files.reads_gltf = options.files.writes_gltf = true;
  add_mesh_files(app, options.inputs, options.files);
  add_target_options(app, options.targets, unit_by_cost());
  add_max_error(app, options.targets);
  app.add_flag("--per-mesh", options.is_per_mesh,
               "each mesh of a glTF file has these shares, or counts, on its own; otherwise they are for all together")
      ->default_str("off")
      ->group(target_group);
  app.add_flag("--strict", options.strict, "end with status 3 when the target was not met")
      ->default_str("off")
      ->group(target_group);
  app.add_flag("--certify", options.certify,
               "say how far OUT is from IN at most, all points, as it is with --max-error")
      ->default_str("off")
      ->group(target_group);
  add_output(app, options);
  add_file_options(app, options.files, file_group);
  const auto add_side_file = [&app](const std::string& option, std::optional<std::string>& path,
                                    const std::string& description) {
    add_value(
        app, option, "FILE", path, [](std::string_view text) { return std::string(text); },
        description + "; '{stem}' as in OUT")
        ->default_str("off")
        ->group(file_group);
  };
  add_side_file("--map", options.map,
                "write where each vertex of IN went: a line a vertex, its new number from 0, or -1");
  add_side_file("--map-back", options.map_back,
                "write which vertices of IN each vertex of OUT is made of: a line a vertex, their numbers from 0");
  add_side_file("--certificate", options.certificate,
                "write the steps of the proof how far OUT is from IN at most, for 'whittle verify'");
  add_side_file("--curve", options.curve,
                "write the error at the levels from IN to OUT, as a table (.csv) or a drawing (.svg)");
  add_side_file("--page", options.page,
                "write a page to look at the run in a browser: both meshes, the way between them, and what stood in "
                "the way of fewer faces");
  add_frame_options(app, options.pictures, file_group);
  add_side_file("--record", options.recording, "write the steps of the run, for 'whittle replay'");
  app.add_flag_callback(
         "--no-embed", [&options] { options.embeds_input = false; },
         "leave IN out of the recording: it is smaller, and 'replay' needs IN")
      ->default_str("off")
      ->group(file_group);
  app.add_flag("--zstd", options.compresses_recording, "compress the recording with zstd")
      ->default_str("off")
      ->group(file_group);
  add_attribute_options(app, options);
  add_pair_options(app, options);
  add_cost_options(app, options);
  add_guard_options(app, options);
  add_self_intersections(app, options.self_intersections);
  add_common_options(app, options.common);
}

SimplifyCommand settled(SimplifyCommand command) {
  command.files.reads_scene = !is_gltf_output(command.output, command.files) || !command.keeps_attributes;
  SimplifyOptions probe = command.simplify;
  command.has_cost_by_effort = !probe.decimate.cost && command.engine == Engine::flat;
  if (command.engine == Engine::openmesh) probe.decimate.cost = probe.decimate.cost.value_or(Cost::quadric);
  // The threshold depends on the mesh, which hasn't been read yet. The effort depends only on whether there is one.
  if (has_threshold(command)) probe.decimate.pairs.threshold = std::numeric_limits<double>::infinity();
  probe = with_effort(command.effort, std::move(probe));
  command.simplify.decimate.cost = probe.decimate.cost;
  command.simplify.polish_passes = probe.polish_passes;
  command.simplify.flips = probe.flips;
  command.simplify.tries_plain_quadrics = probe.tries_plain_quadrics;
  const TargetOptions& targets = command.targets;
  const bool has_count = targets.faces || targets.vertices || targets.ratio || targets.face_ratio;
  const bool pauses = command.engine == Engine::flat && has_count && !targets.max_error;
  command.simplify.pauses = pauses ? probe.pauses : std::vector<double>{};
  command.simplify.decimate.refuse_intersections = command.self_intersections == SelfIntersections::refuse;
  return command;
}

/// \throw UsageError for options that don't go with glTF, or with glTF alone
void check_gltf(const SimplifyCommand& options) {
  const bool is_written = is_gltf_output(options.output, options.files);
  if (options.compresses_gltf && !is_written) throw UsageError("--compress is for outputs in glTF");
  if (options.compresses_gltf && (options.targets.max_error || options.certify || options.certificate)) {
    throw UsageError("--compress rounds positions, so nothing can be proven of them: leave one out");
  }
  const auto is_read_as_gltf = [&](const std::string& path) { return reads_gltf(path, options.files); };
  const bool is_read = std::any_of(options.inputs.begin(), options.inputs.end(), is_read_as_gltf);
  if (options.is_per_mesh && !std::all_of(options.inputs.begin(), options.inputs.end(), is_read_as_gltf)) {
    throw UsageError("--per-mesh is for inputs in glTF, which may have several meshes");
  }
  if (is_read && options.joins) {
    throw UsageError("--join doesn't take glTF, which may have several meshes: 'whittle convert' makes OBJ of it");
  }
  if (is_written && (options.map || options.map_back)) {
    throw UsageError("--map and --map-back don't take glTF: its vertices are those of primitives");
  }
  if ((is_read || is_written) && options.certificate)
    throw UsageError("--certificate doesn't take glTF, as 'verify' doesn't read it");
  if (is_read && !options.files.reads_scene && (options.threshold.is_automatic || options.threshold.length.value > 0)) {
    throw UsageError("--threshold doesn't take glTF that stays glTF: a mesh may lie at several places");
  }
  if (is_read && options.engine == Engine::openmesh) throw UsageError("--engine openmesh doesn't take glTF");
}

void check_options(const CLI::App& app, const SimplifyCommand& options) {
  check_targets(options.targets, "--faces, --vertices, --ratio, --face-ratio, --max-cost and --max-error");
  check_conflicts(app, common_conflicts());
  check_conflicts(app, simplify_conflicts());
  if (options.page || options.pictures.is_given()) require_page();
  check_gltf(options);
  if (options.curve && !options.curve->ends_with(".csv") && !options.curve->ends_with(".svg")) {
    throw UsageError("--curve: '" + *options.curve + "' ends neither with .csv nor with .svg");
  }
  const DecimateOptions& decimate = options.simplify.decimate;
  const CostTraits& traits = cost_traits(decimate.effective_cost());
  const std::string_view why = traits.why_not.threshold_in_exact_order;
  if (has_threshold(options) && decimate.effective_order() == Order::exact && !why.empty()) {
    throw UsageError("'--threshold' and '--order exact' don't go together with '--cost " + std::string(traits.name) +
                     "': " + std::string(why));
  }
}

std::vector<std::string> idle_options(const CLI::App& app, const SimplifyCommand& options) {
  static const std::array<IdleOption, 11> all{{{"--every", options.pictures.animation ? "--animate" : "--frames", ""},
                                               {"--max-pairs", "--threshold", ""},
                                               {"--no-embed", "--record", ""},
                                               {"--zstd", "--record", ""},
                                               {"--max-error-borders", "--max-error", ""},
                                               {"--tolerance-map", "--max-error", ""},
                                               {"--across-walls", "--threshold", ""},
                                               {"--feature-tolerance", "--feature-angle", ""},
                                               {"--crease-angle", "--normals recompute", ""},
                                               {"--boundary free", "", "--cost lindstrom-turk"},
                                               {"--boundary free", "", "--cost midpoint"}}};
  std::vector<std::string> warnings = find_idle_options(app, all);
  if (is_given(app, "--fit") && options.simplify.polish_passes == 0U) {
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

nlohmann::ordered_json options_json(const SimplifyCommand& options) {
  const DecimateOptions& decimate = options.simplify.decimate;
  const QuadricOptions& quadric = decimate.quadric;
  return {
      {"weld", options.files.weld},
      {"weld_tolerance", to_string(options.files.weld_tolerance)},
      {"ascii", options.files.ascii},
      {"attributes", word_of<bool>(attribute_words, options.keeps_attributes)},
      {"categories", to_string(options.categories)},
      {"attribute_weights", to_string(decimate.attribute_weights)},
      {"seams", word_of<Seams>(seams, decimate.seams)},
      {"regions", to_string(decimate.regions)},
      {"normals", word_of<Normals>(normals, decimate.normals)},
      {"crease_angle_deg", decimate.crease_angle_deg},
      {"compress", options.compresses_gltf},
      {"join", options.joins},
      {"per_mesh", options.is_per_mesh},
      {"effort", word_of<Effort>(efforts, options.effort)},
      {"cost", to_string(decimate.effective_cost())},
      {"valence", decimate.valence_weight},
      {"isotropic", decimate.isotropy},
      {"order", order_json(options)},
      {"polish", *options.simplify.polish_passes},
      {"pauses", *options.simplify.pauses},
      {"fit", word_of<Fit>(fits, options.simplify.fit)},
      {"weights", word_of<Weights>(weights, quadric.weights)},
      {"placement", word_of<Placement>(placements, quadric.placement)},
      {"boundary", word_of<Boundary>(boundaries, decimate.boundary)},
      {"boundary_weight", quadric.boundary_weight},
      {"regularization", quadric.regularization},
      {"feature_angle_deg", decimate.feature_angle_deg.value_or(180)},
      {"feature_tolerance", to_string(options.feature_tolerance)},
      {"max_normal_flip_deg", decimate.effective_max_normal_flip_deg()},
      {"min_radius_ratio", decimate.min_radius_ratio.value_or(0)},
      {"threshold", to_string(options.threshold)},
      {"max_pairs", decimate.pairs.max_pairs.value_or(0)},
      {"across_walls", decimate.pairs.across_walls},
      {"point_weight", quadric.point_weight},
      {"topology", word_of<Topology>(topologies, decimate.topology)},
      {"self_intersections", word_of<SelfIntersections>(self_intersections, options.self_intersections)},
      {"prune", options.prune ? nlohmann::ordered_json(to_string(*options.prune)) : nlohmann::ordered_json(nullptr)},
      {"engine", word_of<Engine>(engines, options.engine)},
      {"strict", options.strict},
      {"certify", options.certify},
      {"threads", options.common.threads}};
}

}  // namespace whittle::app
