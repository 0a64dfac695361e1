#include "whittle/engine/threshold_pairs.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "brute_force_pairs.hh"
#include "support/meshes.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/engine/automatic_threshold.hh"
#include "whittle/io/read.hh"

// Compares the search with one that compares every two vertices, in model units.

namespace whittle {

void PrintTo(const VertexPair& pair, std::ostream* out) { *out << pair.a << "-" << pair.b; }

namespace test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string describe(const PairSearch& search) {
  return "threshold " + std::to_string(search.threshold) + ", max_pairs " +
         std::to_string(search.max_pairs.value_or(0)) + (search.across_walls ? "" : ", not across walls") +
         ", threads " + std::to_string(search.threads);
}

ThresholdPairs find_in(const IndexedMesh& mesh, const PairSearch& search) {
  return find_threshold_pairs(mesh.positions, mesh.faces, search);
}

/// Compares for several limits and numbers of threads. \return the number of pairs without a limit
std::size_t expect_as_brute_force(const std::string& name, const IndexedMesh& mesh, double threshold,
                                  bool across_walls = true) {
  const BruteForcePairs brute_force(mesh, threshold, across_walls);
  for (const std::uint32_t max_pairs : {0U, 1U, 2U, 7U, 32U}) {
    const ThresholdPairs expected = brute_force.pairs(max_pairs);
    for (const unsigned threads : {1U, 2U, 3U, 8U}) {
      PairSearch search{threshold, max_pairs, across_walls, threads};
      if (max_pairs == 0) search.max_pairs.reset();
      const ThresholdPairs found = find_in(mesh, search);
      EXPECT_EQ(found.pairs, expected.pairs) << name << ", " << describe(search);
      EXPECT_EQ(found.capped, expected.capped) << name << ", " << describe(search);
    }
  }
  return brute_force.pairs(0).pairs.size();
}

std::size_t expect_as_brute_force_with_walls(const std::string& name, const IndexedMesh& mesh, double threshold) {
  expect_as_brute_force(name, mesh, threshold, false);
  return expect_as_brute_force(name, mesh, threshold, true);
}

/// Random faces, some with equal corners. A few vertices are in no face.
IndexedMesh with_random_faces(std::vector<Vec3> positions, std::uint64_t seed) {
  Random random(seed);
  IndexedMesh mesh;
  mesh.positions = std::move(positions);
  const std::size_t n = mesh.positions.size();
  for (std::size_t i = 0; i < n; ++i) {
    Triangle face;
    for (Index& corner : face) corner = static_cast<Index>(random.below(n));
    if (i % 10 == 0) face[2] = face[0];
    mesh.faces.push_back(face);
  }
  return mesh;
}

TEST(ThresholdPairs, OfRandomPointsAreThoseOfBruteForce) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Random random(seed);
    std::vector<Vec3> positions(1500);  // fills several blocks and leaves of the search
    for (Vec3& p : positions) p = random.uniform_vector(-1, 1);
    const IndexedMesh mesh = with_random_faces(positions, seed);
    const std::string name = "random points, seed " + std::to_string(seed);
    EXPECT_GT(expect_as_brute_force_with_walls(name, mesh, 0.1), 100U);
    EXPECT_GT(expect_as_brute_force(name, mesh, 0.4), 10'000U);
  }
}

TEST(ThresholdPairs, OfClustersAreThoseOfBruteForce) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Random random(seed);
    std::vector<Vec3> positions;
    for (int cluster = 0; cluster < 12; ++cluster) {
      const Vec3 center = random.uniform_vector(-1, 1);
      const double radius = std::ldexp(1.0, -3 * cluster);
      for (int i = 0; i < 60; ++i) positions.push_back(center + random.uniform_vector(-radius, radius));
    }
    const IndexedMesh mesh = with_random_faces(positions, seed);
    const std::string name = "clusters, seed " + std::to_string(seed);
    for (const double threshold : {1e-9, 1e-4, 0.03, 0.5}) {
      EXPECT_GT(expect_as_brute_force(name, mesh, threshold), 100U) << threshold;
    }
  }
}

/// Many pairs have equal lengths, and many have exactly the threshold's length. Those are no pairs.
TEST(ThresholdPairs, OfGridPointsAreThoseOfBruteForce) {
  std::vector<Vec3> positions;
  for (int i = 0; i < 512; ++i) positions.push_back(Vec3(i % 8, i / 8 % 8, i / 64));
  const IndexedMesh mesh = with_random_faces(positions, 1);
  EXPECT_EQ(expect_as_brute_force("grid", mesh, 1), 0U);
  for (const double threshold : {1.001, std::sqrt(2.0), 2.0, 3.0, 5.0}) {
    EXPECT_GT(expect_as_brute_force("grid", mesh, threshold), 500U) << threshold;
    EXPECT_GT(expect_as_brute_force("grid, permuted", permuted(mesh, 2).mesh, threshold), 500U) << threshold;
  }
}

