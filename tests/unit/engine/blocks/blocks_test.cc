// Decimation in blocks: the promises of decimate where small meshes are cut into many blocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>

#include "decimate/run.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "unit/engine/blocks/larger_meshes.hh"
#include "unit/engine/blocks/small_blocks.hh"
#include "whittle/core/wedges.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/shape.hh"

namespace whittle::test {
namespace {

Decimation in_blocks(const IndexedMesh& mesh, std::uint64_t n_faces, const DecimateOptions& options) {
  const DecimateTarget target = DecimateTarget::faces(n_faces);
  EXPECT_EQ(why_not_in_blocks(mesh, target, options, nullptr, small_blocks, false), "");
  return run(mesh, target, options, nullptr, small_blocks);
}

void expect_equal(const Decimation& a, const Decimation& b) {
  EXPECT_EQ(a.mesh.positions, b.mesh.positions);
  EXPECT_EQ(a.mesh.faces, b.mesh.faces);
  EXPECT_EQ(a.mesh.origins, b.mesh.origins);
  EXPECT_EQ(a.vertex_map, b.vertex_map);
  EXPECT_EQ(a.face_origins, b.face_origins);
  EXPECT_EQ(a.result.max_cost, b.result.max_cost);
  EXPECT_EQ(a.result.n_contractions, b.result.n_contractions);
  EXPECT_EQ(a.result.refusals[Refusal::flip], b.result.refusals[Refusal::flip]);
  EXPECT_EQ(a.result.refusals[Refusal::link], b.result.refusals[Refusal::link]);
}

// The promises of decimate -------------------------------------------------------------------------------------------

TEST(Blocks, TakeMeshesWithoutArea) {
  IndexedMesh mesh = grid(30, 30);
  for (Vec3& p : mesh.positions) p.y() = 0;
  const Decimation d = in_blocks(mesh, 100, memoryless());
  EXPECT_EQ(d.mesh.faces.size(), d.result.n_faces);
  EXPECT_EQ(topology(d.mesh).components, 1);
}

TEST(Blocks, KeepTopologyAndReachTheTarget) {
  for (const auto& [name, mesh] : larger_meshes()) {
    for (const std::size_t divisor : {2U, 10U, 50U}) {
      SCOPED_TRACE(name + " / " + std::to_string(divisor));
      const std::uint64_t n_faces = mesh.faces.size() / divisor;
      const Decimation d = in_blocks(mesh, n_faces, memoryless());
      const Decimation global = run(mesh, DecimateTarget::faces(n_faces), memoryless(), nullptr, no_blocks);
      EXPECT_EQ(d.mesh.faces.size(), d.result.n_faces);
      if (d.result.stop == StopReason::target) {
        EXPECT_LE(d.mesh.faces.size(), n_faces);
        EXPECT_GE(d.mesh.faces.size() + 6, n_faces);
      } else {
        EXPECT_EQ(d.result.stop, StopReason::exhausted);
        EXPECT_NE(global.result.stop, StopReason::target) << "what blocks miss, a pass over all misses, too";
      }
      EXPECT_EQ(d.result.before.components, global.result.before.components);
      EXPECT_EQ(d.result.before.nonmanifold_edges, global.result.before.nonmanifold_edges);
      EXPECT_EQ(d.result.before.nonmanifold_vertices, global.result.before.nonmanifold_vertices);
      EXPECT_EQ(d.result.n_degenerate_faces, global.result.n_degenerate_faces);
      const Topology before = topology(mesh);
      const Topology after = topology(d.mesh);
      EXPECT_EQ(after.degenerate_faces, 0);
      if (!before.manifold()) continue;
      EXPECT_TRUE(after.manifold());
      EXPECT_EQ(after.components, before.components);
      EXPECT_EQ(after.euler(), before.euler());
      EXPECT_EQ(after.border_loops, before.border_loops);
      EXPECT_LE(after.misoriented_edges, before.misoriented_edges);
    }
  }
}

TEST(Blocks, DoNotPassTheTarget) {
  for (const auto& [name, mesh] : {NamedMesh{"grid(60, 60)", grid(60, 60)}, NamedMesh{"terrain(60)", terrain(60, 1)},
                                   NamedMesh{"tessellated_cube(16)", tessellated_cube(16)},
                                   NamedMesh{"isolated", with_isolated_vertices(grid(60, 60), 500, 1)}}) {
    for (const std::size_t divisor : {3U, 10U, 40U}) {
      SCOPED_TRACE(name + " / " + std::to_string(divisor));
      const std::uint64_t n_faces = mesh.faces.size() / divisor;
      const Decimation by_faces = in_blocks(mesh, n_faces, memoryless());
      EXPECT_GE(by_faces.mesh.faces.size() + 1, n_faces);
      const std::uint64_t n_vertices = mesh.positions.size() / divisor;
      const Decimation by_vertices =
          run(mesh, DecimateTarget::vertices(n_vertices), memoryless(), nullptr, small_blocks);
      EXPECT_EQ(by_vertices.mesh.positions.size(), n_vertices);
    }
  }
}

TEST(Blocks, MapVerticesAndFaces) {
  for (const auto& [name, mesh] : larger_meshes()) {
    SCOPED_TRACE(name);
    const Decimation d = in_blocks(mesh, mesh.faces.size() / 4, memoryless());
    ASSERT_EQ(d.vertex_map.size(), mesh.positions.size());
    ASSERT_EQ(d.face_origins.size(), d.mesh.faces.size());
    EXPECT_TRUE(std::is_sorted(d.face_origins.begin(), d.face_origins.end()));
    EXPECT_TRUE(std::is_sorted(d.mesh.origins.begin(), d.mesh.origins.end()));
    for (std::size_t f = 0; f < d.mesh.faces.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(d.vertex_map[mesh.faces[d.face_origins[f]][i]], d.mesh.faces[f][i]);
      }
    }
    for (std::size_t v = 0; v < d.mesh.origins.size(); ++v) EXPECT_EQ(d.vertex_map[d.mesh.origins[v]], v);
    for (const Triangle& face : mesh.faces) {
      for (const Index v : face) EXPECT_NE(d.vertex_map[v], invalid_index);
    }
  }
}

TEST(Blocks, TakeMeshesWithSeams) {
  IndexedMesh cube = charted_cube(16);
  join_equal_wedges(cube);
  for (const IndexedMesh& mesh : {tiled_torus(60, 30, 3), cube}) {
    const Decimation one = in_blocks(mesh, mesh.faces.size() / 8, memoryless(1));
    const Decimation three = in_blocks(mesh, mesh.faces.size() / 8, memoryless(3));
    EXPECT_EQ(one.result.stop, StopReason::target);
    EXPECT_TRUE(topology(one.mesh).manifold() && topology(one.mesh).closed());
    EXPECT_EQ(topology(one.mesh).genus(), topology(mesh).genus());
    EXPECT_FALSE(one.mesh.wedges.empty());
    EXPECT_EQ(one.mesh.positions, three.mesh.positions);
    EXPECT_EQ(one.mesh.faces, three.mesh.faces);
    EXPECT_EQ(one.mesh.wedges, three.mesh.wedges);
  }
}

TEST(Blocks, CarryAttributesOn) {
  for (IndexedMesh mesh : {tiled_torus(60, 30, 3), textured_torus(60, 30)}) {
    mesh.normals.clear();
    const DecimateOptions options = memoryless(2);
    const Frame frame = Frame::of_points(mesh.positions);
    WorkingSurface surface;
    surface.positions = MaybeOwned<Vec3>::borrowed(mesh.positions);
    surface.faces = MaybeOwned<Triangle>::borrowed(mesh.faces);
    surface.frame = frame;
    surface.input_attributes =
        std::make_shared<InputAttributes>(mesh, frame, scaled_attributes(mesh, frame, options.attribute_weights, 2));
    const auto weight_of = [](const SurfaceAttributes& attributes) {
      double sum = 0;
      for (Index w = 0; w < attributes.vertex_of.size(); ++w) sum += attributes.wedges.weight(w);
      return sum;
    };
    const double before = weight_of(surface.input_attributes->all(2));
    const StageReport report = contract_in_blocks(surface, mesh, DecimateTarget::faces(mesh.faces.size() / 8),
                                                  small_blocks, StageContext{options, frame});
    ASSERT_EQ(report.result.why_in_one_pass, "");
    EXPECT_LE(surface.faces.size(), mesh.faces.size() / 4);
    EXPECT_NEAR(weight_of(surface.cost_state.attributes), before,
                1e-5 * before);  // each wedge has all faces of those merged into it
    const std::vector<Index>& vertex_of = surface.cost_state.attributes.vertex_of;
    EXPECT_TRUE(std::is_sorted(vertex_of.begin(), vertex_of.end()));
    for (Index v = 0; v < surface.positions.size(); ++v) {
      EXPECT_TRUE(std::binary_search(vertex_of.begin(), vertex_of.end(), v));
    }
  }
}

TEST(Blocks, LeaveVerticesWhereTheyAre) {
  std::uint64_t n_contractions = 0;
  for (auto [name, mesh] : larger_meshes()) {
    for (const bool is_colored : {false, true}) {
      SCOPED_TRACE(name + (is_colored ? ", colored" : ""));
      if (is_colored) mesh.colors.assign(mesh.positions.size(), Color{0.5F, 0.2F, 1, 1});
      DecimateOptions options = memoryless();
      options.quadric.placement = Placement::endpoint;
      options.locked.resize(mesh.positions.size());
      for (Index v = 0; v < mesh.positions.size(); v += 50) options.locked[v] = 1;
      const Decimation d = in_blocks(mesh, mesh.faces.size() / 8, options);
      n_contractions += d.result.n_contractions;
      for (Index v = 0; v < d.mesh.positions.size(); ++v) {
        EXPECT_EQ(d.mesh.positions[v], mesh.positions[d.mesh.origins[v]]);
      }
      for (Index v = 0; v < mesh.positions.size(); v += 50) {
        if (d.vertex_map[v] == invalid_index) continue;
        EXPECT_EQ(d.mesh.origins[d.vertex_map[v]], v);
      }
      options.threads = 3;
      expect_equal(d, in_blocks(mesh, mesh.faces.size() / 8, options));
    }
  }
  EXPECT_GT(n_contractions, 10000U);
}

TEST(Blocks, CountValences) {
  const auto decimated = [](const IndexedMesh& mesh, double weight, unsigned threads) {
    DecimateOptions options = memoryless(threads);
    options.valence_weight = weight;
    return in_blocks(mesh, mesh.faces.size() / 8, options);
  };
  const auto regular_share = [](const Decimation& d) { return metrics::shape(d.mesh).valence.share_5_to_7; };
  for (const auto& [name, mesh] : {NamedMesh{"blob", blob(5, 1)}, NamedMesh{"noisy_sphere", noisy_sphere(4, 0.05, 2)},
                                   NamedMesh{"terrain", terrain(60, 3)}, NamedMesh{"moebius", moebius(120, 16)}}) {
    SCOPED_TRACE(name);
    const Decimation with_weight = decimated(mesh, 1, 1);
    EXPECT_GT(regular_share(with_weight), regular_share(decimated(mesh, 0, 1)) + 0.02);
    expect_equal(with_weight, decimated(mesh, 1, 3));
  }
}

TEST(Blocks, HoldSeams) {
  const IndexedMesh mesh = disc_in_square(60);
  const auto area_error = [&](double weight) {
    DecimateOptions options = memoryless();
    options.attribute_weights.seam = weight;
    return std::abs(area_of_disc(in_blocks(mesh, 400, options).mesh) / area_of_disc(mesh) - 1);
  };
  EXPECT_LT(area_error(0.1), 0.01);
  EXPECT_GT(area_error(0), 2 * area_error(0.1));
}

TEST(Blocks, LeaveAMeshThatIsMostlyNotManifold) {
  IndexedMesh mesh = blob(3, 1);
  for (std::size_t f = 0, n = mesh.faces.size(); f < n; f += 2) {  // a triangle on an edge of every other face
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 normal = area_normal(mesh.positions, mesh.faces[f]).normalized();
    mesh.positions.push_back(mesh.positions[a] + 0.1 * normal);
    mesh.faces.push_back({a, b, static_cast<Index>(mesh.positions.size() - 1)});
  }
  const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 3);
  std::size_t n_told = 0;
  DecimateOptions options = memoryless(2);
  options.listener = [&n_told](const Contraction&) { ++n_told; };
  const Decimation blocks = run(mesh, target, options, nullptr, small_blocks);
  EXPECT_EQ(blocks.result.why_in_one_pass, "much of it isn't manifold");
  EXPECT_EQ(blocks.result.n_contractions, n_told);
  expect_equal(blocks, run(mesh, target, memoryless(), nullptr, no_blocks));
}

