#include "simplify_options.hh"

#include <array>
#include <vector>

#include "errors.hh"
#include "input.hh"
#include "output.hh"
#include "values.hh"

namespace whittle::app {
namespace {

constexpr std::array<Choice<Cost>, 4> costs{{{"quadric", Cost::quadric},
                                             {"memoryless", Cost::memoryless},
                                             {"lindstrom-turk", Cost::lindstrom_turk},
                                             {"midpoint", Cost::midpoint}}};
constexpr std::array<Choice<Effort>, 3> efforts{
    {{"fast", Effort::fast}, {"normal", Effort::normal}, {"best", Effort::best}}};
constexpr std::array<Choice<Order>, 2> orders{{{"exact", Order::exact}, {"approximate", Order::approximate}}};
constexpr std::array<Choice<Weights>, 3> weights{
    {{"area", Weights::area}, {"uniform", Weights::uniform}, {"area-angle", Weights::area_angle}}};
constexpr std::array<Choice<Placement>, 3> placements{
    {{"optimal", Placement::optimal}, {"midpoint", Placement::midpoint}, {"endpoint", Placement::endpoint}}};
constexpr std::array<Choice<Boundary>, 3> boundaries{
    {{"weighted", Boundary::weighted}, {"locked", Boundary::locked}, {"free", Boundary::free}}};
constexpr std::array<Choice<Topology>, 2> topologies{{{"keep", Topology::keep}, {"free", Topology::free}}};
constexpr std::array<Choice<Engine>, 2> engines{{{"flat", Engine::flat}, {"openmesh", Engine::openmesh}}};

constexpr char no_pairs_why[] = "OpenMesh's decimater contracts edges alone";
constexpr char no_quadrics_why[] = "the cost has no quadrics";
constexpr char own_weights_why[] = "its planes change, and count by area";
constexpr char own_placement_why[] = "the cost has a placement of its own";
constexpr char edges_alone_why[] = "vertices that no edge joins go with plain quadrics alone";
constexpr char not_in_openmesh_why[] = "only Whittle's own loop does that";
constexpr std::array<Conflict, 28> conflicts{
    {{"--weights uniform", "--cost memoryless", own_weights_why},
     {"--weights area-angle", "--cost memoryless", own_weights_why},
     {"--isotropic", "--cost memoryless", "it blends quadrics that remember with the length of edges"},
     {"--weights uniform", "--cost lindstrom-turk", no_quadrics_why},
     {"--weights area-angle", "--cost lindstrom-turk", no_quadrics_why},
     {"--placement midpoint", "--cost lindstrom-turk", own_placement_why},
     {"--placement endpoint", "--cost lindstrom-turk", own_placement_why},
     {"--weights uniform", "--cost midpoint", no_quadrics_why},
     {"--weights area-angle", "--cost midpoint", no_quadrics_why},
     {"--placement midpoint", "--cost midpoint", own_placement_why},
     {"--placement endpoint", "--cost midpoint", own_placement_why},
     {"--boundary-weight", "--cost lindstrom-turk", "the cost has a term of its own for borders"},
     {"--boundary-weight", "--cost midpoint", no_quadrics_why},
     {"--isotropic", "--cost lindstrom-turk", "it blends quadrics with the length of edges"},
     {"--isotropic", "--cost midpoint", "it blends quadrics with the length of edges"},
     {"--threshold", "--cost lindstrom-turk", edges_alone_why},
     {"--threshold", "--cost midpoint", edges_alone_why},
     {"--threshold", "--isotropic", edges_alone_why},
     {"--threshold", "--valence", edges_alone_why},
     {"--boundary-weight", "--boundary free", "nothing holds borders that are free"},
     {"--feature-angle", "--engine openmesh", not_in_openmesh_why},
     {"--min-radius-ratio", "--engine openmesh", not_in_openmesh_why},
     {"--order approximate", "--engine openmesh", not_in_openmesh_why},
     {"--max-cost", "--engine openmesh", "OpenMesh looks at a cost when it is queued, not when its turn comes"},
     {"--threshold", "--engine openmesh", no_pairs_why},
     {"--max-pairs", "--engine openmesh", no_pairs_why},
     {"--across-walls", "--engine openmesh", no_pairs_why},
     {"--topology free", "--engine openmesh", "a half-edge mesh keeps its topology"}}};

constexpr Range flip_range{0, 180, false};

constexpr char pair_group[] = "Pairs and parts";
constexpr char cost_group[] = "Cost";
constexpr char guard_group[] = "Borders, features and guards";
constexpr char file_group[] = "Files";

template <class E, std::size_t N>
CLI::Option* add_choice(CLI::App& app, const std::string& name, E& target, const std::array<Choice<E>, N>& choices,
                        const std::string& description) {
  const std::span<const Choice<E>> all(choices);
  return add_value(
             app, name, words_of(all), target, [all](std::string_view text) { return parse_choice(text, all); },
             description)
      ->default_str(std::string(word_of(all, target)));
}

CLI::Option* add_number(CLI::App& app, const std::string& name, const std::string& value_name, double& target,
                        const Range& range, const std::string& description) {
  return add_value(
             app, name, value_name, target,
             [range, value_name](std::string_view text) { return parse_number(text, range, value_name); },
             description + ", " + to_string(range, value_name))
      ->default_str(shortest(target));
}

ThresholdOption parse_threshold(std::string_view text) {
  constexpr std::string_view automatic = "auto";
  if (text == automatic) return {true, {}};
  try {
    return {false, parse_length(text, "T")};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) + ", or 'auto'");
  }
}