TEST(ThresholdPairs, OfCoincidentPointsAreThoseOfBruteForce) {
  Random random(1);
  std::vector<Vec3> places(20);
  for (Vec3& p : places) p = random.uniform_vector(-1, 1);
  places[0] = Vec3(0, 0, 0);
  places[1] = Vec3(-0.0, 0, -0.0);
  std::vector<Vec3> positions;
  for (int i = 0; i < 400; ++i) positions.push_back(places[random.below(places.size())]);
  const IndexedMesh mesh = with_random_faces(positions, 1);
  for (const double threshold : {1e-300, 0.01, 0.5, 1.5}) {
    EXPECT_GT(expect_as_brute_force("coincident points", mesh, threshold), 1000U) << threshold;
  }
}

/// The box is halved again and again, so the tree has its greatest depth.
TEST(ThresholdPairs, OfPointsCloserAndCloserAreThoseOfBruteForce) {
  std::vector<Vec3> positions;
  for (int i = 0; i < 300; ++i) {
    for (int axis = 0; axis < 3; ++axis) positions.push_back(Vec3::Unit(axis) * std::ldexp(1.0, -i));
  }
  const IndexedMesh mesh = with_random_faces(positions, 1);
  for (const double threshold : {1e-60, 1e-10}) {
    EXPECT_GT(expect_as_brute_force("closer and closer", mesh, threshold), 1000U) << threshold;
  }
}

TEST(ThresholdPairs, OfShapesAreThoseOfBruteForce) {
  std::size_t n_pairs = 0;
  for (const auto& [name, mesh] : all_meshes()) {
    for (const double share : {0.02, 0.1, 0.3}) {
      n_pairs += expect_as_brute_force_with_walls(name, mesh, share * diagonal(mesh));
    }
  }
  EXPECT_GT(n_pairs, 1000U);
}

TEST(ThresholdPairs, OfRealMeshesAreThoseOfBruteForce) {
  for (const char* file : {"dinosaur.obj", "bones.off"}) {
    WHITTLE_REAL_MESH_OR_SKIP(path, file);
    const IndexedMesh mesh = io::read_mesh(path).mesh;
    for (const double share : {0.02, 0.06}) {
      EXPECT_GT(expect_as_brute_force_with_walls(file, mesh, share * diagonal(mesh)), 100U) << file;
    }
  }
}

TEST(ThresholdPairs, AreNoneAtThresholdZero) {
  const IndexedMesh mesh = soup(sphere(1));
  const ThresholdPairs found = find_in(mesh, {.threshold = 0});
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_FALSE(found.capped);
  EXPECT_FALSE(find_in(mesh, {.threshold = std::numeric_limits<double>::denorm_min()}).pairs.empty());
}

TEST(ThresholdPairs, AreAllPairsAtInfinity) {
  for (const auto& [name, mesh] : all_meshes()) expect_as_brute_force(name, mesh, infinity);
  const IndexedMesh mesh = soup(sphere(1));
  const std::size_t n = mesh.positions.size();
  const ThresholdPairs found = find_in(mesh, {.threshold = infinity, .max_pairs = std::nullopt, .across_walls = true});
  EXPECT_EQ(found.pairs.size(), n * (n - 1) / 2 - n);  // all pairs but the edges; there are n edges
}

TEST(ThresholdPairs, AreNoneWithoutFaces) {
  IndexedMesh mesh;
  EXPECT_TRUE(find_in(mesh, {.threshold = 1}).pairs.empty());
  mesh.positions = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {infinity, 0, 0}};
  EXPECT_TRUE(find_in(mesh, {.threshold = 1}).pairs.empty());
  mesh.faces = {{0, 1, 1}, {2, 2, 2}};
  EXPECT_TRUE(find_in(mesh, {.threshold = 1}).pairs.empty());
}

/// The position of a vertex in no face may be anything, also NaN or infinite.
TEST(ThresholdPairs, IgnoreVerticesWithoutFaces) {
  IndexedMesh mesh = spheres(2, 2, 0.1);
  const ThresholdPairs expected = find_in(mesh, {.threshold = 0.3});
  EXPECT_FALSE(expected.pairs.empty());
  mesh.positions.push_back(mesh.positions[0]);
  mesh.positions.push_back({1e300, 0, 0});
  mesh.positions.push_back({0, std::numeric_limits<double>::quiet_NaN(), 0});
  EXPECT_EQ(find_in(mesh, {.threshold = 0.3}).pairs, expected.pairs);
}