// The exact order ----------------------------------------------------------------------------------------------------

/// The same to the bit as in one pass. \return whether most of it was done in blocks
bool keeps_exact_order(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
                       const BlockPlan& plan = small_blocks) {
  const Decimation one = run(mesh, target, options, nullptr, no_blocks);
  const Decimation blocks = run(mesh, target, options, nullptr, plan);
  expect_equal(blocks, one);
  EXPECT_EQ(blocks.mesh.colors, one.mesh.colors);
  EXPECT_EQ(blocks.result.refusals[Refusal::locked], one.result.refusals[Refusal::locked]);
  EXPECT_EQ(blocks.result.refusals[Refusal::shape], one.result.refusals[Refusal::shape]);
  EXPECT_EQ(blocks.result.refused_at_end[Refusal::link], one.result.refused_at_end[Refusal::link]);
  EXPECT_EQ(blocks.result.refused_at_end[Refusal::flip], one.result.refused_at_end[Refusal::flip]);
  EXPECT_EQ(blocks.result.stop, one.result.stop);
  return blocks.result.why_in_one_pass.empty();
}

TEST(SlowBlocksInExactOrder, GiveWhatOnePassGives) {
  int n_in_blocks = 0;
  for (const auto& [name, mesh] : larger_meshes()) {
    for (const std::size_t divisor : {2U, 10U, 50U}) {
      SCOPED_TRACE(name + " / " + std::to_string(divisor));
      n_in_blocks += keeps_exact_order(mesh, DecimateTarget::faces(mesh.faces.size() / divisor), plain_quadrics(2));
    }
    SCOPED_TRACE(name + " by vertices");
    n_in_blocks += keeps_exact_order(mesh, DecimateTarget::vertices(mesh.positions.size() / 5), plain_quadrics(3));
  }
  EXPECT_GT(n_in_blocks, 100);
}

