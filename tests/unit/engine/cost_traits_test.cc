#include "whittle/engine/cost_traits.hh"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "support/shapes/shapes.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::test {
namespace {

std::string message_of(const DecimateOptions& options) {
  try {
    decimate(blob(2, 1), DecimateTarget::faces(50), options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

/// An option that a cost may refuse, and the reason.
struct Option {
  std::string name;
  std::string_view CostConflicts::*why;
  void (*set)(DecimateOptions&);
};

const std::vector<Option> all_options{
    {"weights", &CostConflicts::weights, [](DecimateOptions& o) { o.quadric.weights = Weights::uniform; }},
    {"placement", &CostConflicts::placement, [](DecimateOptions& o) { o.quadric.placement = Placement::endpoint; }},
    {"boundary_weight", &CostConflicts::boundary_weight, [](DecimateOptions& o) { o.quadric.boundary_weight = 3; }},
    {"regularization", &CostConflicts::regularization, [](DecimateOptions& o) { o.quadric.regularization = 1e-6; }},
    {"isotropy", &CostConflicts::isotropy, [](DecimateOptions& o) { o.isotropy = 0.5; }},
    {"valence_weight", &CostConflicts::valence_weight, [](DecimateOptions& o) { o.valence_weight = 1; }},
    {"pairs.threshold", &CostConflicts::threshold, [](DecimateOptions& o) { o.pairs.threshold = 0.01; }}};

TEST(CostTraits, HasARowForEachCostInItsOrder) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < all_cost_traits.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(all_cost_traits[i].cost), i);
    EXPECT_NE(all_cost_traits[i].default_order, Order::automatic);
    EXPECT_TRUE(names.insert(all_cost_traits[i].name).second) << all_cost_traits[i].name;
  }
}

TEST(CostTraits, SaysWhichOptionsDecimateRefuses) {
  for (const CostTraits& traits : all_cost_traits) {
    for (const Option& option : all_options) {
      SCOPED_TRACE(std::string(traits.name) + ", " + option.name);
      DecimateOptions options;
      options.cost = traits.cost;
      option.set(options);
      const std::string why(traits.why_not.*option.why);
      const std::string expected =
          "decimate: " + option.name + " doesn't go with the cost " + std::string(traits.name) + ": " + why;
      EXPECT_EQ(message_of(options), why.empty() ? "" : expected);
    }
  }
}

TEST(CostTraits, SaysWhetherThresholdPairsGoWithExactOrder) {
  for (const CostTraits& traits : all_cost_traits) {
    if (!traits.why_not.threshold.empty()) continue;
    DecimateOptions options;
    options.cost = traits.cost;
    options.order = Order::exact;
    options.pairs.threshold = 0.01;
    EXPECT_EQ(message_of(options).empty(), traits.why_not.threshold_in_exact_order.empty()) << traits.name;
  }
}

TEST(CostTraits, GivesTheDefaultsThatDependOnTheCost) {
  const IndexedMesh mesh = blob(3, 2);
  for (const CostTraits& traits : all_cost_traits) {
    DecimateOptions by_cost;
    by_cost.cost = traits.cost;
    DecimateOptions explicitly = by_cost;
    explicitly.order = traits.default_order;
    explicitly.max_normal_flip_deg = traits.default_max_normal_flip_deg;
    const DecimateTarget target = DecimateTarget::faces(100);
    EXPECT_EQ(decimate(mesh, target, by_cost).mesh.positions, decimate(mesh, target, explicitly).mesh.positions)
        << traits.name;
  }
}

TEST(CostTraits, AreWhatTheDocumentationSays) {
  std::ifstream file(WHITTLE_DOCS_DIR "/user/simplify.md");
  std::stringstream page;
  page << file.rdbuf();
  for (const CostTraits& traits : all_cost_traits) {
    std::string refused;
    const auto add = [&](std::string_view why, const char* option) {
      if (!why.empty()) refused += std::string(refused.empty() ? "" : ", ") + '`' + option + '`';
    };
    add(traits.why_not.weights, "--weights");
    add(traits.why_not.placement, "--placement");
    add(traits.why_not.boundary_weight, "--boundary-weight");
    add(traits.why_not.isotropy, "--isotropic");
    add(traits.why_not.valence_weight, "--valence");
    add(traits.why_not.threshold, "--threshold");
    add(traits.why_not.threshold_in_exact_order, "--threshold --order exact");
    std::ostringstream row;
    row << "| `" << traits.name << "` | length^" << traits.dimension << " | "
        << (traits.default_order == Order::exact ? "exact" : "approximate") << " | "
        << traits.default_max_normal_flip_deg << " | " << (refused.empty() ? "nothing" : refused) << " |\n";
    EXPECT_NE(page.str().find(row.str()), std::string::npos) << "docs/user/simplify.md should have the row\n"
                                                             << row.str();
  }
}

}  // namespace
}  // namespace whittle::test
