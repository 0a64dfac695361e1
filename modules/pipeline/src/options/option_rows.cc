#include <array>
#include <limits>
#include <string>

#include "options/cost_rows.hh"
#include "options/words.hh"
#include "whittle/pipeline/request.hh"

namespace whittle {
namespace {

constexpr std::array<Choice<Seams>, 2> seams{{{"weighted", Seams::weighted}, {"keep", Seams::keep}}};
constexpr std::array<Choice<Boundary>, 3> boundaries{
    {{"weighted", Boundary::weighted}, {"locked", Boundary::locked}, {"free", Boundary::free}}};
constexpr std::array<Choice<Topology>, 3> topologies{
    {{"auto", Topology::automatic}, {"keep", Topology::keep}, {"free", Topology::free}}};
constexpr std::array<Choice<SelfIntersections>, 3> self_intersections{
    {{"allow", SelfIntersections::allow}, {"count", SelfIntersections::count}, {"refuse", SelfIntersections::refuse}}};
constexpr std::array<Choice<Normals>, 3> normals{
    {{"keep", Normals::keep}, {"recompute", Normals::recompute}, {"drop", Normals::drop}}};
constexpr std::array<Choice<bool>, 2> attribute_words{{{"keep", true}, {"position-only", false}}};

constexpr Range angles{0, 180, false};
constexpr Range ratios{0, 1};

constexpr char pair_group[] = "Pairs and parts";
constexpr char guard_group[] = "Borders, features and guards";
constexpr char attribute_group[] = "Attributes";

/// "its unit is length^4 with quadric (…), length^5 with memoryless, …"
std::string unit_by_cost() {
  std::string text;
  for (const CostTraits& traits : all_cost_traits) {
    const std::string unit = traits.dimension == 1 ? "length" : "length^" + shortest(traits.dimension);
    text += (text.empty() ? "its unit is " : ", ") + unit + " with " + std::string(traits.name);
    if (traits.cost == Cost::quadric) text += " (length^2 with uniform weights, in between with --isotropic)";
  }
  return text + ", in model units";
}

OptionRow threshold_row(Request& request) {
  OptionRow row{.names = "-t,--threshold",
                .access = automatic_length(request.threshold),
                .group = pair_group,
                .help =
                    "also contract vertices closer than T that no edge joins: model units, a percentage of the "
                    "diagonal such as 1%, or 'auto' to choose T from the distances between parts",
                .key = "threshold",
                .conflicts = {{"", "--isotropic", std::string(plain_quadrics_alone)},
                              {"", "--valence", std::string(plain_quadrics_alone)}}};
  append_costs_against(row, &CostConflicts::threshold);
  return row;
}

OptionRows pair_rows(Request& request) {
  PairOptions& pairs = request.simplify.decimate.pairs;
  const auto set_most = [&pairs](std::string_view text) {
    const std::uint64_t n = parse_count(text, 0, std::numeric_limits<std::uint32_t>::max());
    pairs.max_pairs = n == 0 ? std::nullopt : std::optional(static_cast<std::uint32_t>(n));
  };
  return {threshold_row(request),
          {.names = "--max-pairs",
           .access = {"K", set_most, [&pairs] { return OptionValue(std::uint64_t{pairs.max_pairs.value_or(0)}); }},
           .group = pair_group,
           .help = "largest number of threshold pairs of a vertex, the nearest; 0: all",
           .key = "max_pairs",
           .idle = {{.without = {"--threshold"}}}},
          {.names = "--across-walls",
           .access = flag(pairs.across_walls),
           .group = pair_group,
           .help = "also contract vertices on both sides of a wall thinner than T",
           .key = "across_walls",
           .idle = {{.without = {"--threshold"}}}},
          {.names = "--topology",
           .access = choice(request.simplify.decimate.topology, topologies),
           .group = pair_group,
           .help = "auto: on meshes of several parts, what costs less than to contract the rest may vanish: parts, "
                   "thin sheets, tunnels of open ones; keep: contracting an edge closes no tunnel, opens no hole and "
                   "lets no part vanish; free: it may",
           .key = "topology",
           .lift = {{Refusal::link, "free"}}},
          {.names = "--prune",
           .access = length(request.prune, "S"),
           .group = pair_group,
           .help = "first drop the parts whose bounding box has a diagonal below S: model units, or a percentage of "
                   "the whole mesh's",
           .key = "prune"}};
}

OptionRows boundary_rows(DecimateOptions& decimate) {
  OptionRow boundary{.names = "--boundary",
                     .access = choice(decimate.boundary, boundaries),
                     .group = guard_group,
                     .help = "open borders are held by a weight, don't move at all, or move freely",
                     .key = "boundary",
                     .lift = {{Refusal::locked, "weighted", "locked"}}};
  OptionRow weight{.names = "--boundary-weight",
                   .access = number(decimate.quadric.boundary_weight, {0}, "W"),
                   .group = guard_group,
                   .help = "how firmly weighted borders are held, a factor on the squared length of a border edge",
                   .key = "boundary_weight",
                   .conflicts = {{"", "--boundary free", std::string(free_borders_have_no_weight)}}};
  append_costs_against(weight, &CostConflicts::boundary_weight);
  for (const CostTraits& traits : all_cost_traits) {
    const std::string cost = "--cost " + std::string(traits.name);
    if (!traits.why_not.boundary_weight.empty()) boundary.idle.push_back({"free", {}, cost});
  }
  return {boundary, weight};
}

OptionRows guard_rows(Request& request) {
  DecimateOptions& decimate = request.simplify.decimate;
  OptionRows rows = boundary_rows(decimate);
  append(rows,
         {{.names = "--feature-angle",
           .access = number_or_off(decimate.feature_angle_deg, angles, "DEG", 180),
           .group = guard_group,
           .help = "edges sharper than DEG degrees are features: their lines stay, and no other edges get so sharp "
                   "(180: none), " +
                   to_string(angles, "DEG"),
           .key = "feature_angle_deg",
           .lift = {{Refusal::feature, "180"}},
           .own_decimater = ""},
          {.names = "--feature-tolerance",
           .access = length(request.feature_tolerance, "T"),
           .group = guard_group,
           .help = "how far a feature line may come to lie from where it was: model units, or a percentage of the "
                   "diagonal",
           .key = "feature_tolerance",
           .idle = {{.without = {"--feature-angle"}}},
           .own_decimater = ""},
          {.names = "--max-normal-flip",
           .access = number(decimate.max_normal_flip_deg, angles, "DEG"),
           .group = guard_group,
           .help = "refuse a contraction that turns a face further than DEG degrees (180: never), " +
                   to_string(angles, "DEG"),
           .standard = defaults_by_cost([](const CostTraits& t) { return shortest(t.default_max_normal_flip_deg); }),
           .key = "max_normal_flip_deg",
           .reported = [&decimate] { return OptionValue(decimate.effective_max_normal_flip_deg()); },
           .lift = {{Refusal::flip, "180"}}},
          {.names = "--min-radius-ratio",
           .access = number_or_off(decimate.min_radius_ratio, ratios, "X", 0),
           .group = guard_group,
           .help = "refuse a contraction that leaves a face with a smaller ratio of incircle to circumcircle (1: "
                   "equilateral), unless it was thinner before (0: never), " +
                   to_string(ratios, "X"),
           .key = "min_radius_ratio",
           .lift = {{Refusal::shape, "0"}},
           .own_decimater = ""},
          {.names = "--self-intersections",
           .access = choice(request.self_intersections, self_intersections),
           .group = guard_group,
           .help = "allow: warn if parts come to intersect, or walls to cross, that didn't; count: also count all "
                   "intersecting faces, before and after; refuse: also refuse contractions that would make faces "
                   "intersect",
           .key = "self_intersections",
           .lift = {{Refusal::intersection, "allow"}},
           .own_decimater = "refuse"}});
  return rows;
}

OptionRows attribute_rows(Request& request) {
  DecimateOptions& decimate = request.simplify.decimate;
  return {{.names = "--attributes",
           .access = choice(request.keeps_attributes, attribute_words),
           .group = attribute_group,
           .help = "keep: texture coordinates, colours, materials and all else, with their seams; position-only: drop "
                   "all but positions",
           .key = "attributes"},
          {.names = "--categories",
           .access = names(request.categories),
           .group = attribute_group,
           .help = "vertex numbers that are labels (ids, classes) and are never blended, by name; auto: by name and "
                   "type, and reals that are all whole",
           .key = "categories"},
          {.names = "--seams",
           .access = choice(decimate.seams, seams),
           .group = attribute_group,
           .help = "weighted: a weight holds the borders of charts, materials and regions; keep: they stay where they "
                   "are, with their corners",
           .key = "seams",
           .lift = {{Refusal::feature, "weighted"}}},
          {.names = "--regions",
           .access = names(decimate.regions),
           .group = attribute_group,
           .help = "face labels whose borders are seams, besides materials: g, o, s, PLY properties and face colours, "
                   "by name; auto: those that name things",
           .key = "regions"},
          {.names = "--normals",
           .access = choice(decimate.normals, normals),
           .group = attribute_group,
           .help = "vertex normals. keep: fit to those of IN; recompute: from the faces of the result; drop: none",
           .key = "normals"},
          {.names = "--crease-angle",
           .access = number(decimate.crease_angle_deg, angles, "DEG"),
           .group = attribute_group,
           .help = "recomputed normals break at edges whose faces turn by DEG degrees or more (180: none), " +
                   to_string(angles, "DEG"),
           .key = "crease_angle_deg",
           .idle = {{.without = {"--normals recompute"}}}}};
}

}  // namespace

OptionRows option_rows(Request& request) {
  OptionRows rows = target_rows(request.targets, unit_by_cost());
  append(rows, error_rows(request.targets));
  append(rows, {{.names = "--per-mesh",
                 .access = flag(request.is_per_mesh),
                 .group = target_group,
                 .help = "apply the targets to each mesh of a glTF file, not to all together",
                 .key = "per_mesh",
                 .conflicts = {{"", "--max-error", "the error is that of each mesh in any case"},
                               {"", "--attributes position-only", "nothing would say which mesh a face is of"}}},
                {.names = "--certify",
                 .access = flag(request.certify),
                 .group = target_group,
                 .help = "prove and print the largest distance between IN and OUT, as --max-error does",
                 .key = "certify"},
                {.names = "--tolerance-map",
                 .access = text(request.tolerance_map, "FILE"),
                 .group = target_group,
                 .help = "a file with a tolerance for each vertex of IN, one a line, smaller than --max-error, model "
                         "units",
                 .conflicts = {{"", "--prune", "the lengths are of all vertices of IN"}},
                 .idle = {{.without = {"--max-error"}}}}});
  append(rows, attribute_rows(request));
  append(rows, pair_rows(request));
  append(rows, cost_rows(request));
  append(rows, guard_rows(request));
  return rows;
}

}  // namespace whittle