TEST(BlocksInExactOrder, TakeLocksLimitsAndBorders) {
  for (const IndexedMesh& mesh : {terrain(40, 3), blob(4, 5), book(3, 40), soup(blob(3, 4))}) {
    const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 8);
    const auto with = [&](const auto& change) {
      DecimateOptions options = plain_quadrics(2);
      change(options);
      return keeps_exact_order(mesh, target, options);
    };
    EXPECT_TRUE(with([&](DecimateOptions& o) {
      o.locked.resize(mesh.positions.size());
      for (std::size_t v = 0; v < o.locked.size(); v += 37) o.locked[v] = 1;
    }));
    EXPECT_TRUE(with([](DecimateOptions& o) { o.min_radius_ratio = 0.2; }));
    EXPECT_TRUE(with([](DecimateOptions& o) { o.max_normal_flip_deg = 20; }));
    EXPECT_TRUE(with([](DecimateOptions& o) { o.boundary = Boundary::free; }));
    with([](DecimateOptions& o) { o.boundary = Boundary::locked; });
    EXPECT_TRUE(with([](DecimateOptions& o) { o.quadric.weights = Weights::uniform; }));
  }
}

/// Each of its pairs waits for the one before.
TEST(BlocksInExactOrder, AreGivenUpWherePairsWaitForEachOther) {
  IndexedMesh valley = grid(60, 60);
  for (Vec3& p : valley.positions) p.z() = 0.1 * p.x() * p.x();
  const DecimateTarget target = DecimateTarget::faces(valley.faces.size() / 4);
  BlockPlan plan = small_blocks;
  EXPECT_TRUE(keeps_exact_order(valley, target, plain_quadrics(2), plan));
  plan.least_done_in_exact_order = 0.5;
  EXPECT_FALSE(keeps_exact_order(valley, target, plain_quadrics(2), plan));
  EXPECT_EQ(run(valley, target, plain_quadrics(2), nullptr, plan).result.why_in_one_pass,
            "pairs wait for each other all over the mesh");
}

