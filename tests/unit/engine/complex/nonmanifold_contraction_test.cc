#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "oracle/brute_force.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "support/transforms.hh"
#include "whittle/engine/decimate.hh"

// Contractions that change the topology: threshold pairs, and edges under free topology.

namespace whittle::test {
namespace {

DecimateTarget to_vertices(std::uint64_t n) { return DecimateTarget::vertices(n); }

DecimateOptions with_threshold(double threshold) {
  DecimateOptions options;
  options.pairs.threshold = threshold;
  return options;
}

/// The cube (±1)³ and its mirror image beside it.
IndexedMesh mirrored_cubes(double gap) {
  IndexedMesh image = inside_out(cube());
  for (Vec3& p : image.positions) p.x() = 2 + gap - p.x();
  return joined(cube(), image);
}

TEST(NonmanifoldContraction, TwoBoxesWithAGapBecomeOneAndTheWallsBetweenThemVanish) {
  const Decimation d = decimate(mirrored_cubes(0.1), to_vertices(12), with_threshold(0.11));
  EXPECT_EQ(d.result.threshold_pairs.considered, 4U);
  EXPECT_EQ(d.result.threshold_pairs.contracted, 4U);
  EXPECT_EQ(d.result.n_coincident_faces, 4U);
  EXPECT_EQ(d.result.before.components, 2U);
  EXPECT_EQ(d.result.after.components, 1U);
  EXPECT_EQ(d.result.after.nonmanifold_edges, 0U);
  EXPECT_EQ(d.result.n_vanished_components, 0U);
  EXPECT_EQ(d.mesh.faces.size(), 20U);
  EXPECT_EQ(d.mesh.positions.size(), 12U);
  EXPECT_TRUE(topology(d.mesh).closed());
  EXPECT_TRUE(topology(d.mesh).manifold());
}

TEST(NonmanifoldContraction, AreThoseStrictlyCloser) {
  const IndexedMesh mesh = boxes(2, 1, 0.125);
  EXPECT_EQ(
      decimate(mesh, DecimateTarget::as_far_as_possible(), with_threshold(0.125)).result.threshold_pairs.considered,
      0U);
  EXPECT_EQ(
      decimate(mesh, DecimateTarget::as_far_as_possible(), with_threshold(0.1251)).result.threshold_pairs.considered,
      4U);
}

TEST(NonmanifoldContraction, ABowTieIsCounted) {
  const Decimation d = decimate(spheres(2, 2, 0.01), to_vertices(2 * 162 - 1), with_threshold(0.02));
  EXPECT_EQ(d.result.threshold_pairs.contracted, 1U);
  EXPECT_EQ(d.result.before.nonmanifold_vertices, 0U);
  EXPECT_EQ(d.result.after.nonmanifold_vertices, 1U);
  EXPECT_EQ(d.result.after.components, 1U);
}

TEST(NonmanifoldContraction, AcrossAThinWallAreLeftOutUnlessAskedFor) {
  IndexedMesh plate = tessellated_cube(3);
  for (Vec3& p : plate.positions) p.z() *= 0.005;
  DecimateOptions options = with_threshold(0.02);
  const std::uint64_t n_beside_walls =
      decimate(plate, DecimateTarget::as_far_as_possible(), options).result.threshold_pairs.considered;
  options.pairs.across_walls = true;
  const std::uint64_t n_all =
      decimate(plate, DecimateTarget::as_far_as_possible(), options).result.threshold_pairs.considered;
  EXPECT_GE(n_all, n_beside_walls + 4);  // the inner vertices of both sides
}

TEST(NonmanifoldContraction, WithoutAnyAllIsAsWithoutAThreshold) {
  const IndexedMesh mesh = spheres(2, 2, 0.5);
  const auto contractions = [&](double threshold) {
    std::vector<Index> survivors;
    DecimateOptions options = with_threshold(threshold);
    options.listener = [&](const Contraction& c) { survivors.push_back(c.survivor); };
    decimate(mesh, to_vertices(20), options);
    return survivors;
  };
  EXPECT_EQ(contractions(1e-6), contractions(0));
}

TEST(NonmanifoldContraction, OfLockedVerticesLeaveThemWhereTheyAre) {
  const IndexedMesh mesh = boxes(2, 1, 0.1);
  const std::vector<std::uint8_t> locked(mesh.positions.size(), 1);
  DecimateOptions options = with_threshold(0.2);
  options.locked = locked;
  const Decimation d = decimate(mesh, DecimateTarget::as_far_as_possible(), options);
  EXPECT_EQ(d.result.n_contractions, 0U);
  EXPECT_EQ(d.result.threshold_pairs.considered, 4U);
}

/// Open tubes in a row; each touches the next in a vertex of its rim.
IndexedMesh touching_tubes(int count) {
  const IndexedMesh tube = open_cylinder(8, 5);
  IndexedMesh row = tube;
  const Vec3 step = tube.positions.back() - tube.positions.front();
  for (int i = 1; i < count; ++i) row = joined(row, moved(tube, i * step));
  return glued(row);
}

TEST(KeptTopology, HoldsAtVerticesThatAreNotManifold) {
  std::vector<NamedMesh> meshes = nonmanifold_meshes();
  meshes.push_back({"touching tubes", touching_tubes(4)});
  EXPECT_EQ(topology(meshes.back().mesh).nonmanifold_vertices, 3);
  for (const auto& [name, mesh] : meshes) {
    const Topology before = topology(mesh);
    for (const CostTraits& traits : all_cost_traits) {
      const Cost cost = traits.cost;
      DecimateOptions options;
      options.cost = cost;
      options.max_normal_flip_deg = 180;
      const Topology after = topology(decimate(mesh, DecimateTarget::faces(1), options).mesh);
      const std::string what = name + ", " + std::string(to_string(cost));
      EXPECT_EQ(after.euler(), before.euler()) << what;
      EXPECT_EQ(after.components, before.components) << what;
      EXPECT_LE(after.misoriented_edges, before.misoriented_edges) << what;
      EXPECT_LE(after.nonmanifold_edges, before.nonmanifold_edges) << what;
      EXPECT_LE(after.nonmanifold_vertices, before.nonmanifold_vertices) << what;
    }
  }
}

TEST(FreeTopology, LetsPartsVanishButNotTheLastFace) {
  DecimateOptions options;
  options.topology = whittle::Topology::free;
  options.max_normal_flip_deg = 180;
  const Decimation d = decimate(joined(tetrahedron(), spheres(1, 1, 0)), DecimateTarget::as_far_as_possible(), options);
  EXPECT_GT(d.mesh.faces.size(), 0U);
  EXPECT_EQ(d.result.n_vanished_components, 1U);
  EXPECT_EQ(d.result.before.components, 2U);
  EXPECT_EQ(d.result.after.components, 1U);
}

TEST(FreeTopology, ClosesTunnels) {
  DecimateOptions options;
  options.topology = whittle::Topology::free;
  const IndexedMesh mesh = torus(24, 6, 1.0, 0.1);
  const DecimateTarget target = DecimateTarget::faces(12);
  const Decimation kept = decimate(mesh, target);
  EXPECT_GT(kept.mesh.faces.size(), target.n_faces());  // a torus has at least 14 faces
  const Decimation d = decimate(mesh, target, options);
  EXPECT_LE(d.mesh.faces.size(), target.n_faces());
  EXPECT_GT(d.mesh.faces.size(), 0U);
}

DecimateOptions automatic() {
  DecimateOptions options;
  options.topology = whittle::Topology::automatic;
  return options;
}

TEST(AutomaticTopology, IsKeptOnOnePartAndOnSeparateFaces) {
  for (const IndexedMesh& mesh : {torus(24, 6, 1.0, 0.1), grid(9, 9), soup(noisy_grid(9, 9, 0.3, 1))}) {
    const DecimateTarget target = DecimateTarget::faces(4);
    const Decimation kept = decimate(mesh, target);
    const Decimation d = decimate(mesh, target, automatic());
    EXPECT_EQ(d.mesh.positions, kept.mesh.positions);
    EXPECT_EQ(d.mesh.faces, kept.mesh.faces);
    EXPECT_EQ(d.result.n_vanished_components, 0U);
  }
}

TEST(AutomaticTopology, LetsSmallPartsVanishFirst) {
  IndexedMesh small = boxes(4, 4);
  for (Vec3& p : small.positions) p = 0.01 * p + Vec3(5, 0, 0);
  const IndexedMesh mesh = joined(spheres(2, 3), small);
  for (const auto cost : {Cost::quadric, Cost::memoryless, Cost::lindstrom_turk, Cost::midpoint}) {
    DecimateOptions options = automatic();
    options.cost = cost;
    const Decimation d = decimate(mesh, DecimateTarget::faces(60), options);
    EXPECT_LE(d.result.n_faces, 60U);
    EXPECT_EQ(d.result.n_vanished_components, 16U) << to_string(cost);
    EXPECT_GT(decimate(mesh, DecimateTarget::faces(60), {.cost = cost}).result.n_faces, 60U);
  }
}

TEST(AutomaticTopology, KeepsAClosedManifoldClosed) {
  const IndexedMesh mesh = joined(boxes(3, 3), joined(torus(24, 6, 1.0, 0.1), spheres(3, 2)));
  for (const std::uint64_t n_faces : {200U, 100U, 40U, 10U}) {
    const Decimation d = decimate(mesh, DecimateTarget::faces(n_faces), automatic());
    const Topology after = topology(d.mesh);
    EXPECT_TRUE(after.closed()) << n_faces;
    EXPECT_TRUE(after.manifold()) << n_faces;
    EXPECT_EQ(after.misoriented_edges, 0) << n_faces;
    EXPECT_GT(after.components, 0U);
  }
}

/// The sides of a thin plate would cancel out once it is flat.
TEST(AutomaticTopology, KeepsAThinPlateOfAnOpenMesh) {
  IndexedMesh plate = tessellated_cube(6);
  for (Vec3& p : plate.positions) p = Vec3(10 * p.x(), 10 * p.y(), 1e-3 * p.z());
  IndexedMesh bumps = noisy_grid(40, 40, 0.3, 1);
  const IndexedMesh mesh = joined(plate, bumps);
  const Decimation d = decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 10), automatic());
  EXPECT_EQ(d.result.n_vanished_components, 0U);
}

