// Decimation within a distance of the input. metrics::largest_distances judges the results.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/meshes.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/io/read.hh"
#include "whittle/metrics/certify.hh"
#include "whittle/metrics/topology.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

double diagonal(const IndexedMesh& mesh) { return diagonal_of(mesh.positions); }

/// Of all points, both ways; proven to a thousandth.
double largest_distance(const IndexedMesh& a, const IndexedMesh& b) {
  const metrics::LargestDistances found = metrics::largest_distances(a, b, 1e-3);
  return std::max(found.forward.at_least, found.backward.at_least);
}

void expect_kept(const IndexedMesh& input, double max_error, const Decimation& result) {
  EXPECT_EQ(result.result.proven_error, max_error);
  ASSERT_FALSE(result.mesh.faces.empty());
  EXPECT_EQ(metrics::certify(input, result.mesh, (1 + 1e-9) * max_error).verdict, Verdict::proven)
      << "largest: " << largest_distance(input, result.mesh) / max_error;
  EXPECT_EQ(metrics::certify_borders(input, result.mesh, (1 + 1e-9) * max_error).verdict, Verdict::proven);
}

std::vector<NamedMesh> meshes_to_prove() {
  return {{"sphere", sphere(4)},
          {"noisy torus", noisy_torus(48, 24, 1, 0.4, 0.02, 1)},
          {"bracket", bracket(12)},
          {"terrain", terrain(32, 3)},
          {"open cylinder", open_cylinder(40, 20)},
          {"knot", knot(120, 12)},
          {"book", book(5, 12)},
          {"two sheets", joined(noisy_grid(20, 20, 0.01, 1), noisy_grid(20, 20, 0.01, 2))}};
}

TEST(SlowMaxError, IsKeptByAllCosts) {
  for (const auto& [name, mesh] : meshes_to_prove()) {
    for (const CostTraits& traits : all_cost_traits) {
      const Cost cost = traits.cost;
      for (const double share : {0.001, 0.01, 0.05}) {
        SCOPED_TRACE(name + ", cost " + std::to_string(static_cast<int>(cost)) + ", " + std::to_string(share));
        const double max_error = share * diagonal(mesh);
        DecimateOptions options;
        options.cost = cost;
        const Decimation result = decimate(mesh, DecimateTarget::max_error(max_error), options);
        expect_kept(mesh, max_error, result);
        EXPECT_LE(result.mesh.faces.size(), mesh.faces.size());
        EXPECT_TRUE(result.result.stop == StopReason::error || result.result.stop == StopReason::exhausted);
        if (share == 0.05) {
          EXPECT_LT(result.mesh.faces.size(), mesh.faces.size() / 4);
        }
      }
    }
  }
}

TEST(MaxError, IsKeptOnAllKindsOfMeshes) {
  for (const auto& [name, mesh] : all_meshes()) {
    for (const double share : {0.003, 0.03}) {
      SCOPED_TRACE(name + ", " + std::to_string(share));
      const double max_error = share * diagonal(mesh);
      expect_kept(mesh, max_error, simplify(mesh, DecimateTarget::max_error(max_error)));
    }
  }
}

/// Much fewer than those of the coarsest mesh by count that is as near.
TEST(SlowMaxError, TakesFewFaces) {
  for (const auto& [name, mesh] : {NamedMesh{"knot", knot(200, 24)}, NamedMesh{"blob", blob(5, 1)}}) {
    SCOPED_TRACE(name);
    const double max_error = 0.004 * diagonal(mesh);
    const std::size_t n_faces = simplify(mesh, DecimateTarget::max_error(max_error)).mesh.faces.size();
    for (const double more : {1.0, 1.1, 1.2}) {
      const auto n = static_cast<std::uint64_t>(more * static_cast<double>(n_faces));
      EXPECT_GT(largest_distance(mesh, simplify(mesh, DecimateTarget::faces(n)).mesh), max_error);
    }
  }
}