TEST(BlocksInExactOrder, BeginAgainAsAWholeWhenTheyWentTooFar) {
  BlockPlan greedy = small_blocks;
  greedy.faces_per_block = 1000;
  greedy.faces_per_block_in_exact_order = {2600, 1300};
  greedy.surplus_in_exact_order = 0.2;
  const IndexedMesh mesh = blob(4, 1);
  const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 3);
  EXPECT_FALSE(keeps_exact_order(mesh, target, plain_quadrics(2), greedy));
  DecimateOptions options = plain_quadrics(2);
  double last = 0;
  options.progress = [&last](const Progress& progress) {
    EXPECT_GE(progress.fraction, last);
    last = progress.fraction;
    return true;
  };
  const Decimation d = run(mesh, target, options, nullptr, greedy);
  EXPECT_EQ(d.result.why_in_one_pass, "blocks went beyond the target");
  EXPECT_EQ(last, 1);
}

// Threads, listener, progress ----------------------------------------------------------------------------------------

TEST(Blocks, GiveTheSameBytesOnAnyNumberOfThreads) {
  for (const auto& [name, mesh] : larger_meshes()) {
    SCOPED_TRACE(name);
    const Decimation one = in_blocks(mesh, mesh.faces.size() / 10, memoryless(1));
    for (const unsigned threads : {2U, 3U, 8U, 64U}) {
      expect_equal(one, in_blocks(mesh, mesh.faces.size() / 10, memoryless(threads)));
    }
  }
}

