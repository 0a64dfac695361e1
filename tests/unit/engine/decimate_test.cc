#include "whittle/engine/decimate.hh"
#include "whittle/core/feature_edges.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <whittle/metrics/shape.hh>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

TEST(Decimate, StopsAtTheFirstCountNotAboveTheTarget) {
  const IndexedMesh mesh = blob(3, 1);  // closed: faces vanish in twos
  for (const std::uint64_t target : {1279U, 1001U, 1000U, 300U, 51U}) {
    const Decimation d = decimate(mesh, DecimateTarget::faces(target));
    EXPECT_EQ(d.result.n_faces, target - target % 2) << "target " << target;
    EXPECT_EQ(d.mesh.faces.size(), d.result.n_faces);
    EXPECT_EQ(d.mesh.positions.size(), d.result.n_vertices);
    EXPECT_EQ(d.result.n_vertices, 2 + d.result.n_faces / 2);
    EXPECT_EQ(d.result.stop, StopReason::target);
    EXPECT_EQ(d.result.n_contractions, mesh.positions.size() - d.result.n_vertices);
  }
  for (const std::uint64_t target : {641U, 500U, 37U}) {
    EXPECT_EQ(decimate(mesh, DecimateTarget::vertices(target)).result.n_vertices, target);
  }
}

TEST(Decimate, DoesNothingWhereTheTargetIsMetAlready) {
  const IndexedMesh mesh = terrain(8, 1);
  const Decimation d = decimate(mesh, DecimateTarget::faces(mesh.faces.size()));
  EXPECT_EQ(d.result.n_contractions, 0U);
  EXPECT_EQ(d.mesh.faces, mesh.faces);
  EXPECT_EQ(d.mesh.positions, mesh.positions);
}

TEST(DecimateResult, SaysThatNothingHappenedBeforeARun) {
  const DecimateResult result;
  EXPECT_EQ(result.n_contractions + result.n_vertices + result.n_faces, 0U);
  EXPECT_EQ(result.n_degenerate_faces + result.n_coincident_faces + result.n_vanished_components, 0U);
  EXPECT_EQ(result.max_cost, 0);
  EXPECT_EQ(result.refusals.total() + result.refused_at_end.total(), 0U);
  EXPECT_EQ(result.threshold_pairs.considered + result.threshold_pairs.contracted, 0U);
  EXPECT_EQ(result.threshold_pairs.threshold, 0);
  EXPECT_FALSE(result.threshold_pairs.capped);
  for (const SurfaceCounts& counts : {result.before, result.after}) {
    EXPECT_EQ(counts.components + counts.nonmanifold_edges + counts.nonmanifold_vertices, 0U);
  }
  EXPECT_TRUE(result.warnings.empty());
}

TEST(Decimate, TakesTheFirstTargetReached) {
  const IndexedMesh mesh = blob(3, 2);
  EXPECT_EQ(decimate(mesh, DecimateTarget::faces(200).or_vertices(400)).result.n_vertices, 400U);
  EXPECT_EQ(decimate(mesh, DecimateTarget::faces(900).or_vertices(20)).result.n_faces, 900U);
}

TEST(Decimate, RespectsTheCostLimit) {
  const IndexedMesh mesh = blob(3, 3);
  std::vector<double> costs;
  DecimateOptions options;
  options.listener = [&](const Contraction& c) { costs.push_back(c.cost); };
  decimate(mesh, DecimateTarget::faces(100), options);
  const double limit = costs[costs.size() / 2];
  const Decimation d = decimate(mesh, DecimateTarget::max_cost(limit));
  EXPECT_EQ(d.result.stop, StopReason::cost);
  EXPECT_LE(d.result.max_cost, limit);
  EXPECT_GT(d.result.n_contractions, costs.size() / 4);
  EXPECT_EQ(decimate(mesh, DecimateTarget::max_cost(0.0)).result.n_contractions, 0U);
}

TEST(StopReason, HasAName) {
  EXPECT_EQ(to_string(StopReason::target), "target");
  EXPECT_EQ(to_string(StopReason::cost), "cost");
  EXPECT_EQ(to_string(StopReason::exhausted), "exhausted");
  EXPECT_EQ(to_string(StopReason::cancelled), "cancelled");
}

