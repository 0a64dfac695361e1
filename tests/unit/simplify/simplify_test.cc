#include "whittle/simplify/simplify.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <thread>

#include "support/shapes/shapes.hh"
#include "support/shapes/two_sided.hh"
#include "support/suites.hh"
#include "whittle/core/feature_edges.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/metrics/distance.hh"

namespace whittle::test {
namespace {

void expect_same(const IndexedMesh& a, const IndexedMesh& b, const std::string& context) {
  EXPECT_EQ(a.positions, b.positions) << context;
  EXPECT_EQ(a.faces, b.faces) << context;
}

TEST(Simplify, IsDecimationAndPolishByEffort) {
  for (const auto& [name, mesh] : all_meshes()) {
    const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 4);
    DecimateOptions options{.topology = whittle::Topology::automatic};
    expect_same(simplify(mesh, target, Effort::fast).mesh, decimate(mesh, target, options).mesh, name);
    options.cost = Cost::memoryless;
    for (const Effort effort : {Effort::normal, Effort::best}) {
      PolishOptions polish_options{.passes = effort == Effort::best ? 2U : 1U};
      options.pauses.at = effort == Effort::best ? std::vector<double>{1.2, 1.1, 1.03} : std::vector<double>{1.1};
      options.pauses.adjust = [&original = mesh, &polish_options](Decimation& paused) {
        polish(original, paused.vertex_map, paused.mesh, polish_options);
        return true;
      };
      Decimation expected = decimate(mesh, target, options);
      polish_options.flips = effort == Effort::best;
      const PolishResult polished = polish(mesh, expected.vertex_map, expected.mesh, polish_options);
      const Simplification s = simplify(mesh, target, effort, {.tries_plain_quadrics = false});
      expect_same(s.mesh, expected.mesh, name);
      EXPECT_EQ(s.vertex_map, expected.vertex_map) << name;
      EXPECT_EQ(s.polish.n_moved, polished.n_moved) << name;
    }
  }
}

TEST(Simplify, TakesPlainQuadricsWhereAnOptionNeedsThem) {
  const auto cost_of = [](const DecimateOptions& options) {
    return with_effort(Effort::normal, {.decimate = options}).decimate.cost;
  };
  DecimateOptions options;
  EXPECT_EQ(cost_of(options), Cost::memoryless);
  options.isotropy = 0.5;
  EXPECT_EQ(cost_of(options), Cost::quadric);
  options = {};
  options.quadric.weights = Weights::uniform;
  EXPECT_EQ(cost_of(options), Cost::quadric);
  options = {};
  options.pairs.threshold = 0.1;
  EXPECT_EQ(cost_of(options), Cost::memoryless);
  options.order = Order::exact;
  EXPECT_EQ(cost_of(options), Cost::quadric);
  options.cost = Cost::midpoint;
  EXPECT_EQ(cost_of(options), Cost::midpoint) << "said explicitly";
}

TEST(Simplify, IsFastByTheCostThatIsFastest) {
  const auto cost_of = [](const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options) {
    return with_effort(Effort::fast, {.decimate = options}, mesh, target).decimate.cost;
  };
  const IndexedMesh small = sphere(4);
  const IndexedMesh large = sphere(6);
  const DecimateTarget tenth = DecimateTarget::faces(large.faces.size() / 10);
  EXPECT_EQ(cost_of(large, tenth, {}), Cost::memoryless);
  EXPECT_EQ(cost_of(large, tenth, {.listener = [](const Contraction&) {}}), Cost::memoryless) << "told or not";
  EXPECT_EQ(cost_of(small, DecimateTarget::faces(1000), {}), Cost::quadric) << "small";
  EXPECT_EQ(cost_of(large, tenth.or_max_cost(1), {}), Cost::quadric) << "unit of costs";
  EXPECT_EQ(cost_of(large, tenth, {.order = Order::exact}), Cost::quadric);
  EXPECT_EQ(cost_of(large, tenth, {.isotropy = 0.5}), Cost::quadric);
  EXPECT_EQ(cost_of(large, tenth, {.cost = Cost::midpoint}), Cost::midpoint);
  EXPECT_EQ(cost_of(large, DecimateTarget::faces(large.faces.size() - 1000), {}), Cost::quadric) << "hardly anything";
  const Simplification s = simplify(large, tenth, Effort::fast);
  EXPECT_EQ(s.mesh.faces, decimate(large, tenth, {.cost = Cost::memoryless}).mesh.faces);
}

TEST(Simplify, SettlesTheCostOfTwoSidedSheetsWithoutTheirBacks) {
  const IndexedMesh front = sphere(6);
  const IndexedMesh both = with_backs(front);
  const DecimateTarget target = DecimateTarget::faces(both.faces.size() / 5);
  const SimplifyOptions settled = with_effort(Effort::fast, {}, both, target);
  EXPECT_EQ(settled.decimate.cost, with_effort(Effort::fast, {}, front, target).decimate.cost);
  const Simplification by_effort = simplify(both, target, Effort::fast);
  EXPECT_EQ(by_effort.cost, settled.decimate.cost);
  EXPECT_EQ(by_effort.mesh.faces, simplify(both, target, Effort::fast, settled).mesh.faces) << "settled before";
}

TEST(Simplify, LeavesOutWhatDoesNotGoWithTheTarget) {
  const IndexedMesh mesh = sphere(3);
  const SimplifyOptions asked{.flips = true, .pauses = std::vector<double>{1.5}};
  const auto settled = [&](const DecimateTarget& target) { return with_effort(Effort::best, asked, mesh, target); };
  const SimplifyOptions count = settled(DecimateTarget::faces(100));
  EXPECT_EQ(count.flips, true);
  EXPECT_EQ(count.pauses, asked.pauses);
  const SimplifyOptions limit = settled(DecimateTarget::faces(100).or_max_error(0.1));
  EXPECT_EQ(limit.flips, false);
  EXPECT_EQ(limit.pauses, std::vector<double>{});
  EXPECT_EQ(settled(DecimateTarget::as_far_as_possible()).pauses, std::vector<double>{}) << "multiples of no count";
}

TEST(SlowSimplify, TakesTheNearerOfTwoResultsWhereMuchIsFlat) {
  std::size_t n_plain = 0;
  for (const IndexedMesh& mesh : {bracket(24), bracket(40), tessellated_cube(16), open_cylinder(40, 12)}) {
    for (const double ratio : {0.2, 0.05}) {
      const auto target =
          DecimateTarget::faces(static_cast<std::uint64_t>(ratio * static_cast<double>(mesh.faces.size())));
      const auto mean = [&](const Simplification& s) {
        return metrics::surface_distance(mesh, s.mesh, {.samples = 20'000}).mean;
      };
      const Simplification s = simplify(mesh, target);
      const double memoryless = mean(simplify(mesh, target, Effort::normal, {.decimate = {.cost = Cost::memoryless}}));
      const double plain = mean(simplify(mesh, target, Effort::normal, {.decimate = {.cost = Cost::quadric}}));
      EXPECT_EQ(mean(s), s.cost == Cost::quadric ? plain : memoryless);
      const double noise = 1e-9 * diagonal_of(mesh.positions);
      EXPECT_LE(mean(s), 1.05 * std::min(memoryless, plain) + noise) << mesh.faces.size() << ' ' << ratio;
      n_plain += static_cast<std::size_t>(s.cost == Cost::quadric);
    }
  }
  EXPECT_GT(n_plain, 0U);
}

TEST(Simplify, TriesTwoCostsAtOnceWithOneResult) {
  const IndexedMesh mesh = bracket(16);
  const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 10);
  for (const Effort effort : {Effort::normal, Effort::best}) {
    SimplifyOptions options;
    options.decimate.threads = 1;
    const Simplification one = simplify(mesh, target, effort, options);
    for (const unsigned threads : {2U, 3U, 8U}) {
      options.decimate.threads = threads;
      const Simplification s = simplify(mesh, target, effort, options);
      expect_same(s.mesh, one.mesh, std::to_string(threads) + " threads");
      EXPECT_EQ(s.cost, one.cost);
      EXPECT_EQ(s.vertex_map, one.vertex_map);
      EXPECT_GE(s.decimate_seconds, 0);
      EXPECT_GE(s.polish_seconds, 0);
    }
  }
}

TEST(Simplify, TellsTheProgressOfOneOfTwoRunsAtOnce) {
  const IndexedMesh mesh = bracket(16);
  const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 10);
  const std::thread::id caller = std::this_thread::get_id();
  int n_calls = 0;
  int n_allowed = std::numeric_limits<int>::max();
  SimplifyOptions options;
  options.decimate.threads = 2;
  options.decimate.progress = [&](const Progress&) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    return ++n_calls <= n_allowed;
  };
  EXPECT_EQ(simplify(mesh, target, Effort::normal, options).result.stop, StopReason::target);
  const int n_all = n_calls;
  ASSERT_GT(n_all, 2);
  for (const int n : {0, 1, n_all / 2}) {
    n_calls = 0;
    n_allowed = n;
    const Simplification s = simplify(mesh, target, Effort::normal, options);
    EXPECT_TRUE(s.result.stop == StopReason::cancelled || s.polish.cancelled) << n;
    EXPECT_LT(n_calls, n_all) << n;
  }
  options.decimate.threads = 2;
  options.decimate.progress = {};
  options.decimate.locked.resize(1);  // of a wrong length
  EXPECT_THROW(simplify(mesh, target, Effort::normal, options), std::invalid_argument);
}