TEST(ThresholdPairs, AreTheSameInEveryUnit) {
  const IndexedMesh mesh = soup(noisy_sphere(2, 0.1, 3));
  for (const double threshold : {1e-3, 0.2, 0.7}) {
    const ThresholdPairs here = find_in(mesh, {.threshold = threshold});
    EXPECT_FALSE(here.pairs.empty());
    for (const int exponent : {-1000, -700, -10, 10, 600, 1020}) {  // 1e-301 to 1e307
      const double factor = std::ldexp(1.0, exponent);
      const ThresholdPairs there = find_in(scaled(mesh, factor), {.threshold = threshold * factor});
      EXPECT_EQ(there.pairs, here.pairs) << "2^" << exponent;
      EXPECT_EQ(there.capped, here.capped) << "2^" << exponent;
    }
  }
}

TEST(ThresholdPairs, AreThoseOfBruteForceFarAway) {
  const IndexedMesh mesh = moved(soup(noisy_sphere(2, 0.1, 3)), Vec3(1e6, -2e6, 3e6));
  EXPECT_GT(expect_as_brute_force("far away", mesh, 0.2), 100U);
}

TEST(ThresholdPairs, FollowTheVerticesInAnotherOrder) {
  const IndexedMesh mesh = spheres(3, 2, 0.1);
  const Permuted other = permuted(mesh, 5);
  std::vector<VertexPair> back;
  for (const VertexPair& pair : find_in(other.mesh, {.threshold = 0.3, .max_pairs = std::nullopt}).pairs) {
    const Index v = other.old_vertex[pair.a];
    const Index w = other.old_vertex[pair.b];
    back.push_back({std::min(v, w), std::max(v, w)});
  }
  std::sort(back.begin(), back.end());
  EXPECT_EQ(back, find_in(mesh, {.threshold = 0.3, .max_pairs = std::nullopt}).pairs);
}

/// The fan of a cone in which every face has its own apex. Each apex has pairs with the apexes of the lowest numbers.
/// Comparing it with all others as well would take too long.
TEST(ThresholdPairs, OfVeryManyVerticesAtOnePointAreThoseOfTheLowestNumbers) {
  constexpr Index n = 100'000;
  constexpr Index max_pairs = 4;
  IndexedMesh mesh;
  for (Index i = 0; i < n; ++i) mesh.positions.push_back({0, 0, 0});
  for (Index i = 0; i < n; ++i) {
    const double angle = 6.28 * i / n;
    mesh.positions.push_back({1000 * std::cos(angle), 1000 * std::sin(angle), 1000});
  }
  for (Index i = 0; i + 1 < n; ++i) mesh.faces.push_back({i, n + i, n + i + 1});
  mesh.faces.push_back({n - 1, 2 * n - 1, n});

  std::set<VertexPair> expected;
  for (Index v = 0; v < n; ++v) {
    for (Index w = 0; w <= max_pairs; ++w) {
      if (w != v && !(w == max_pairs && v >= max_pairs)) expected.insert({std::min(v, w), std::max(v, w)});
    }
  }
  const ThresholdPairs found = find_in(mesh, {.threshold = 1e-3, .max_pairs = max_pairs});
  EXPECT_TRUE(found.capped);
  EXPECT_EQ(found.pairs, std::vector<VertexPair>(expected.begin(), expected.end()));
}

TEST(ThresholdPairs, AreCappedOnlyAboveTheLimit) {
  const IndexedMesh mesh = soup(tetrahedron());  // each vertex coincides with two others
  EXPECT_FALSE(find_in(mesh, {.threshold = 0.1, .max_pairs = 2}).capped);
  EXPECT_EQ(find_in(mesh, {.threshold = 0.1, .max_pairs = 2}).pairs.size(), 12U);
  EXPECT_TRUE(find_in(mesh, {.threshold = 0.1, .max_pairs = 1}).capped);
  EXPECT_EQ(find_in(mesh, {.threshold = 0.1, .max_pairs = 1}).pairs.size(),
            8U);  // of every three: first and second, first and third
}

/// The horizontal square [0, 4]² at height z, with a vertex spacing of 1.
IndexedMesh sheet(double z, bool faces_up) {
  const IndexedMesh flat = moved(grid(4, 4), Vec3(0, 0, z));
  return faces_up ? flat : inside_out(flat);
}