void add_pair_options(CLI::App& app, SimplifyOptions& options) {
  PairOptions& pairs = options.decimate.pairs;
  add_value(
      app, "-t,--threshold", "T", options.threshold, parse_threshold,
      "also contract vertices closer than T that no edge joins: model units, a percentage of the diagonal such as "
      "1%, or 'auto' to choose T from the distances between parts")
      ->default_str("0")
      ->group(pair_group);
  add_value(
      app, "--max-pairs", "K", pairs.max_pairs,
      [](std::string_view text) {
        return static_cast<std::uint32_t>(parse_count(text, 0, std::numeric_limits<std::uint32_t>::max()));
      },
      "of the vertices closer than T only the K nearest of each, 0: all")
      ->default_str(std::to_string(pairs.max_pairs))
      ->group(pair_group);
  app.add_flag("--across-walls", pairs.across_walls, "also contract vertices on both sides of a wall thinner than T")
      ->default_str("off")
      ->group(pair_group);
  add_choice<Topology>(
      app, "--topology", options.decimate.topology, topologies,
      "keep: contracting an edge closes no tunnel, opens no hole and lets no part vanish; free: it may")
      ->group(pair_group);
  add_value(
      app, "--prune", "S", options.prune, [](std::string_view text) { return parse_length(text, "S"); },
      "first drop the parts whose bounding box has a diagonal below S: model units, or a percentage of the whole "
      "mesh's")
      ->default_str("off")
      ->group(pair_group);
}

void add_cost_options(CLI::App& app, SimplifyOptions& options) {
  DecimateOptions& decimate = options.decimate;
  QuadricOptions& quadric = decimate.quadric;
  add_choice<Effort>(
      app, "--effort", options.effort, efforts,
      "fast: '--cost quadric', no polish; normal: '--cost memoryless --polish 1'; best: '--cost memoryless "
      "--polish 3', and edges are flipped where that helps")
      ->group(cost_group);
  add_value(
      app, "--cost", words_of<Cost>(costs), options.cost,
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
      ->default_str("exact; approximate with memoryless")
      ->group(cost_group);
  add_value(
      app, "--polish", "N", options.polish_passes,
      [](std::string_view text) { return static_cast<unsigned>(parse_count(text, 0, 1000)); },
      "passes that fit the result to the mesh it came from; one that doesn't help is taken back, and ends them (0: "
      "none)")
      ->default_str("by --effort; 0 with a --placement of its own")
      ->group(cost_group);
  add_choice<Engine>(app, "--engine", options.engine, engines,
                     "where the work is done; openmesh: the same cost as a module in OpenMesh's own decimater")
      ->group(cost_group);
}

void add_guard_options(CLI::App& app, SimplifyOptions& options) {
  DecimateOptions& decimate = options.decimate;
  add_choice<Boundary>(app, "--boundary", decimate.boundary, boundaries,
                       "open borders are held by a weight, don't move at all, or move freely")
      ->group(guard_group);
  add_number(app, "--boundary-weight", "W", decimate.quadric.boundary_weight, {0},
             "how firmly weighted borders are held, a factor on the squared length of a border edge")
      ->group(guard_group);
  add_number(app, "--feature-angle", "DEG", decimate.feature_angle_deg, {0, 180, false},
             "edges sharper than DEG degrees are features: their lines stay, and no others get so sharp (180: none)")
      ->group(guard_group);
  add_value(
      app, "--feature-tolerance", "T", options.feature_tolerance,
      [](std::string_view text) { return parse_length(text, "T"); },
      "how far a feature line may come to lie from where it was: model units, or a percentage of the diagonal")
      ->default_str(to_string(options.feature_tolerance))
      ->group(guard_group);
  add_value(
      app, "--max-normal-flip", "DEG", options.max_normal_flip_deg,
      [](std::string_view text) { return parse_number(text, flip_range, "DEG"); },
      "refuse a contraction that turns a face further than DEG degrees (180: never), " + to_string(flip_range, "DEG"))
      ->default_str("75; 60 with memoryless, 110 with lindstrom-turk")
      ->group(guard_group);
  add_number(app, "--min-radius-ratio", "X", decimate.min_radius_ratio, {0, 1},
             "refuse a contraction that leaves a face with a smaller ratio of inner to outer circle, 1 for an "
             "equilateral one, unless it was thinner before (0: never)")
      ->group(guard_group);
}

bool has_threshold(const SimplifyOptions& options) {
  return options.threshold.is_automatic || options.threshold.length.value > 0;
}

/// Whether there is an option that memoryless quadrics don't have, or that they are poor with.
bool needs_plain_quadrics(const SimplifyOptions& options) {
  const DecimateOptions& decimate = options.decimate;
  return options.engine == Engine::openmesh || decimate.isotropy > 0 || decimate.quadric.weights != Weights::area ||
         (has_threshold(options) && decimate.order == Order::exact);
}

unsigned passes_of(const SimplifyOptions& options) {
  const bool has_own_places = options.decimate.quadric.placement != Placement::optimal;
  if (options.effort == Effort::fast || has_own_places) return 0;
  return options.effort == Effort::best ? 3 : 1;
}

}  // namespace