TEST(Decimate, GoesAsFarAsTheGuardsAllowIfAsked) {
  const Decimation d = decimate(blob(3, 4), DecimateTarget::as_far_as_possible());
  EXPECT_EQ(d.result.stop, StopReason::exhausted);
  EXPECT_GE(d.result.n_faces, 4U);
  EXPECT_GT(d.result.refusals[Refusal::link] + d.result.refusals[Refusal::flip], 0U);
  EXPECT_TRUE(topology(d.mesh).closed());
}

TEST(Decimate, FlatGroundKeepsItsOutline) {
  const Decimation d = decimate(grid(20, 10), DecimateTarget::faces(2));
  EXPECT_EQ(d.result.n_faces, 2U);
  EXPECT_NEAR(surface_area(d.mesh), 200, 200 * 1e-8);  // the regularisation, 1e-9, pulls corners inwards
}

TEST(Decimate, TessellatedCubeBecomesTheCube) {
  const Decimation d = decimate(tessellated_cube(8), DecimateTarget::faces(12));
  ASSERT_EQ(d.result.n_faces, 12U);
  for (const Vec3& p : d.mesh.positions) {
    EXPECT_NEAR(p.cwiseAbs().minCoeff(), 1, 1e-6);
    EXPECT_NEAR(p.cwiseAbs().maxCoeff(), 1, 1e-6);
  }
  EXPECT_NEAR(signed_volume(d.mesh), 8, 1e-5);
}

TEST(Decimate, KeepsTheTopologyOfEveryManifoldMesh) {
  std::vector<NamedMesh> meshes = closed_meshes();
  for (NamedMesh& m : open_meshes()) meshes.push_back(std::move(m));
  for (const auto& [name, mesh] : meshes) {
    SCOPED_TRACE(name);
    const Topology before = topology(mesh);
    for (const double ratio : {0.5, 0.2, 0.0}) {
      SCOPED_TRACE(ratio);
      const auto target = static_cast<std::uint64_t>(ratio * static_cast<double>(mesh.faces.size()));
      const Topology after = topology(decimate(mesh, DecimateTarget::faces(target)).mesh);
      EXPECT_EQ(after.euler(), before.euler());
      EXPECT_EQ(after.components, before.components);
      EXPECT_EQ(after.border_loops, before.border_loops);
      if (before.misoriented_edges == 0) {
        EXPECT_EQ(after.misoriented_edges, 0);
      }
      EXPECT_TRUE(after.manifold());
    }
  }
}

TEST(Decimate, NeverMakesANonManifoldMeshWorse) {
  for (const auto& [name, mesh] : nonmanifold_meshes()) {
    SCOPED_TRACE(name);
    const Topology before = topology(mesh);
    const Topology after = topology(decimate(mesh, DecimateTarget::as_far_as_possible()).mesh);
    EXPECT_LE(after.nonmanifold_edges, before.nonmanifold_edges);
    EXPECT_LE(after.nonmanifold_vertices, before.nonmanifold_vertices);
    EXPECT_LE(after.border_edges, before.border_edges);
    EXPECT_EQ(after.components, before.components);  // duplicate faces may vanish, which changes the Euler number
  }
}

TEST(Decimate, LockedVerticesKeepEveryBit) {
  Random random(1);
  for (const auto& [name, mesh] : all_meshes()) {
    SCOPED_TRACE(name);
    std::vector<std::uint8_t> locked(mesh.positions.size());
    for (auto& l : locked) l = random.below(3) == 0;
    DecimateOptions options;
    options.locked = locked;
    const Decimation d = decimate(mesh, DecimateTarget::as_far_as_possible(), options);
    for (Index v = 0; v < locked.size(); ++v) {
      if (!locked[v] || d.vertex_map[v] == invalid_index) continue;
      EXPECT_EQ(d.mesh.positions[d.vertex_map[v]], mesh.positions[v]);
      EXPECT_EQ(d.mesh.origins[d.vertex_map[v]], v);
    }
  }
}