TEST(MaxError, LeavesOfFlatPartsWhatTheBorderNeeds) {
  const IndexedMesh mesh = tessellated_cube(12);
  const Decimation result = decimate(mesh, DecimateTarget::max_error(1e-6));
  EXPECT_EQ(result.mesh.faces.size(), 12U);
  expect_kept(mesh, 1e-6, result);
}

/// Less than rounding errors: nothing can be proven, so nothing is done.
TEST(MaxError, TooSmallLeavesTheMeshAsItIs) {
  const IndexedMesh mesh = sphere(3);
  const Decimation result = decimate(mesh, DecimateTarget::max_error(1e-16));
  EXPECT_EQ(result.mesh.positions, mesh.positions);
  EXPECT_EQ(result.mesh.faces, mesh.faces);
  EXPECT_EQ(result.result.stop, StopReason::error);
  EXPECT_EQ(result.result.proven_error, 1e-16);
}

TEST(MaxError, GoesWithOtherTargets) {
  const IndexedMesh mesh = blob(4, 2);
  const double max_error = 0.02 * diagonal(mesh);
  const Decimation alone = decimate(mesh, DecimateTarget::max_error(max_error));
  const std::size_t n = 2 * alone.mesh.faces.size();
  const Decimation by_count = decimate(mesh, DecimateTarget::max_error(max_error).or_faces(n));
  EXPECT_EQ(by_count.result.stop, StopReason::target);
  EXPECT_LE(by_count.mesh.faces.size(), n);
  EXPECT_GT(by_count.mesh.faces.size(), n - 4);
  expect_kept(mesh, max_error, by_count);
  const Decimation by_cost = decimate(mesh, DecimateTarget::max_error(max_error).or_max_cost(1e-9));
  EXPECT_EQ(by_cost.result.stop, StopReason::cost);
  EXPECT_GT(by_cost.mesh.faces.size(), alone.mesh.faces.size());
  expect_kept(mesh, max_error, by_cost);
  EXPECT_FALSE(decimate(mesh, DecimateTarget::faces(n)).result.proven_error);
}

TEST(MaxError, MayBeLessForBorders) {
  for (const auto& [name, mesh] : {NamedMesh{"terrain", terrain(40, 3)}, NamedMesh{"cylinder", open_cylinder(60, 20)},
                                   NamedMesh{"strip", moebius(80, 4)}}) {
    SCOPED_TRACE(name);
    const double max_error = 0.02 * diagonal(mesh);
    const auto border_distance = [&mesh = mesh](const Simplification& result) {
      const auto found = metrics::largest_border_distances(mesh, result.mesh, 0.01);
      return std::max(found->forward.at_least, found->backward.at_least);
    };
    const Simplification alike = simplify(mesh, DecimateTarget::max_error(max_error));
    const Simplification less = simplify(mesh, DecimateTarget::max_error(max_error, 0.1 * max_error));
    EXPECT_GT(border_distance(alike), 0.1 * max_error);
    EXPECT_LE(border_distance(less), 0.1 * max_error);
    EXPECT_GT(less.mesh.faces.size(), alike.mesh.faces.size());
    EXPECT_LT(less.mesh.faces.size(), mesh.faces.size() / 2);
  }
}

/// Borders may move far where the surface hardly does.
TEST(SlowMaxError, GoesFarOnFlatGroundWithHoles) {
  WHITTLE_REAL_MESH_OR_SKIP(path, "geo_delft_testarea.obj");
  const IndexedMesh mesh = io::read_mesh(path, {.attributes = io::AttributeScope::per_vertex}).mesh;  // no materials
  const double max_error = 0.003 * diagonal(mesh);
  const Decimation result = decimate(mesh, DecimateTarget::max_error(max_error));
  expect_kept(mesh, max_error, result);
  EXPECT_LT(result.mesh.faces.size(), mesh.faces.size() / 10);
}