TEST(NonmanifoldContraction, ResultsDoNotDependOnThreads) {
  const IndexedMesh mesh = spheres(3, 3, 0.02);
  DecimateOptions options = with_threshold(0.2);
  const DecimateTarget target = DecimateTarget::faces(200);
  options.threads = 1;
  const Decimation expected = decimate(mesh, target, options);
  EXPECT_GT(expected.result.threshold_pairs.contracted, 0U);
  for (const unsigned threads : {2U, 3U, 8U}) {
    options.threads = threads;
    const Decimation d = decimate(mesh, target, options);
    EXPECT_EQ(d.mesh.positions, expected.mesh.positions);
    EXPECT_EQ(d.mesh.faces, expected.mesh.faces);
  }
}

// Anything against brute force ----------------------------------------------------------------------------------------

/// Small random sets of triangles with random options.
struct RandomCase {
  explicit RandomCase(std::uint64_t seed) : random(seed) {
    mesh = random_mesh(seed);
    const auto n_faces = static_cast<int>(mesh.faces.size());
    if (one_in(4)) {
      for (Triangle& face : mesh.faces) {
        if (one_in(2)) std::swap(face[0], face[1]);
      }
    }
    for (int n = one_in(5) ? whole(1, 5) : 0; n > 0; --n) {
      Triangle face = mesh.faces[static_cast<std::size_t>(whole(0, n_faces - 1))];
      if (one_in(2)) std::swap(face[1], face[2]);
      mesh.faces.push_back(face);
    }
    for (int n = one_in(5) ? whole(1, 5) : 0; n > 0; --n) {
      const auto vertex = [&] {
        return static_cast<std::size_t>(whole(0, static_cast<int>(mesh.positions.size()) - 1));
      };
      const Vec3 place = mesh.positions[vertex()];
      mesh.positions[vertex()] = place;
    }
    set_options();
    if (one_in(2)) target = DecimateTarget::faces(static_cast<std::uint64_t>(whole(0, n_faces)));
  }