TEST(Decimate, LockedBordersKeepEveryBit) {
  DecimateOptions options;
  options.boundary = Boundary::locked;
  const IndexedMesh mesh = moved(terrain(16, 2), {1e5, -3e4, 7});
  const Decimation d = decimate(mesh, DecimateTarget::faces(100), options);
  EXPECT_EQ(topology(d.mesh).border_edges, topology(mesh).border_edges);
  std::size_t n_border = 0;
  for (std::size_t v = 0; v < d.mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[d.mesh.origins[v]];
    const Vec3 at = p - Vec3(1e5, -3e4, 7);
    const auto is_side = [](double x) { return x < 1e-9 || x > 1 - 1e-9; };
    if (!is_side(at.x()) && !is_side(at.y())) continue;
    ++n_border;
    EXPECT_EQ(d.mesh.positions[v], p);
  }
  EXPECT_EQ(n_border, 64U);
}

/// A sheet with a flange: the plane z = 0 up to x = 5, and from there upwards.
IndexedMesh sheet_with_flange() {
  IndexedMesh mesh = grid(6, 6);
  for (Vec3& p : mesh.positions) {
    if (p.x() > 5) p = Vec3(5, p.y(), p.x() - 5);
  }
  return mesh;
}

TEST(Decimate, FeatureEdgesDoNotBecomeBorders) {
  for (const Placement placement : {Placement::optimal, Placement::midpoint, Placement::endpoint}) {
    DecimateOptions options;
    options.feature_angle_deg = 40;
    options.boundary = Boundary::free;
    options.max_normal_flip_deg = 180;
    options.quadric.placement = placement;
    const Decimation d = decimate(sheet_with_flange(), DecimateTarget::as_far_as_possible(), options);
    EXPECT_GT(d.result.n_contractions, 0U);
    EXPECT_FALSE(d.feature_edges.empty());
    EXPECT_EQ(feature_edges(d.mesh, 40), d.feature_edges);
  }
}

/// Where free topology lets a vertex of three faces vanish with them, say.
TEST(Decimate, FeatureLinesDoNotVanishUnderFreeTopology) {
  for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
    DecimateOptions options;
    options.cost = cost;
    options.feature_angle_deg = 30;
    options.topology = whittle::Topology::free;
    for (const IndexedMesh& mesh : {noisy_grid(24, 24, 0.4, 1), noisy_grid(24, 24, 0.5, 2), terrain(24, 3)}) {
      const Decimation d = decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 10), options);
      std::vector<int> n_edges(mesh.positions.size());
      for (const auto& [a, b] : feature_edges(mesh, 30)) {
        ++n_edges[a];
        ++n_edges[b];
      }
      std::set<Index> on_lines;
      for (const auto& [a, b] : d.feature_edges) on_lines.insert({d.mesh.origins[a], d.mesh.origins[b]});
      ASSERT_GT(std::ranges::count(n_edges, 1), 2);
      for (Index v = 0; v < n_edges.size(); ++v) {
        EXPECT_TRUE(n_edges[v] != 1 || on_lines.contains(v)) << "end of a line";
      }
    }
  }
}

TEST(Decimate, UnmovedVerticesKeepEveryBit) {
  IndexedMesh mesh = tessellated_cube(3);
  mesh.positions[0].x() = 1e140;
  mesh.positions[5].y() = -0.0;
  mesh.positions[6].z() = 1e-200;  // vanishes beside 1e140
  DecimateOptions options;
  options.locked.resize(mesh.positions.size(), 1);
  const Decimation d = decimate(mesh, DecimateTarget::faces(4), options);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(d.mesh.positions[v][axis]),
                std::bit_cast<std::uint64_t>(mesh.positions[v][axis]));
    }
  }
}

TEST(Decimate, TheGreatestCostOfAHugeMeshIsANumber) {
  for (const CostTraits& traits : all_cost_traits) {
    const Cost cost = traits.cost;
    DecimateOptions options;
    options.cost = cost;
    EXPECT_EQ(decimate(scaled(tetrahedron(), 1e140), DecimateTarget::faces(1), options).result.max_cost, 0)
        << to_string(cost);
    EXPECT_FALSE(std::isnan(decimate(scaled(grid(4, 4), 1e140), DecimateTarget::faces(8), options).result.max_cost))
        << to_string(cost);
  }
}