TEST(Simplify, TriesPlainQuadricsOnlyWhereNobodyListens) {
  SimplifyOptions options;
  EXPECT_EQ(with_effort(Effort::normal, options).tries_plain_quadrics, true);
  EXPECT_EQ(with_effort(Effort::fast, options).tries_plain_quadrics, false);
  options.decimate.listener = [](const Contraction&) {};
  EXPECT_EQ(with_effort(Effort::normal, options).tries_plain_quadrics, false);
  options.decimate.listener = {};
  options.decimate.cost = Cost::memoryless;
  EXPECT_EQ(with_effort(Effort::best, options).tries_plain_quadrics, false);
}

TEST(Simplify, LeavesVerticesWherePlacementPutThem) {
  SimplifyOptions options;
  options.decimate.quadric.placement = Placement::endpoint;
  EXPECT_EQ(with_effort(Effort::best, options).polish_passes, 0U);
  options.polish_passes = 2;
  EXPECT_EQ(with_effort(Effort::best, options).polish_passes, 2U);
  EXPECT_EQ(with_effort(Effort::best, options).pauses, std::vector<double>{});
  const IndexedMesh mesh = blob(4, 2);
  EXPECT_EQ(simplify(mesh, DecimateTarget::faces(400), Effort::best, options).mesh.faces.size(), 400U);
}