  void set_options() {
    set_constraints();
    set_cost();
    const bool is_plain =
        options.effective_cost() == Cost::quadric && options.isotropy == 0 && options.valence_weight == 0;
    if (!one_in(4) && is_plain) options.pairs.threshold = real(0.01, 2);
    options.pairs.max_pairs = static_cast<std::uint32_t>(one_in(3) ? whole(0, 6) : 32);
    if (options.pairs.max_pairs == 0) options.pairs.max_pairs.reset();
    options.pairs.across_walls = one_in(2);
    options.topology = one_in(2) ? whittle::Topology::free : whittle::Topology::keep;
    options.quadric.point_weight = std::pow(10, real(-6, 0));
  }

  void set_cost() {
    if (one_in(4)) options.quadric.placement = static_cast<Placement>(whole(0, 2));
    if (one_in(2)) return;
    options.cost = static_cast<Cost>(whole(0, static_cast<int>(all_cost_traits.size()) - 1));
    options.order = Order::exact;
    if (options.cost == Cost::quadric) options.isotropy = one_in(4) ? 1 : real(0, 1);
    if (one_in(2)) options.valence_weight = real(0, 4);
    const bool has_placements = cost_traits(*options.cost).why_not.placement.empty();
    if (!has_placements) options.quadric.placement = Placement::optimal;
  }