/// Closed, open and not manifold; far from the origin.
std::vector<NamedMesh> endpoint_meshes() {
  std::vector<NamedMesh> meshes = {{"torus", torus(24, 12)},    {"noisy torus", noisy_torus(24, 12, 1, 0.35, 0.02, 1)},
                                   {"blob", blob(3, 5)},        {"bracket", bracket(4)},
                                   {"terrain", terrain(16, 3)}, {"cubes on an edge", two_cubes_on_an_edge(4)},
                                   {"book", book(3, 12)}};
  for (NamedMesh& m : meshes) m.mesh = moved(scaled(m.mesh, 1.0 / 3), {12.3, -45.6, 1e4});
  return meshes;
}

std::vector<DecimateOptions> endpoint_options() {
  std::vector<DecimateOptions> all(6);
  all[1].cost = Cost::memoryless;
  all[2].feature_angle_deg = 40;
  all[3].pairs.threshold = 0.05;
  all[3].topology = whittle::Topology::free;
  all[4].isotropy = 0.5;
  all[5].isotropy = 1;
  for (DecimateOptions& options : all) options.quadric.placement = Placement::endpoint;
  return all;
}

TEST(Decimate, UnderEndpointPlacementEachVertexLiesAtItsOrigin) {
  for (const auto& entry : endpoint_meshes()) {  // no structured binding: Clang 14 can't capture one
    const IndexedMesh& mesh = entry.mesh;
    SCOPED_TRACE(entry.name);
    std::size_t n_lower = 0;  // number of survivors with the lower number
    for (DecimateOptions options : endpoint_options()) {
      options.listener = [&](const Contraction& c) {
        EXPECT_EQ(c.position, mesh.positions[c.survivor]);
        n_lower += c.survivor < c.removed;
      };
      const Decimation d = decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 4), options);
      EXPECT_GT(d.result.n_contractions, 0U);
      EXPECT_TRUE(std::ranges::is_sorted(d.mesh.origins));
      for (std::size_t v = 0; v < d.mesh.positions.size(); ++v) {
        ASSERT_EQ(d.mesh.positions[v], mesh.positions[d.mesh.origins[v]]) << "vertex " << v;
        EXPECT_EQ(d.vertex_map[d.mesh.origins[v]], v);
      }
      for (std::size_t f = 0; f < d.mesh.faces.size(); ++f) {
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_EQ(d.mesh.faces[f][i], d.vertex_map[mesh.faces[d.face_origins[f]][i]]);
        }
      }
    }
    EXPECT_GT(n_lower, 0U);
  }
}

TEST(Decimate, UnderEndpointPlacementTheThreadsChangeNoOrigin) {
  for (const auto& [name, mesh] : endpoint_meshes()) {
    DecimateOptions options;
    options.quadric.placement = Placement::endpoint;
    options.threads = 1;
    const Decimation one = decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 4), options);
    options.threads = 3;
    const Decimation three = decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 4), options);
    EXPECT_EQ(one.mesh.origins, three.mesh.origins) << name;
    EXPECT_EQ(one.mesh.positions, three.mesh.positions) << name;
    EXPECT_EQ(one.mesh.faces, three.mesh.faces) << name;
  }
}

TEST(Decimate, GreaterRegularizationMakesRounderTriangles) {
  const IndexedMesh mesh = blob(4, 8);
  double before = 0;
  for (const double regularization : {1e-9, 4e-3, 1e-1}) {
    DecimateOptions options;
    options.quadric.regularization = regularization;
    const double radius_ratio =
        metrics::shape(decimate(mesh, DecimateTarget::faces(512), options).mesh).radius_ratio_mean;
    EXPECT_GT(radius_ratio, before + 0.02) << regularization;
    before = radius_ratio;
  }
}

