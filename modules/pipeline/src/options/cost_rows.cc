#include "options/cost_rows.hh"

#include <array>
#include <string>

#include "options/attribute_weights.hh"
#include "options/words.hh"

namespace whittle {
namespace {

constexpr char cost_group[] = "Cost";

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
constexpr std::array<Choice<Fit>, 3> fits{{{"mean", Fit::mean}, {"balanced", Fit::balanced}, {"max", Fit::max}}};

std::string_view word_of_order(Order order) { return word_of(std::span<const Choice<Order>>(orders), order); }

std::string order_by_cost() {
  return defaults_by_cost([](const CostTraits& traits) { return std::string(word_of_order(traits.default_order)); });
}

OptionRow cost_row(DecimateOptions& decimate) {
  return {
      .names = "--cost",
      .access = choice(decimate.cost, costs),
      .group = cost_group,
      .help =
          "error measure: quadrics with memory, quadrics of the faces as they are, change of volume, or edge length",
      .standard = "by --effort; quadric with --engine openmesh, and with what only it has",
      .key = "cost",
      .reported = [&decimate] { return OptionValue(std::string(to_string(decimate.effective_cost()))); }};
}

OptionRow weights_row(QuadricOptions& quadric) {
  OptionRow row{.names = "--weights",
                .access = choice(quadric.weights, weights),
                .group = cost_group,
                .help = "weight of a face's plane at its corners: its area, 1, or its area times the angle over pi",
                .key = "weights"};
  for (const char* word : {"uniform", "area-angle"}) append_costs_against(row, &CostConflicts::weights, word);
  return row;
}

OptionRow placement_row(QuadricOptions& quadric) {
  OptionRow row{.names = "--placement",
                .access = choice(quadric.placement, placements),
                .group = cost_group,
                .help = "where the merged vertex goes: where the cost is least, halfway, or to the better end",
                .key = "placement"};
  for (const char* word : {"midpoint", "endpoint"}) append_costs_against(row, &CostConflicts::placement, word);
  return row;
}

OptionRow valence_row(DecimateOptions& decimate) {
  OptionRow row{.names = "--valence",
                .access = number(decimate.valence_weight, {0}, "W"),
                .group = cost_group,
                .help = "penalty for vertices with fewer than 5 or more than 7 edges (on borders 3 and 5)",
                .key = "valence"};
  append_costs_against(row, &CostConflicts::valence_weight);
  return row;
}

OptionRow isotropic_row(DecimateOptions& decimate) {
  OptionRow row{.names = "--isotropic",
                .access = number(decimate.isotropy, {0, 1}, "W"),
                .group = cost_group,
                .help = "from error alone (0) to even edges alone (1)",
                .key = "isotropic"};
  append_costs_against(row, &CostConflicts::isotropy);
  return row;
}

OptionRow order_row(DecimateOptions& decimate) {
  return {.names = "--order",
          .access = choice(decimate.order, orders),
          .group = cost_group,
          .help = "exact: always the cheapest next; approximate: faster for costs other than plain quadrics",
          .standard = order_by_cost(),
          .key = "order",
          .reported = [&decimate] { return OptionValue(std::string(word_of_order(decimate.effective_order()))); }};
}

OptionRow polish_row(SimplifyOptions& simplify) {
  return {.names = "--polish",
          .access = count(simplify.polish_passes, 0, 1000),
          .group = cost_group,
          .help =
              "number of fitting passes, at each stop on the way and at the end; they stop when one no longer "
              "reduces the error (0: none)",
          .standard = "by --effort; 0 with a --placement of its own",
          .key = "polish"};
}

/// Rows without an option, for reports.
OptionRows reported_alone(Request& request) {
  QuadricOptions& quadric = request.simplify.decimate.quadric;
  const auto row = [](const char* key, std::function<OptionValue()> get) {
    return OptionRow{.names = "", .access = {"", {}, std::move(get)}, .key = key};
  };
  return {row("pauses", [&request] { return OptionValue(request.simplify.pauses.value_or(std::vector<double>{})); }),
          row("regularization", [&quadric] { return OptionValue(quadric.regularization); }),
          row("point_weight", [&quadric] { return OptionValue(quadric.point_weight); })};
}

}  // namespace

const char effort_meaning[] =
    "fast: '--cost quadric', on large meshes memoryless, no polish; normal: '--cost memoryless --polish 1', and "
    "polish once on the way; best: '--cost memoryless --polish 2', polish three times on the way, and edges are "
    "flipped where that helps";

OptionRow effort_row(Effort& effort) {
  return {.names = "--effort", .access = choice(effort, efforts), .help = effort_meaning, .key = "effort"};
}

OptionRow fit_row(Fit& fit) {
  return {.names = "--fit",
          .access = choice(fit, fits),
          .help =
              "what polish reduces. mean: the mean distance; balanced: that, without vertices that stick out far; max: "
              "the largest distance",
          .key = "fit"};
}

OptionRows cost_rows(Request& request) {
  DecimateOptions& decimate = request.simplify.decimate;
  OptionRow effort = effort_row(request.effort);
  OptionRow fit = fit_row(request.simplify.fit);
  effort.group = fit.group = cost_group;
  OptionRows rows{
      effort,
      cost_row(decimate),
      weights_row(decimate.quadric),
      placement_row(decimate.quadric),
      valence_row(decimate),
      isotropic_row(decimate),
      order_row(decimate),
      {.names = "--attribute-weight",
       .access = attribute_weights(decimate.attribute_weights),
       .group = cost_group,
       .help = "weights of attribute errors beside that of the shape, of kinds uv, normal, color, morph and joints, "
               "and how firmly seams are held; several with commas between, 0: not at all, W >= 0",
       .key = "attribute_weights"},
      polish_row(request.simplify),
      fit};
  append(rows, reported_alone(request));
  return rows;
}

void append_costs_against(OptionRow& row, std::string_view CostConflicts::*why, const std::string& value) {
  for (const CostTraits& traits : all_cost_traits) {
    const std::string_view reason = traits.why_not.*why;
    if (!reason.empty()) row.conflicts.push_back({value, "--cost " + std::string(traits.name), std::string(reason)});
  }
}

}  // namespace whittle