  void make_memoryless() {
    options.cost = Cost::memoryless;
    options.order = Order::exact;
    options.isotropy = 0;
    options.pairs.threshold.reset();
  }

  /// Triangles on a coarse lattice with straight feature lines, of which non-manifold contractions would take edges
  /// away.
  void make_lines() {
    for (Vec3& p : mesh.positions) p = Vec3(whole(0, 3), whole(0, 3), whole(0, 2));
    options = {};
    options.topology = whittle::Topology::free;
    options.max_normal_flip_deg = 180;
    options.feature_tolerance = 10;
    if (one_in(2)) options.pairs.threshold = real(0.3, 1.3);
    for (const Triangle& face : mesh.faces) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
        if (one_in(8)) options.feature_edges.push_back({a, b});
      }
    }
  }

  void set_constraints() {
    if (one_in(3)) options.max_normal_flip_deg = 180;
    if (one_in(4)) options.min_radius_ratio = real(0, 1);
    options.boundary = static_cast<Boundary>(whole(0, 2));
    if (one_in(5)) {
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) locked.push_back(one_in(5));
      options.locked = locked;
    }
    if (one_in(4)) options.feature_angle_deg = real(5, 180);
    if (one_in(4)) {
      for (const Triangle& face : mesh.faces) {
        if (one_in(6)) features.push_back({face[0], face[1]});
      }
      options.feature_edges = features;
    }
    options.feature_tolerance = std::pow(10, real(-3, 1));
  }

  IndexedMesh random_mesh(std::uint64_t seed) {
    switch (whole(0, 5)) {
      case 0:
        return noisy_sphere(1, 0.2, seed);
      case 1:
        return shaken(soup(noisy_grid(4, 4, 0.3, seed)), 1e-3);
      case 2:
        return shaken(boxes(2, 2, real(0.01, 1.5)), 1e-2);
      case 3:
        return shaken(tessellated_cube(whole(2, 3)), one_in(2) ? 1e-2 : 1e-5);
      case 4:
        return joined(noisy_sphere(1, 0.2, seed), glued(spheres(2, 1, 0.0)));
      default:
        return random_triangles();
    }
  }

  IndexedMesh random_triangles() {
    IndexedMesh result;
    const int n = whole(5, 18);
    for (int i = 0; i < n; ++i) result.positions.emplace_back(real(-1, 1), real(-1, 1), real(-1, 1));
    const auto vertex = [&] { return static_cast<Index>(whole(0, n - 1)); };
    for (int i = whole(3, 40); i > 0; --i) result.faces.push_back({vertex(), vertex(), vertex()});
    return result;
  }

  IndexedMesh shaken(IndexedMesh result, double amplitude) {
    for (Vec3& p : result.positions) p += amplitude * Vec3(real(-1, 1), real(-1, 1), real(-1, 1));
    return result;
  }

  double real(double low, double high) { return std::uniform_real_distribution<>(low, high)(random); }
  int whole(int low, int high) { return std::uniform_int_distribution<>(low, high)(random); }
  bool one_in(int n) { return whole(1, n) == 1; }

  std::mt19937_64 random;
  IndexedMesh mesh;
  DecimateOptions options;
  std::vector<std::uint8_t> locked;
  std::vector<VertexPair> features;
  DecimateTarget target = DecimateTarget::as_far_as_possible();
};

std::vector<Triangle> in_one_order(std::vector<Triangle> faces) {
  for (Triangle& face : faces) std::rotate(face.begin(), std::ranges::min_element(face), face.end());
  std::ranges::sort(faces);
  return faces;
}