TEST(Decimate, VertexMapIsTotalAndSaysWhoMerged) {
  const IndexedMesh mesh = with_isolated_vertices(blob(3, 6), 40, 1);
  std::vector<Index> into(mesh.positions.size());
  for (Index v = 0; v < into.size(); ++v) into[v] = v;
  DecimateOptions options;
  options.listener = [&](const Contraction& c) {
    for (Index& r : into) {
      if (r == c.removed) r = c.survivor;
    }
  };
  const Decimation d = decimate(mesh, DecimateTarget::faces(200), options);
  std::set<Index> used;
  for (const Triangle& f : mesh.faces) used.insert(f.begin(), f.end());
  ASSERT_EQ(d.vertex_map.size(), mesh.positions.size());
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (used.contains(v)) {
      EXPECT_EQ(d.mesh.origins[d.vertex_map[v]], into[v]);
    } else {
      EXPECT_EQ(d.vertex_map[v], invalid_index);
    }
  }
  EXPECT_TRUE(std::is_sorted(d.mesh.origins.begin(), d.mesh.origins.end()));
}

TEST(Decimate, OriginsGoThroughFromTheInput) {
  IndexedMesh mesh = blob(2, 7);
  for (Index v = 0; v < mesh.positions.size(); ++v) mesh.origins.push_back(3 * v + 5);
  const Decimation d = decimate(mesh, DecimateTarget::faces(100));
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (d.mesh.origins[d.vertex_map[v]] == mesh.origins[v]) return;  // true of every vertex that survives
  }
  FAIL() << "no origin of the input is left";
}

TEST(Decimate, LeavesOutDegenerateFacesAndCountsThem) {
  IndexedMesh mesh = blob(1, 8);
  mesh.faces.insert(mesh.faces.begin() + 3, Triangle{4, 4, 7});
  mesh.faces.push_back({1, 2, 1});
  const Decimation d = decimate(mesh, DecimateTarget::faces(80));
  EXPECT_EQ(d.result.n_degenerate_faces, 2U);
  EXPECT_EQ(d.result.n_faces, 80U);
}

TEST(Decimate, TakesAnyValence) {
  for (const int n : {14, 15, 16, 17, 400}) {
    const Decimation d = decimate(uv_sphere(8, n), DecimateTarget::faces(100));
    EXPECT_EQ(d.result.n_faces, 100U) << n;
    EXPECT_EQ(topology(d.mesh).euler(), 2) << n;
  }
  EXPECT_EQ(decimate(cone(3000), DecimateTarget::faces(300)).result.n_faces, 300U);
}

TEST(Decimate, TakesEmptyAndTinyMeshes) {
  EXPECT_EQ(decimate(IndexedMesh{}, DecimateTarget::faces(0)).mesh.faces.size(), 0U);
  EXPECT_EQ(decimate(single_triangle(), DecimateTarget::faces(0)).mesh.faces.size(), 1U);
  EXPECT_EQ(decimate(tetrahedron(), DecimateTarget::faces(0)).mesh.faces.size(), 4U);
  IndexedMesh point = single_triangle();
  for (Vec3& p : point.positions) p = Vec3(1, 2, 3);
  EXPECT_EQ(decimate(point, DecimateTarget::faces(0)).mesh.faces.size(), 1U);
}

TEST(Decimate, CanBeCancelled) {
  const IndexedMesh mesh = blob(4, 9);
  DecimateOptions options;
  int n_calls = 0;
  double fraction = -1;
  options.progress = [&](const Progress& p) {
    EXPECT_GE(p.fraction, fraction);
    EXPECT_LE(p.fraction, 1);
    fraction = p.fraction;
    if (p.n_faces < mesh.faces.size()) ++n_calls;
    return n_calls == 0;
  };
  const Decimation d = decimate(mesh, DecimateTarget::faces(4), options);
  EXPECT_EQ(d.result.stop, StopReason::cancelled);
  EXPECT_EQ(n_calls, 1) << "not asked again";
  EXPECT_LT(d.result.n_faces, mesh.faces.size());
  EXPECT_GT(d.result.n_faces, 100U);
  EXPECT_EQ(topology(d.mesh).euler(), 2);
}