TEST(MaxError, KeepsTopologyAndLockedVertices) {
  const IndexedMesh mesh = torus(48, 24);
  DecimateOptions options;
  options.locked.assign(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 50) options.locked[v] = 1;
  SimplifyOptions simplify_options;
  simplify_options.decimate = options;
  const Simplification result =
      simplify(mesh, DecimateTarget::max_error(0.02 * diagonal(mesh)), Effort::normal, simplify_options);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 50) {
    EXPECT_EQ(result.mesh.positions[result.vertex_map[v]], mesh.positions[v]);
  }
  const metrics::Topology topology = metrics::topology(result.mesh);
  EXPECT_TRUE(topology.manifold && topology.closed);
  EXPECT_EQ(topology.genus, 1);
}

TEST(MaxError, DoesNotDependOnThreadsUnitsAndPlace) {
  const IndexedMesh mesh = noisy_torus(40, 20, 1, 0.4, 0.03, 5);
  const double max_error = 0.01 * diagonal(mesh);
  SimplifyOptions options;
  options.decimate.threads = 1;
  const Simplification expected = simplify(mesh, DecimateTarget::max_error(max_error), Effort::normal, options);
  for (const unsigned threads : {2U, 5U}) {
    options.decimate.threads = threads;
    const Simplification result = simplify(mesh, DecimateTarget::max_error(max_error), Effort::normal, options);
    EXPECT_EQ(result.mesh.positions, expected.mesh.positions);
    EXPECT_EQ(result.mesh.faces, expected.mesh.faces);
  }
  IndexedMesh large = mesh;
  for (Vec3& p : large.positions) p *= 1024;
  const Simplification result = simplify(large, DecimateTarget::max_error(1024 * max_error), Effort::normal, options);
  EXPECT_EQ(result.mesh.faces, expected.mesh.faces);
}

