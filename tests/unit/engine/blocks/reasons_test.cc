// Which runs go through blocks, and what is said of the others.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "decimate/run.hh"
#include "support/shapes/shapes.hh"
#include "unit/engine/blocks/small_blocks.hh"

namespace whittle::test {
namespace {

TEST(Blocks, SayWhyTheyAreNotTaken) {
  const IndexedMesh mesh = blob(3, 1);
  const DecimateTarget target = DecimateTarget::faces(200);
  const auto reason = [&](const auto& change, const DecimateTarget& to, const BlockPlan& plan = small_blocks) {
    DecimateOptions options = memoryless();
    change(options);
    const std::string_view why = run(mesh, to, options, nullptr, plan).result.why_in_one_pass;
    EXPECT_EQ(why, why_not_in_blocks(mesh, to, options, nullptr, plan, options.listener != nullptr));
    return std::string(why);
  };
  const auto nothing = [](DecimateOptions&) {};
  EXPECT_EQ(reason(nothing, target), "");
  EXPECT_EQ(reason(nothing, target, no_blocks), "the mesh is small");
  EXPECT_EQ(reason(nothing, DecimateTarget::max_cost(1e-9)), "there is no count to reach");
  EXPECT_EQ(reason(nothing, DecimateTarget::faces(200).or_max_cost(1)), "the cost is limited");
  EXPECT_EQ(reason(nothing, DecimateTarget::faces(mesh.faces.size() - 2)), "the target is near");
  EXPECT_EQ(reason([](DecimateOptions& o) { o.cost = Cost::lindstrom_turk; }, target),
            "the cost may fall, or is not of quadrics");
  const auto quadric = [&](const auto& change) {
    return reason(
        [&](DecimateOptions& o) {
          o.cost = Cost::quadric;
          o.threads = 2;
          change(o);
        },
        target);
  };
  EXPECT_EQ(quadric(nothing), "");
  EXPECT_EQ(quadric([](DecimateOptions& o) { o.threads = 1; }), "one thread works");
  EXPECT_EQ(quadric([](DecimateOptions& o) { o.quadric.regularization = 0; }), "rounding may decide the order");
  IndexedMesh far_flung = blob(3, 1);
  far_flung.positions[7] *= 1e6;
  EXPECT_EQ(why_not_in_blocks(far_flung, target, plain_quadrics(2), nullptr, small_blocks, false),
            "rounding may decide the order");
  EXPECT_EQ(quadric([](DecimateOptions& o) { o.isotropy = 0.5; }), "the cost has a term for edge lengths");
  EXPECT_EQ(quadric([](DecimateOptions& o) { o.listener = [](const Contraction&) {}; }),
            "contractions are told in exact order");
  BlockPlan in_detail = small_blocks;
  in_detail.fewest_faces_in_detail = mesh.faces.size() + 1;
  EXPECT_EQ(reason([](DecimateOptions& o) { o.listener = [](const Contraction&) {}; }, target), "");
  EXPECT_EQ(reason([](DecimateOptions& o) { o.listener = [](const Contraction&) {}; }, target, in_detail),
            "contractions are told in order");
  IndexedMesh colored = mesh;
  colored.colors.assign(mesh.positions.size(), Color{1, 1, 1, 1});
  EXPECT_EQ(why_not_in_blocks(colored, target, memoryless(), nullptr, small_blocks, false), "");
  EXPECT_EQ(why_not_in_blocks(colored, target, memoryless(), nullptr, in_detail, false), "");
  EXPECT_EQ(reason([](DecimateOptions& o) { o.order = Order::exact; }, target), "the order is exact");
  EXPECT_EQ(reason([](DecimateOptions& o) { o.pairs.threshold = 0.01; }, target),
            "threshold pairs join what lies apart");
  EXPECT_EQ(reason([](DecimateOptions& o) { o.topology = whittle::Topology::free; }, target),
            "the topology may change");
  EXPECT_EQ(reason([](DecimateOptions& o) { o.feature_angle_deg = 40; }, target), "feature lines are kept");
  EXPECT_EQ(reason([](DecimateOptions& o) { o.refuse_intersections = true; }, target), "intersections are refused");
}

TEST(Blocks, EndEarlierWherePartsMayVanish) {
  const IndexedMesh mesh = joined(blob(4, 1), boxes(5, 5));
  const DecimateTarget target = DecimateTarget::faces(100);
  DecimateOptions options = memoryless();
  EXPECT_GT(run(mesh, target, options, nullptr, small_blocks).result.n_faces, 100U);
  options.topology = whittle::Topology::automatic;
  const Decimation d = run(mesh, target, options, nullptr, small_blocks);
  EXPECT_EQ(d.result.why_in_one_pass, "");
  EXPECT_LE(d.result.n_faces, 100U);
  EXPECT_GT(d.result.n_vanished_components, 0U);
  options.threads = 3;
  const Decimation on_threads = run(mesh, target, options, nullptr, small_blocks);
  EXPECT_EQ(on_threads.mesh.positions, d.mesh.positions);
  EXPECT_EQ(on_threads.mesh.faces, d.mesh.faces);
  options = plain_quadrics(2);
  options.topology = whittle::Topology::automatic;
  EXPECT_EQ(run(mesh, target, options, nullptr, small_blocks).result.why_in_one_pass, "parts may vanish");
}

TEST(Blocks, TakeValencesAndPlacementsInRoundsAlone) {
  const IndexedMesh mesh = blob(3, 1);
  for (const auto& [weight, placement, why] : {std::tuple(1.0, Placement::optimal, "the cost has a term for valences"),
                                               std::tuple(0.0, Placement::endpoint, "vertices stay where they are"),
                                               std::tuple(0.0, Placement::midpoint, "vertices stay where they are"),
                                               std::tuple(0.0, Placement::optimal, "")}) {
    const auto reason = [&mesh, w = weight, p = placement](DecimateOptions options) {
      options.valence_weight = w;
      options.quadric.placement = p;
      return why_not_in_blocks(mesh, DecimateTarget::faces(200), options, nullptr, small_blocks, false);
    };
    EXPECT_EQ(reason(memoryless()), "");
    EXPECT_EQ(reason(plain_quadrics(2)), why);
  }
}

}  // namespace
}  // namespace whittle::test