void add_simplify_options(CLI::App& app, SimplifyOptions& options) {
  add_mesh_file(app, options.input);
  add_target_options(app, options.targets);
  app.add_flag("--strict", options.strict, "end with status 3 when the target was not met")
      ->default_str("off")
      ->group(target_group);
  add_value(
      app, "-o,--output", "OUT", options.output, [](std::string_view text) { return std::string(text); },
      "the result: a file, replaced if it exists, or '-' for standard output")
      ->required()
      ->group(file_group);
  add_format(app, options.reading)->group(file_group);
  add_no_weld(app, options.reading)->group(file_group);
  add_value(
      app, "--map", "FILE", options.map, [](std::string_view text) { return std::string(text); },
      "write where each vertex of IN went: a line a vertex, its new number from 0, or -1")
      ->default_str("off")
      ->group(file_group);
  add_pair_options(app, options);
  add_cost_options(app, options);
  add_guard_options(app, options);
  add_common_options(app, options.common);
}

SimplifyOptions settled(SimplifyOptions options) {
  const bool is_plain = options.effort == Effort::fast || needs_plain_quadrics(options);
  options.decimate.cost = options.cost.value_or(is_plain ? Cost::quadric : Cost::memoryless);
  options.polish_passes = options.polish_passes.value_or(passes_of(options));
  return options;
}

void check(const CLI::App& app, const SimplifyOptions& options) {
  check_targets(options.targets);
  check_conflicts(app, common_conflicts());
  check_conflicts(app, conflicts);
  if (has_threshold(options) && options.decimate.cost == Cost::memoryless && options.decimate.order == Order::exact) {
    throw UsageError(
        "'--threshold' and '--order exact' don't go together with '--cost memoryless': vertices that no edge joins "
        "have no place in its exact order");
  }
  check_inputs({options.input}, {options.output}, options.reading.format);
  format_for_output(options.output, options.reading.format);
  std::vector<Output> outputs{{"--output", options.output}};
  if (options.map) outputs.push_back({"--map", *options.map});
  if (options.common.json) outputs.push_back({"--json", *options.common.json});
  check_outputs(outputs, {options.input}, options.common.force);
}

nlohmann::ordered_json options_json(const SimplifyOptions& options) {
  const QuadricOptions& quadric = options.decimate.quadric;
  return {
      {"weld", options.reading.weld},
      {"effort", word_of<Effort>(efforts, options.effort)},
      {"cost", word_of<Cost>(costs, options.decimate.cost)},
      {"valence", options.decimate.valence_weight},
      {"isotropic", options.decimate.isotropy},
      {"order", word_of<Order>(orders, options.order())},
      {"polish", *options.polish_passes},
      {"weights", word_of<Weights>(weights, quadric.weights)},
      {"placement", word_of<Placement>(placements, quadric.placement)},
      {"boundary", word_of<Boundary>(boundaries, options.decimate.boundary)},
      {"boundary_weight", quadric.boundary_weight},
      {"regularization", quadric.regularization},
      {"feature_angle_deg", options.decimate.feature_angle_deg},
      {"feature_tolerance", to_string(options.feature_tolerance)},
      {"max_normal_flip_deg", options.max_normal_flip()},
      {"min_radius_ratio", options.decimate.min_radius_ratio},
      {"threshold", options.threshold.is_automatic ? "auto" : to_string(options.threshold.length)},
      {"max_pairs", options.decimate.pairs.max_pairs},
      {"across_walls", options.decimate.pairs.across_walls},
      {"point_weight", quadric.point_weight},
      {"topology", word_of<Topology>(topologies, options.decimate.topology)},
      {"prune", options.prune ? nlohmann::ordered_json(to_string(*options.prune)) : nlohmann::ordered_json(nullptr)},
      {"engine", word_of<Engine>(engines, options.engine)},
      {"strict", options.strict},
      {"threads", options.common.threads}};
}

}  // namespace whittle::app