/// In the input's vertex numbers.
std::vector<std::pair<Index, Index>> features_of(const Decimation& d) {
  std::vector<std::pair<Index, Index>> features;
  for (const auto& [a, b] : d.feature_edges) features.push_back(std::minmax(d.mesh.origins[a], d.mesh.origins[b]));
  std::ranges::sort(features);
  return features;
}

class RandomTriangles : public testing::Test {
 protected:
  void expect_as_by_brute_force(RandomCase& c) {
    std::vector<Contraction> found;
    c.options.hold_folds = true;
    c.options.listener = [&](const Contraction& contraction) { found.push_back(contraction); };
    BruteForceDecimater brute_force(c.mesh, c.options);
    const std::vector<Contraction> expected = brute_force.run(c.target);
    const Decimation d = decimate(c.mesh, c.target, c.options);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_EQ(found[i].survivor, expected[i].survivor) << i;
      ASSERT_EQ(found[i].removed, expected[i].removed) << i;
      if (c.options.topology == whittle::Topology::automatic) {  // costs of faces are summed in another order
        ASSERT_DOUBLE_EQ(found[i].cost, expected[i].cost) << i;
      } else {
        ASSERT_EQ(found[i].cost, expected[i].cost) << i;
      }
      ASSERT_EQ(found[i].position, expected[i].position) << i;
    }
    std::vector<Triangle> faces;
    for (const auto& [a, b, v] : d.mesh.faces) {
      faces.push_back({d.mesh.origins[a], d.mesh.origins[b], d.mesh.origins[v]});
    }
    EXPECT_EQ(in_one_order(faces), in_one_order(brute_force.faces()));
    EXPECT_EQ(d.result.n_faces, brute_force.n_faces());
    EXPECT_EQ(features_of(d), brute_force.feature_edges());
    EXPECT_EQ(d.result.n_vertices, brute_force.n_vertices());
    n_joined_ += d.result.threshold_pairs.contracted;
    n_coincident_ += d.result.n_coincident_faces;
    n_features_ += d.feature_edges.size();
    n_vanished_ += d.result.n_vanished_components;
  }

  /// \param prepare changes each case before it is run
  template <class Prepare>
  void expect_all_as_by_brute_force(std::uint64_t first_seed, std::uint64_t end_seed, const Prepare& prepare) {
    for (std::uint64_t seed = first_seed; seed < end_seed; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      RandomCase c(seed);
      prepare(c);
      expect_as_by_brute_force(c);
      if (HasFatalFailure()) return;
    }
  }

  std::uint64_t n_joined_ = 0;
  std::uint64_t n_coincident_ = 0;
  std::uint64_t n_features_ = 0;
  std::uint64_t n_vanished_ = 0;
};

TEST_F(RandomTriangles, AreContractedAsByBruteForce) {
  expect_all_as_by_brute_force(0, 500, [](RandomCase&) {});
  EXPECT_GT(n_joined_, 1000U);  // make sure that the test meets non-manifold contractions
  EXPECT_GT(n_coincident_, 900U);
  EXPECT_GT(n_features_, 1000U);
}

TEST_F(RandomTriangles, AreContractedAsByBruteForceWithoutMemory) {
  expect_all_as_by_brute_force(500, 1000, [](RandomCase& c) { c.make_memoryless(); });
  EXPECT_GT(n_coincident_, 200U);
  EXPECT_GT(n_features_, 1000U);
}

TEST_F(RandomTriangles, WhichMayVanishAreContractedAsByBruteForce) {
  expect_all_as_by_brute_force(1200, 1700, [](RandomCase& c) {
    if (c.options.effective_cost() == Cost::quadric) c.make_memoryless();
    c.options.topology = whittle::Topology::automatic;
  });
  EXPECT_GT(n_vanished_, 100U);
  EXPECT_GT(n_coincident_, 300U);
}

TEST_F(RandomTriangles, WithStraightLinesAreContractedAsByBruteForce) {
  expect_all_as_by_brute_force(1000, 1200, [](RandomCase& c) {
    c.mesh = c.random_triangles();
    c.make_lines();
  });
  EXPECT_GT(n_coincident_, 200U);
  EXPECT_GT(n_features_, 500U);
}

}  // namespace
}  // namespace whittle::test