/// So large a mesh is first contracted in blocks, and then compared with what these leave.
TEST(MaxError, IsKeptWhereBlocksBegin) {
  const IndexedMesh mesh = noisy_torus(480, 220, 1, 0.4, 1e-4, 5);
  ASSERT_GT(mesh.faces.size(), 200'000U);
  const double max_error = 0.003 * diagonal(mesh);
  std::vector<Index> went_to(mesh.positions.size());
  std::iota(went_to.begin(), went_to.end(), Index{0});
  DecimateOptions options;
  options.threads = 1;
  options.listener = [&](const Contraction& contraction) { went_to[contraction.removed] = contraction.survivor; };
  const Decimation result = decimate(mesh, DecimateTarget::max_error(max_error), options);
  expect_kept(mesh, max_error, result);
  EXPECT_LT(result.mesh.faces.size(), mesh.faces.size() / 100);
  std::size_t n_left = 0;
  for (Index v = 0; v < went_to.size(); ++v) n_left += went_to[v] == v ? 1 : 0;
  EXPECT_EQ(n_left, result.mesh.positions.size());
  options.threads = 3;
  options.listener = {};
  const Decimation other = decimate(mesh, DecimateTarget::max_error(max_error), options);
  EXPECT_EQ(other.mesh.positions, result.mesh.positions);
  EXPECT_EQ(other.mesh.faces, result.mesh.faces);
}

/// Contractions that were taken back are not told.
TEST(MaxError, TellsContractionsOnce) {
  const IndexedMesh mesh = blob(4, 3);
  std::vector<Index> went_to(mesh.positions.size());
  for (Index v = 0; v < went_to.size(); ++v) went_to[v] = v;
  std::uint64_t n_contractions = 0;
  DecimateOptions options;
  options.listener = [&](const Contraction& contraction) {
    ++n_contractions;
    ASSERT_EQ(went_to[contraction.removed], contraction.removed);
    ASSERT_EQ(went_to[contraction.survivor], contraction.survivor);
    went_to[contraction.removed] = contraction.survivor;
  };
  const Decimation result = decimate(mesh, DecimateTarget::max_error(0.01 * diagonal(mesh)), options);
  EXPECT_EQ(n_contractions, result.result.n_contractions);
  EXPECT_EQ(n_contractions, mesh.positions.size() - result.mesh.positions.size());
  for (Index v = 0; v < went_to.size(); ++v) {
    Index root = v;
    while (went_to[root] != root) root = went_to[root];
    EXPECT_EQ(result.mesh.origins[result.vertex_map[v]], root);
  }
}

TEST(MaxError, IsNotProvenIfCancelled) {
  const IndexedMesh mesh = sphere(5);
  for (const int last_call : {0, 1, 3, 10}) {
    int n_calls = 0;
    DecimateOptions options;
    options.progress = [&](const Progress&) { return n_calls++ < last_call; };
    const Decimation result = decimate(mesh, DecimateTarget::max_error(0.02), options);
    if (result.result.stop != StopReason::cancelled) continue;
    EXPECT_FALSE(result.result.proven_error);
  }
}

TEST(MaxError, RefusesWhatHasNoMeaning) {
  const IndexedMesh mesh = sphere(1);
  for (const double max_error : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(decimate(mesh, DecimateTarget::max_error(max_error)), std::invalid_argument);
    EXPECT_THROW(decimate(mesh, DecimateTarget::max_error(1, max_error)), std::invalid_argument);
  }
}

/// Tight where x is small, loose elsewhere.
std::vector<double> tight_on_one_side(const IndexedMesh& mesh, double tight, double loose) {
  const Box box = bounds_of(mesh.positions);
  std::vector<double> tolerances;
  for (const Vec3& p : mesh.positions) {
    tolerances.push_back(p.x() < 0.5 * (box.min().x() + box.max().x()) ? tight : loose);
  }
  return tolerances;
}

TEST(MaxError, IsLessInPlaces) {
  for (const auto& named : meshes_to_prove()) {
    SCOPED_TRACE(named.name);
    const IndexedMesh& mesh = named.mesh;  // Clang 14 captures no structured bindings
    const double loose = 0.02 * diagonal(mesh);
    const double tight = 0.002 * diagonal(mesh);
    DecimateOptions options;
    options.cost = Cost::memoryless;
    const auto n_faces = [&](double max_error) {
      return decimate(mesh, DecimateTarget::max_error(max_error), options).mesh.faces.size();
    };
    const std::size_t n_loose = n_faces(loose);
    const std::size_t n_tight = n_faces(tight);
    options.tolerances = tight_on_one_side(mesh, tight, loose);
    const Decimation result = decimate(mesh, DecimateTarget::max_error(loose), options);
    expect_kept(mesh, loose, result);
    for (double& tolerance : options.tolerances) tolerance *= 1 + 1e-9;
    EXPECT_EQ(metrics::certify(mesh, result.mesh, (1 + 1e-9) * loose, {.tolerances = options.tolerances}).verdict,
              Verdict::proven);
    EXPECT_GE(result.mesh.faces.size(), n_loose);
    EXPECT_LE(result.mesh.faces.size(), n_tight + n_tight / 10);
    if (n_tight > 4 * n_loose) {
      EXPECT_LT(result.mesh.faces.size(), 3 * n_tight / 4 + n_loose);
    }
  }
}

TEST(MaxError, IsKeptByPolishWhereItIsLess) {
  const IndexedMesh mesh = noisy_torus(80, 40, 1, 0.4, 0.01, 1);
  SimplifyOptions options;
  options.decimate.tolerances = tight_on_one_side(mesh, 0.01, 0.05);
  const Simplification result = simplify(mesh, DecimateTarget::max_error(0.05), Effort::normal, options);
  EXPECT_GT(result.polish.n_moved, 0U);
  EXPECT_EQ(metrics::certify(mesh, result.mesh, 0.05, {.tolerances = options.decimate.tolerances}).verdict,
            Verdict::proven);
}

TEST(MaxError, RefusesTolerancesThatDoNotFit) {
  const IndexedMesh mesh = cube();
  DecimateOptions options;
  options.tolerances.assign(mesh.positions.size(), 1);
  EXPECT_NO_THROW(decimate(mesh, DecimateTarget::max_error(1), options));
  EXPECT_THROW(decimate(mesh, DecimateTarget::faces(4), options), std::invalid_argument);
  options.tolerances[0] = 0;
  EXPECT_THROW(decimate(mesh, DecimateTarget::max_error(1), options), std::invalid_argument);
  options.tolerances.pop_back();
  EXPECT_THROW(decimate(mesh, DecimateTarget::max_error(1), options), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::test