TEST(Simplify, KeepsLockedVerticesThroughPolish) {
  const IndexedMesh mesh = noisy_sphere(4, 0.05, 1);
  SimplifyOptions options;
  options.decimate.locked.resize(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); v += 50) options.decimate.locked[v] = 1;
  const Simplification s = simplify(mesh, DecimateTarget::faces(500), Effort::best, options);
  EXPECT_GT(s.polish.n_moved, 0U);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 50) {
    EXPECT_EQ(s.mesh.positions[s.vertex_map[v]], mesh.positions[v]) << v;
  }
}

TEST(Simplify, PolishesFeatureLinesThatTheCallerNames) {
  const IndexedMesh mesh = bracket(3);
  SimplifyOptions by_angle;
  by_angle.decimate.feature_angle_deg = 40;
  SimplifyOptions by_name;
  by_name.decimate.feature_edges = feature_edges(mesh, 40);
  const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 3);
  for (const SimplifyOptions& options : {by_angle, by_name}) {
    const Simplification s = simplify(mesh, target, Effort::normal, options);
    EXPECT_FALSE(s.feature_edges.empty());
    EXPECT_EQ(feature_edges(s.mesh, 40).size(), s.feature_edges.size());
  }
}

TEST(Simplify, TakesFeaturesThatAreNoEdgesAndRefusesThoseOfNoVertices) {
  const IndexedMesh mesh = bracket(3);
  SimplifyOptions options;
  options.decimate.feature_edges = feature_edges(mesh, 40);
  const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 3);
  const Simplification expected = simplify(mesh, target, Effort::normal, options);
  options.decimate.feature_edges.push_back({0, static_cast<Index>(mesh.positions.size() - 1)});
  EXPECT_EQ(simplify(mesh, target, Effort::normal, options).mesh.positions, expected.mesh.positions);
  options.decimate.feature_edges.push_back({3, 1'000'000});
  EXPECT_THROW(simplify(mesh, target, Effort::normal, options), std::invalid_argument);
}

TEST(Simplify, CanBeCancelledWhileContracting) {
  const IndexedMesh mesh = blob(4, 2);
  SimplifyOptions options;
  options.decimate.progress = [&](const Progress& p) { return p.n_faces == mesh.faces.size(); };
  const Simplification s = simplify(mesh, DecimateTarget::faces(10), Effort::normal, options);
  EXPECT_EQ(s.result.stop, StopReason::cancelled);
  EXPECT_LT(s.mesh.faces.size(), mesh.faces.size());
  EXPECT_EQ(s.polish.n_passes, 0U);
  options.decimate.progress = [](const Progress& p) { return p.stage == Stage::decimate; };
  const Simplification at_pause = simplify(mesh, DecimateTarget::faces(100), Effort::normal, options);
  EXPECT_EQ(at_pause.result.stop, StopReason::cancelled);
  EXPECT_EQ(at_pause.mesh.faces.size(), 110U);
  EXPECT_EQ(at_pause.polish.n_passes, 0U);
  options.pauses = std::vector<double>{};
  const Simplification unpolished = simplify(mesh, DecimateTarget::faces(100), Effort::normal, options);
  EXPECT_EQ(unpolished.result.stop, StopReason::target);
  EXPECT_EQ(unpolished.polish.n_passes, 0U);
  options.decimate.progress = [](const Progress&) { return false; };
  const Simplification nothing = simplify(mesh, DecimateTarget::faces(10), Effort::normal, options);
  EXPECT_EQ(nothing.result.stop, StopReason::cancelled);
  EXPECT_EQ(nothing.mesh.faces, mesh.faces);
  EXPECT_EQ(nothing.result.n_contractions, 0U);
}