TEST(Blocks, TellContractionsInAnOrderThatReplaysToTheSameMesh) {
  for (const auto& [name, mesh] : larger_meshes()) {
    SCOPED_TRACE(name);
    std::vector<Contraction> made;
    DecimateOptions options = memoryless(3);
    options.listener = [&](const Contraction& contraction) { made.push_back(contraction); };
    const Decimation d = in_blocks(mesh, mesh.faces.size() / 10, options);
    ASSERT_EQ(made.size(), d.result.n_contractions);
    std::vector<Index> merged_into(mesh.positions.size());
    std::iota(merged_into.begin(), merged_into.end(), Index{0});
    std::vector<Vec3> positions = mesh.positions;
    std::vector<bool> is_gone(mesh.positions.size());
    for (const Contraction& contraction : made) {
      ASSERT_FALSE(is_gone[contraction.survivor] || is_gone[contraction.removed]);
      is_gone[contraction.removed] = true;
      merged_into[contraction.removed] = contraction.survivor;
      positions[contraction.survivor] = contraction.position;
    }
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      if (d.vertex_map[v] == invalid_index) continue;
      Index r = static_cast<Index>(v);
      while (merged_into[r] != r) r = merged_into[r];
      EXPECT_EQ(d.mesh.origins[d.vertex_map[v]], r);
      EXPECT_EQ(d.mesh.positions[d.vertex_map[v]], positions[r]);
    }
  }
}

