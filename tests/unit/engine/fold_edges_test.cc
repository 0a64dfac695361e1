#include "cost/fold_edges.hh"

#include <gtest/gtest.h>

#include "blocks/contract_in_blocks.hh"
#include "support/meshes.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/metrics/distance.hh"

namespace whittle::test {
namespace {

std::vector<VertexPair> folds_of(const IndexedMesh& mesh) {
  return fold_edges(mesh, Frame::of_points(mesh.positions), 3);
}

TEST(FoldEdges, AreThoseAroundASheetWithTwoSides) {
  for (const double size : {1e-100, 1.0, 1e100}) {
    const IndexedMesh leaf = scaled(two_sided_leaf(6), size);
    const std::vector<VertexPair> folds = folds_of(leaf);
    EXPECT_EQ(folds.size(), 24U);
    EXPECT_TRUE(std::is_sorted(folds.begin(), folds.end()));
    for (const auto& [a, b] : folds) {
      EXPECT_LT(a, b);
      EXPECT_NEAR((leaf.positions[a] - leaf.positions[b]).head<2>().norm(), size, 1e-6 * size);
    }
  }
}

/// Not even where neighbours are oriented the other way round, as those of a Möbius strip.
TEST(FoldEdges, AreNotThereElsewhere) {
  for (const auto& [name, mesh] : all_meshes()) EXPECT_TRUE(folds_of(mesh).empty()) << name;
}

TEST(FoldEdges, HoldSheetsWithTwoSides) {
  const IndexedMesh leaf = two_sided_leaf(12);
  for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
    DecimateOptions options;
    options.cost = cost;
    const Decimation let_go = decimate(leaf, DecimateTarget::faces(80), options);
    options.hold_folds = true;
    const Decimation held = decimate(leaf, DecimateTarget::faces(80), options);
    const auto distance = [&](const Decimation& d) { return metrics::surface_distance(leaf, d.mesh, {}).max; };
    EXPECT_LT(distance(held), 0.3);
    EXPECT_GT(distance(let_go), 2 * distance(held));
  }
}

/// In exact order blocks would know nothing of folds.
TEST(FoldEdges, KeepMeshesOutOfBlocksInExactOrder) {
  BlockPlan plan;
  plan.fewest_faces_in_exact_order = 1;
  DecimateOptions options;
  options.cost = Cost::quadric;
  options.hold_folds = true;
  options.threads = 2;
  const auto why_not = [&](const IndexedMesh& mesh) {
    return why_not_in_blocks(mesh, DecimateTarget::faces(80), options, nullptr, plan, false);
  };
  EXPECT_EQ(why_not(two_sided_leaf(12)), "folds are held");
  EXPECT_EQ(why_not(sphere(3)), "");
  options.boundary = Boundary::free;
  EXPECT_EQ(why_not(two_sided_leaf(12)), "");
}

}  // namespace
}  // namespace whittle::test