TEST(SimplifyToLevels, GivesEachLevelItsCountAndPolishesIt) {
  const IndexedMesh mesh = test::knot(600, 120);  // in blocks to the first level
  std::vector<DecimateTarget> targets;
  for (const std::uint64_t n : {70'000U, 20'000U, 3'000U, 2'999U, 500U}) targets.push_back(DecimateTarget::faces(n));
  const std::vector<Simplification> levels = simplify_to_levels(mesh, targets);
  ASSERT_EQ(levels.size(), targets.size());
  EXPECT_EQ(levels.back().result.why_in_one_pass, "");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    EXPECT_LE(levels[i].mesh.faces.size(), targets[i].n_faces());
    EXPECT_GE(levels[i].mesh.faces.size() + 2, targets[i].n_faces());
    EXPECT_EQ(levels[i].result.n_faces, levels[i].mesh.faces.size());
    EXPECT_GT(levels[i].polish.n_moved, 0U) << i;
    if (i > 0) {
      EXPECT_GE(levels[i].result.max_cost, levels[i - 1].result.max_cost);
    }
  }
}

TEST(SlowSimplifyToLevels, IsAsAccurateAsARunToEachLevel) {
  const IndexedMesh mesh = test::blob(5, 3);
  std::vector<DecimateTarget> targets;
  for (const std::uint64_t n : {8000U, 2000U, 500U}) targets.push_back(DecimateTarget::faces(n));
  const std::vector<Simplification> levels = simplify_to_levels(mesh, targets);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double direct = metrics::surface_distance(mesh, simplify(mesh, targets[i]).mesh).mean;
    EXPECT_LE(metrics::surface_distance(mesh, levels[i].mesh).mean, 1.1 * direct) << i;
  }
}

TEST(SimplifyToLevels, TakesACountOfNothingAsFarAsPossible) {
  const auto faces_of = [](const IndexedMesh& mesh, const std::vector<std::uint64_t>& counts) {
    std::vector<DecimateTarget> targets;
    for (const std::uint64_t n : counts) targets.push_back(DecimateTarget::faces(n));
    std::vector<std::size_t> n_faces;
    for (const Simplification& level : simplify_to_levels(mesh, targets)) n_faces.push_back(level.mesh.faces.size());
    return n_faces;
  };
  using Counts = std::vector<std::size_t>;
  const IndexedMesh grid = test::grid(8, 8);
  EXPECT_EQ(faces_of(grid, {20, 0}), (Counts{20, 1}));
  EXPECT_EQ(faces_of(grid, {20, 1, 0}), (Counts{20, 1, 1}));
  EXPECT_EQ(faces_of(grid, {0}), Counts{1});
  EXPECT_EQ(faces_of(test::sphere(2), {20, 1, 0}), (Counts{20, 4})) << "nothing is left after the second level";
  const std::vector<Simplification> last =
      simplify_to_levels(grid, {DecimateTarget::faces(20), DecimateTarget::faces(0)});
  EXPECT_EQ(last.back().result.stop, StopReason::exhausted);
  const std::vector<Simplification> vertices =
      simplify_to_levels(grid, {DecimateTarget::vertices(20), DecimateTarget::vertices(0)});
  EXPECT_EQ(vertices.back().mesh.positions.size(), 3U);
}

TEST(SimplifyToLevels, RejectsWhatIsNoDescent) {
  const IndexedMesh mesh = test::sphere(3);
  const auto rejects = [&](const std::vector<DecimateTarget>& targets) {
    EXPECT_THROW(simplify_to_levels(mesh, targets), std::invalid_argument);
  };
  rejects({});
  rejects({DecimateTarget::faces(100), DecimateTarget::faces(100)});
  rejects({DecimateTarget::faces(100), DecimateTarget::faces(200)});
  rejects({DecimateTarget::faces(300), DecimateTarget::vertices(100)});
  rejects({DecimateTarget::faces(300).or_vertices(100)});
  rejects({DecimateTarget::faces(300).or_max_error(1)});
  rejects({DecimateTarget::faces(mesh.faces.size())});
}

}  // namespace
}  // namespace whittle::test