bool joins_both(const VertexPair& pair, Index n_first) { return pair.a < n_first && pair.b >= n_first; }

TEST(ThresholdPairs, AcrossTheInsideOfAPlateAreLeftOut) {
  const IndexedMesh plate = joined(sheet(0, false), sheet(0.1, true));
  EXPECT_EQ(find_in(plate, {.threshold = 0.2, .across_walls = true}).pairs.size(), 25U);
  EXPECT_TRUE(find_in(plate, {.threshold = 0.2, .across_walls = false}).pairs.empty());
  EXPECT_EQ(find_in(inside_out(plate), {.threshold = 0.2, .across_walls = false}).pairs.size(), 25U);
}

TEST(ThresholdPairs, AcrossAGapStay) {
  const IndexedMesh gap = joined(sheet(0, true), sheet(0.1, false));
  EXPECT_EQ(find_in(gap, {.threshold = 0.2, .across_walls = false}).pairs.size(), 25U);
  const IndexedMesh bodies = spheres(2, 3, 0.05);
  const auto everything = find_in(bodies, {.threshold = 0.2, .across_walls = true}).pairs;
  EXPECT_FALSE(everything.empty());
  EXPECT_EQ(find_in(bodies, {.threshold = 0.2, .across_walls = false}).pairs, everything);
}

/// A plate and a sheet. The gap between them is larger than the plate's thickness.
TEST(ThresholdPairs, AcrossWallsDontCountForTheLimit) {
  const IndexedMesh plate = joined(sheet(0, false), sheet(0.1, true));
  const IndexedMesh both = joined(plate, sheet(0.3, false));
  const Index n = 25;
  const ThresholdPairs found = find_in(both, {.threshold = 0.25, .max_pairs = 1, .across_walls = false});
  EXPECT_FALSE(found.capped);
  ASSERT_EQ(found.pairs.size(), n);
  for (const VertexPair& pair : found.pairs) {
    EXPECT_GE(pair.a, n);
    EXPECT_TRUE(joins_both(pair, 2 * n)) << testing::PrintToString(pair);
  }
}

TEST(ThresholdPairs, RefuseWhatIsNoThreshold) {
  const IndexedMesh mesh = tetrahedron();
  EXPECT_THROW(find_in(mesh, {.threshold = -1e-300}), std::invalid_argument);
  EXPECT_THROW(find_in(mesh, {.threshold = -infinity}), std::invalid_argument);
  EXPECT_THROW(find_in(mesh, {.threshold = std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
}

TEST(ThresholdPairs, CanBeCancelledWhileTheyAreSearched) {
  const IndexedMesh mesh = spheres(2, 3, 0.1);
  for (const int n_allowed : {0, 1}) {
    int n_calls = 0;
    PairSearch search{.threshold = 0.2};
    search.progress = [&](const TaskProgress&) { return ++n_calls <= n_allowed; };
    EXPECT_THROW(find_in(mesh, search), Cancelled);
    EXPECT_EQ(n_calls, n_allowed + 1) << "not asked again";
  }
}

TEST(ThresholdPairs, RefuseWhatIsNoMesh) {
  IndexedMesh mesh = tetrahedron();
  mesh.faces[2][1] = 4;
  EXPECT_THROW(find_in(mesh, {.threshold = 1}), std::invalid_argument);
  mesh = tetrahedron();
  mesh.positions[3].y() = infinity;
  EXPECT_THROW(find_in(mesh, {.threshold = 1}), std::invalid_argument);
}

TEST(AutomaticThreshold, IsATenthAboveTheWidestGapThatCounts) {
  for (const double unit : {1e-3, 1.0, 1e3}) {
    SCOPED_TRACE(unit);
    const auto threshold = [unit](const IndexedMesh& mesh) { return automatic_threshold(scaled(mesh, unit)) / unit; };
    EXPECT_NEAR(threshold(boxes(2, 1, 0.125)), 1.1 * 0.125, 1e-12);
    EXPECT_EQ(threshold(cube()), 0);
    // The box of both is 4 + gap long, 2 wide and high. A twentieth of its diagonal is 0.258 at a gap of 0.25 and
    // 0.2594 at one of 0.28, which doesn't count.
    EXPECT_NEAR(threshold(boxes(2, 1, 0.25)), 1.1 * 0.25, 1e-12);
    EXPECT_EQ(threshold(boxes(2, 1, 0.28)), 0);
    EXPECT_NEAR(threshold(boxes(2, 1, 0)), 1e-9 * std::sqrt(12.0), 1e-18);  // parts that touch are joined, too
  }
}

}  // namespace
}  // namespace test
}  // namespace whittle