TEST(Blocks, KeepLockedVerticesAndBorders) {
  const IndexedMesh mesh = terrain(40, 1);
  DecimateOptions options = memoryless();
  options.locked.assign(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 17) options.locked[v] = 1;
  const Decimation d = in_blocks(mesh, mesh.faces.size() / 5, options);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 17) {
    ASSERT_NE(d.vertex_map[v], invalid_index);
    EXPECT_EQ(d.mesh.positions[d.vertex_map[v]], mesh.positions[v]);
  }
  options = memoryless();
  options.boundary = Boundary::locked;
  const Decimation bordered = in_blocks(mesh, mesh.faces.size() / 5, options);
  EXPECT_EQ(topology(bordered.mesh).border_edges, topology(mesh).border_edges);
}

TEST(SlowBlocks, ErrHardlyMoreThanOnePassOverAll) {
  const BlockPlan plan{.fewest_faces = 1, .fewest_faces_again = 1000, .faces_per_block = 1000};
  double log_sum = 0;
  int n = 0;
  for (const IndexedMesh& mesh : {blob(5, 1), blob(5, 2), blob(5, 3), terrain(90, 3), knot(300, 30)}) {
    for (const std::size_t divisor : {4U, 10U, 50U}) {
      const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / divisor);
      const auto error = [&](const BlockPlan& p) {
        return metrics::surface_distance(mesh, run(mesh, target, memoryless(), nullptr, p).mesh, {.samples = 20'000})
            .mean;
      };
      const double ratio = error(plan) / error(no_blocks);
      EXPECT_LT(ratio, 1.08) << mesh.faces.size() << " faces to a share of 1/" << divisor;
      log_sum += std::log(ratio);
      ++n;
    }
  }
  EXPECT_LT(std::exp(log_sum / n), 1.01);
}

TEST(Blocks, DoNotDependOnTheUnit) {
  const IndexedMesh mesh = blob(4, 3);
  IndexedMesh larger = mesh;
  for (Vec3& p : larger.positions) p *= 1024;
  Decimation scaled = in_blocks(larger, 400, memoryless());
  for (Vec3& p : scaled.mesh.positions) p /= 1024;
  const Decimation d = in_blocks(mesh, 400, memoryless());
  scaled.result.max_cost = d.result.max_cost;
  expect_equal(d, scaled);
}

// Progress and cancelling --------------------------------------------------------------------------------------------

TEST(Blocks, ReportOneProgressThatNeverFalls) {
  const IndexedMesh mesh = blob(6, 1);
  std::vector<Progress> seen;
  DecimateOptions options = memoryless(3);
  const std::thread::id caller = std::this_thread::get_id();
  options.progress = [&](const Progress& progress) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    seen.push_back(progress);
    return true;
  };
  in_blocks(mesh, mesh.faces.size() / 10, options);
  ASSERT_GT(seen.size(), 10U);
  for (std::size_t i = 1; i < seen.size(); ++i) {
    EXPECT_GE(seen[i].fraction, seen[i - 1].fraction);
    EXPECT_LE(seen[i].n_faces, seen[i - 1].n_faces);
  }
  EXPECT_LE(seen.back().fraction, 1);
}

TEST(Blocks, LeaveAMeshWhenTheyAreCancelled) {
  const IndexedMesh mesh = blob(5, 1);
  const Topology before = topology(mesh);
  for (const int n_calls : {0, 1, 2, 5, 10, 20, 40, 80}) {
    SCOPED_TRACE(n_calls);
    DecimateOptions options = memoryless(2);
    int n = 0;
    options.progress = [&](const Progress&) { return n++ < n_calls; };
    const Decimation d = in_blocks(mesh, mesh.faces.size() / 20, options);
    EXPECT_EQ(d.result.stop, StopReason::cancelled);
    EXPECT_EQ(topology(d.mesh).euler(), before.euler());
    EXPECT_TRUE(topology(d.mesh).manifold());
    EXPECT_EQ(d.mesh.faces.size(), d.result.n_faces);
    EXPECT_EQ(n, n_calls + 1) << "not asked again";
  }
}

}  // namespace
}  // namespace whittle::test