TEST(Decimate, CanBeCancelledWhileThresholdPairsAreSearched) {
  const IndexedMesh mesh = spheres(2, 3, 0.1);
  DecimateOptions options;
  options.pairs.threshold = 0.2;
  for (const int n_allowed : {0, 1}) {
    int n_calls = 0;
    options.progress = [&](const Progress&) { return ++n_calls <= n_allowed; };
    const Decimation d = decimate(mesh, DecimateTarget::faces(4), options);
    EXPECT_EQ(d.result.stop, StopReason::cancelled);
    EXPECT_EQ(n_calls, n_allowed + 1) << "not asked again";
    EXPECT_EQ(d.mesh.faces, mesh.faces);
  }
}

/// Why `decimate` refuses that; "accepted" if it doesn't.
std::string refused(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options) {
  try {
    decimate(mesh, target, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Decimate, RefusesAttributesThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  IndexedMesh mesh = tetrahedron();
  for (const AttributeKind kind : {AttributeKind::texcoord, AttributeKind::normal, AttributeKind::tangent,
                                   AttributeKind::color, AttributeKind::displacement, AttributeKind::direction}) {
    mesh.attributes = {{"a", kind, 2, {0, 0, 0, 0, 0, nan, 0, 0}}};
    EXPECT_EQ(refused(mesh, DecimateTarget::faces(2), {}), "decimate: value 2 of attribute a is not finite");
  }
  for (const AttributeKind kind : {AttributeKind::scalar, AttributeKind::category}) {
    mesh.attributes = {{"a", kind, 1, {0, nan, 0, 0}}};
    EXPECT_EQ(refused(mesh, DecimateTarget::faces(2), {}), "accepted") << "what was not measured";
  }
  mesh = tetrahedron();
  mesh.normals.assign(4, {0, 0, 1});
  mesh.normals[3][1] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refused(mesh, DecimateTarget::faces(2), {}), "decimate: normal 3 is not finite");
}

TEST(Decimate, RefusesWhatIsNoMeshOrNoOption) {
  IndexedMesh mesh = tetrahedron();
  mesh.faces[2][1] = 4;
  EXPECT_EQ(refused(mesh, DecimateTarget::faces(2), {}), "decimate: face 2 names vertex 4 of 4");
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 0x1p501}) {
    mesh = tetrahedron();
    mesh.positions[1].y() = x;
    EXPECT_EQ(refused(mesh, DecimateTarget::faces(2), {}),
              "decimate: vertex 1 has a coordinate that is not finite, or above 3e150");
  }
  mesh = tetrahedron();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refused(mesh, DecimateTarget::max_cost(-1), {}), "accepted");
  EXPECT_NE(refused(mesh, DecimateTarget::max_cost(nan), {}), "accepted");
  EXPECT_NE(refused(mesh, DecimateTarget::max_cost(std::numeric_limits<double>::infinity()), {}), "accepted");
  for (const double flip : {0.0, -5.0, 180.1, nan}) {
    DecimateOptions options;
    options.max_normal_flip_deg = flip;
    EXPECT_NE(refused(mesh, DecimateTarget::faces(2), options), "accepted") << flip;
  }
  for (const double bad : {-1e-9, nan}) {
    DecimateOptions options;
    options.quadric.regularization = bad;
    EXPECT_NE(refused(mesh, DecimateTarget::faces(2), options), "accepted") << bad;
    options = {};
    options.quadric.boundary_weight = bad;
    EXPECT_NE(refused(mesh, DecimateTarget::faces(2), options), "accepted") << bad;
  }
  const std::vector<std::uint8_t> locked(3);
  DecimateOptions options;
  options.locked = locked;
  EXPECT_NE(refused(mesh, DecimateTarget::faces(2), options), "accepted");
  for (const VertexPair& edge : {VertexPair{0, 4}, VertexPair{invalid_index, 1}}) {
    options = {};
    options.feature_edges = {{0, 1}, edge};
    EXPECT_EQ(refused(mesh, DecimateTarget::faces(2), options),
              "decimate: a feature edge names a vertex that isn't there");
  }
}

}  // namespace
}  // namespace whittle::test
