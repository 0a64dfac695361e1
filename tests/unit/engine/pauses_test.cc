#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/core/feature_edges.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/topology.hh"
#include "whittle/simplify/simplify.hh"

// A run that pauses on its way.

namespace whittle::test {
namespace {

/// Pauses in which nothing is done.
Pauses idle(std::vector<double> at) {
  return {std::move(at), [](Decimation&) { return true; }};
}

struct PauseSetting {
  std::string name;
  DecimateOptions options;
};

/// In exact order a run depends on the surface, and on what is remembered about it, and on nothing else.
std::vector<PauseSetting> settings_with_pauses() {
  std::vector<PauseSetting> settings;
  const auto add = [&settings](const std::string& name, const auto& change) {
    DecimateOptions options;
    options.order = Order::exact;
    change(options);
    settings.push_back({name, options});
  };
  add("quadrics", [](DecimateOptions&) {});
  add("Lindstrom-Turk", [](DecimateOptions& o) { o.cost = Cost::lindstrom_turk; });
  add("midpoint", [](DecimateOptions& o) { o.cost = Cost::midpoint; });
  add("isotropic", [](DecimateOptions& o) { o.isotropy = 0.4; });
  add("valences", [](DecimateOptions& o) { o.valence_weight = 1; });
  add("locked borders", [](DecimateOptions& o) { o.boundary = Boundary::locked; });
  add("features", [](DecimateOptions& o) { o.feature_angle_deg = 30; });
  add("features, loosely", [](DecimateOptions& o) {
    o.feature_angle_deg = 50;
    o.feature_tolerance = 0.05;
  });
  add("no intersections", [](DecimateOptions& o) { o.refuse_intersections = true; });
  return settings;
}

void expect_same(const Decimation& a, const Decimation& b, const std::string& context) {
  EXPECT_EQ(a.mesh.positions, b.mesh.positions) << context;
  EXPECT_EQ(a.mesh.faces, b.mesh.faces) << context;
  EXPECT_EQ(a.mesh.origins, b.mesh.origins) << context;
  EXPECT_EQ(a.vertex_map, b.vertex_map) << context;
  EXPECT_EQ(a.face_origins, b.face_origins) << context;
  EXPECT_EQ(a.feature_edges, b.feature_edges) << context;
  EXPECT_EQ(a.result.n_contractions, b.result.n_contractions) << context;
  EXPECT_EQ(a.result.max_cost, b.result.max_cost) << context;
  EXPECT_EQ(a.result.stop, b.result.stop) << context;
  EXPECT_EQ(a.result.before.nonmanifold_edges, b.result.before.nonmanifold_edges) << context;
  EXPECT_EQ(a.result.after.nonmanifold_vertices, b.result.after.nonmanifold_vertices) << context;
}

TEST(Pauses, InWhichNothingIsDoneChangeNothing) {
  for (const auto& [name, mesh] : all_meshes()) {
    for (PauseSetting setting : settings_with_pauses()) {
      SCOPED_TRACE(name + ", " + setting.name);
      const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 4);
      std::vector<Contraction> made;
      setting.options.listener = [&made](const Contraction& c) { made.push_back(c); };
      const Decimation expected = decimate(mesh, target, setting.options);
      const std::vector<Contraction> expected_made = std::exchange(made, {});
      setting.options.pauses = idle({3, 2, 1.2});
      expect_same(decimate(mesh, target, setting.options), expected, "");
      ASSERT_EQ(made.size(), expected_made.size());
      for (std::size_t i = 0; i < made.size(); ++i) {
        ASSERT_EQ(made[i].survivor, expected_made[i].survivor) << i;
        ASSERT_EQ(made[i].removed, expected_made[i].removed) << i;
      }
    }
  }
}

/// Memoryless quadrics are summed anew, in another order. What vertices remember of borders, seams and folds isn't.
TEST(Pauses, InWhichNothingIsDoneChangeMemorylessQuadricsByRounding) {
  const std::vector<NamedMesh> meshes{{"blob", blob(3, 5)},
                                      {"terrain", terrain(14, 5)},
                                      {"torus", noisy_torus(30, 16, 1, 0.35, 0.03, 1)},
                                      {"grid", noisy_grid(16, 14, 0.3, 4)},
                                      {"seams", tiled_torus(48, 24, 6)},
                                      {"folds", two_sided_leaf(13)}};
  for (const auto& [name, mesh] : meshes) {
    for (const double valence_weight : {0.0, 1e-12, 0.5}) {
      SCOPED_TRACE(name + ", " + std::to_string(valence_weight));
      DecimateOptions options;
      options.cost = Cost::memoryless;
      options.order = Order::exact;
      options.valence_weight = valence_weight;
      options.hold_folds = true;
      const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 5);
      const Decimation expected = decimate(mesh, target, options);
      options.pauses = idle({3, 2, 1.2});
      const Decimation d = decimate(mesh, target, options);
      EXPECT_EQ(d.mesh.faces, expected.mesh.faces);
      EXPECT_EQ(d.vertex_map, expected.vertex_map);
      for (std::size_t v = 0; v < d.mesh.positions.size(); ++v) {
        EXPECT_LT((d.mesh.positions[v] - expected.mesh.positions[v]).norm(), 1e-7);
      }
    }
  }
}

TEST(Pauses, ShowTheMeshOnItsWay) {
  const IndexedMesh mesh = bracket(6);
  std::vector<std::size_t> seen;
  DecimateOptions options;
  options.feature_angle_deg = 40;
  options.pauses = {{2, 1.5}, [&](Decimation& paused) {
                      seen.push_back(paused.mesh.faces.size());
                      EXPECT_EQ(paused.mesh.origins.size(), paused.mesh.positions.size());
                      EXPECT_EQ(paused.face_origins.size(), paused.mesh.faces.size());
                      EXPECT_FALSE(paused.feature_edges.empty());
                      EXPECT_EQ(paused.vertex_map.size(), mesh.positions.size());
                      for (const Index v : paused.vertex_map) EXPECT_LT(v, paused.mesh.positions.size());
                      EXPECT_EQ(metrics::topology(paused.mesh).genus, metrics::topology(mesh).genus);
                      return true;
                    }};
  const std::size_t n = mesh.faces.size() / 5;
  const Decimation d = decimate(mesh, DecimateTarget::faces(n), options);
  EXPECT_EQ(d.result.stop, StopReason::target);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_LE(seen[0], 2 * n);
  EXPECT_GE(seen[0], 2 * n - 2);
  EXPECT_LE(seen[1], (3 * n + 1) / 2);
  EXPECT_GE(seen[1], (3 * n + 1) / 2 - 2);
}

/// Planes that vertices remember stay where they are when the vertices move. So if all vertices leave their places in
/// the first pause and come back in the second, nothing has changed.
TEST(Pauses, LeaveTheRememberedPlanesWhereTheyAre) {
  for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
    DecimateOptions options;
    options.cost = cost;
    options.order = Order::exact;
    const IndexedMesh mesh = terrain(20, 3);
    const DecimateTarget target = DecimateTarget::faces(100);
    const Decimation expected = decimate(mesh, target, options);
    double height = 0.25;
    options.pauses = {{2.0001, 2}, [&height](Decimation& paused) {  // one contraction between them at most
                        for (Vec3& p : paused.mesh.positions) p.z() += height;
                        height = -height;
                        return true;
                      }};
    const Decimation d = decimate(mesh, target, options);
    const double after = metrics::surface_distance(mesh, d.mesh, {.samples = 50'000}).mean;
    const double before = metrics::surface_distance(mesh, expected.mesh, {.samples = 50'000}).mean;
    EXPECT_NEAR(after, before, 0.03 * before);
  }
}

TEST(Pauses, GoOnFromWhereVerticesHaveGone) {
  const IndexedMesh mesh = blob(4, 2);
  const Vec3 offset(0, 0, 100);
  DecimateOptions options;
  options.cost = Cost::memoryless;
  options.pauses = {{2}, [&offset](Decimation& paused) {
                      for (Vec3& p : paused.mesh.positions) p += offset;
                      return true;
                    }};
  const Decimation d = decimate(mesh, DecimateTarget::faces(400), options);
  EXPECT_EQ(d.mesh.faces.size(), 400U);
  EXPECT_LT(metrics::surface_distance(moved(mesh, offset), d.mesh, {.samples = 20'000}).mean, 0.01);
}

TEST(Pauses, KeepWhatIsLocked) {
  const IndexedMesh mesh = blob(4, 5);
  DecimateOptions options;
  options.cost = Cost::memoryless;
  options.locked.resize(mesh.positions.size());
  for (std::size_t v = 0; v < 40; ++v) options.locked[v] = 1;
  options.pauses = idle({1.5, 1.1});
  const Decimation d = decimate(mesh, DecimateTarget::faces(500), options);
  for (Index v = 0; v < 40; ++v) EXPECT_EQ(d.mesh.positions[d.vertex_map[v]], mesh.positions[v]);
}

TEST(Pauses, LeaveThresholdPairsToBeJoinedLater) {
  const IndexedMesh mesh = spheres(4, 3, 0.01);
  DecimateOptions options;
  options.pairs.threshold = 0.2;
  const DecimateTarget target = DecimateTarget::faces(60);
  const Decimation expected = decimate(mesh, target, options);
  ASSERT_EQ(expected.result.after.components, 1U);
  std::uint64_t contracted_before = 0;
  options.pauses = {{10}, [&contracted_before](Decimation& paused) {
                      contracted_before = paused.result.threshold_pairs.contracted;
                      return true;
                    }};
  const Decimation d = decimate(mesh, target, options);
  EXPECT_EQ(d.result.after.components, 1U);
  EXPECT_EQ(d.result.threshold_pairs.considered, expected.result.threshold_pairs.considered);
  EXPECT_GT(d.result.threshold_pairs.contracted, contracted_before) << "some are left to the second pass";
}

TEST(Pauses, ComeWhereAMeshHasNotAsFewFacesYet) {
  const IndexedMesh mesh = sphere(3);
  int n_pauses = 0;
  DecimateOptions options;
  options.pauses = {{20, 2, 1.5}, [&n_pauses](Decimation&) {
                      ++n_pauses;
                      return true;
                    }};
  decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 2), options);
  EXPECT_EQ(n_pauses, 1) << "at 1.5";
  n_pauses = 0;
  decimate(mesh, DecimateTarget::as_far_as_possible(), options);
  decimate(mesh, DecimateTarget::max_cost(1e-4), options);
  EXPECT_EQ(n_pauses, 0) << "there is no count";
  const Decimation d = decimate(mesh, DecimateTarget::faces(100).or_max_cost(1e-9), options);
  EXPECT_EQ(d.result.stop, StopReason::cost);
  EXPECT_EQ(n_pauses, 0) << "the cost ends the run before";
}

TEST(Pauses, MayEndTheRun) {
  const IndexedMesh mesh = sphere(4);
  DecimateOptions options;
  options.pauses = {{2}, [](Decimation&) { return false; }};
  const Decimation d = decimate(mesh, DecimateTarget::faces(200), options);
  EXPECT_EQ(d.result.stop, StopReason::cancelled);
  EXPECT_EQ(d.mesh.faces.size(), 400U);
  EXPECT_EQ(d.result.n_faces, 400U);
}

TEST(Pauses, ThatEndTheRunLeaveItsCountsAndQuadrics) {
  const IndexedMesh mesh = book(3, 40);
  DecimateOptions options;
  options.keep_quadrics = true;
  options.pauses = {{2}, [](Decimation&) { return false; }};
  const Decimation d = decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 8), options);
  EXPECT_EQ(d.result.stop, StopReason::cancelled);
  EXPECT_GT(d.result.after.nonmanifold_edges, 0U);
  EXPECT_EQ(d.result.after.nonmanifold_edges, metrics::topology(d.mesh).nonmanifold_edges);
  EXPECT_EQ(d.quadrics.size(), d.mesh.positions.size());
}

/// Meshes that go in blocks pause, too, and all is told of the input's vertices.
TEST(Pauses, DoNotDependOnTheNumberOfThreads) {
  const IndexedMesh mesh = noisy_torus(560, 280, 1, 0.4, 0.0005, 3);
  const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 20);
  SimplifyOptions options;
  options.pauses = {1.2, 1.1};
  const auto with_threads = [&](unsigned threads, std::vector<Contraction>& made) {
    SimplifyOptions o = options;
    o.decimate.threads = threads;
    o.decimate.listener = [&made](const Contraction& c) { made.push_back(c); };
    return simplify(mesh, target, Effort::normal, o);
  };
  std::vector<Contraction> made;
  const Simplification one = with_threads(1, made);
  EXPECT_EQ(one.result.why_in_one_pass, "");
  EXPECT_EQ(made.size(), one.result.n_contractions);
  std::vector<Index> into(mesh.positions.size());  // by the contractions told
  for (Index v = 0; v < into.size(); ++v) into[v] = v;
  for (const Contraction& c : made) into[c.removed] = c.survivor;
  for (Index v = 0; v < into.size(); ++v) {
    Index w = v;
    while (into[w] != w) w = into[w];
    ASSERT_EQ(one.mesh.origins[one.vertex_map[v]], w);
  }
  for (const unsigned threads : {2U, 3U, 8U}) {
    std::vector<Contraction> others;
    expect_same(one, with_threads(threads, others), std::to_string(threads));
  }
}

TEST(Pauses, TellProgressThatOnlyGrows) {
  const IndexedMesh mesh = noisy_torus(560, 280, 1, 0.4, 0.0005, 3);
  DecimateOptions options;
  options.cost = Cost::memoryless;
  options.pauses = idle({1.3, 1.1});
  std::vector<double> told;
  options.progress = [&told](const Progress& p) {
    told.push_back(p.fraction);
    return true;
  };
  decimate(mesh, DecimateTarget::faces(20'000), options);
  ASSERT_GT(told.size(), 10U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1);
}

TEST(SlowPauses, ForPolishBringTheResultNearer) {
  const std::vector<NamedMesh> round{{"torus", noisy_torus(200, 100, 1, 0.5, 0, 1)}, {"blob", blob(5, 4)}};
  for (const NamedMesh& named : round) {
    const IndexedMesh& mesh = named.mesh;
    const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 20);
    const auto error = [&](const std::vector<double>& pauses) {
      SimplifyOptions options;
      options.pauses = pauses;
      const Simplification s = simplify(mesh, target, Effort::normal, options);
      EXPECT_EQ(s.mesh.faces.size(), *target.n_faces());
      return metrics::surface_distance(mesh, s.mesh, {.samples = 200'000}).mean;
    };
    const double at_the_end = error({});
    EXPECT_LT(error({1.1}), 0.975 * at_the_end) << named.name;
    EXPECT_LT(error({1.2, 1.1, 1.03}), 0.955 * at_the_end) << named.name;
  }
}

TEST(Pauses, HaveToBePossible) {
  const IndexedMesh mesh = sphere(2);
  const auto run = [&mesh](const Pauses& pauses, Placement placement = Placement::optimal) {
    DecimateOptions options;
    options.pauses = pauses;
    options.quadric.placement = placement;
    return decimate(mesh, DecimateTarget::faces(100), options);
  };
  EXPECT_NO_THROW(run(idle({1.5, 1.5, 1.1})));
  EXPECT_THROW(run(idle({1})), std::invalid_argument);
  EXPECT_THROW(run(idle({0.5})), std::invalid_argument);
  EXPECT_THROW(run(idle({std::numeric_limits<double>::infinity()})), std::invalid_argument);
  EXPECT_THROW(run(idle({std::numeric_limits<double>::quiet_NaN()})), std::invalid_argument);
  EXPECT_THROW(run(idle({1.1, 1.2})), std::invalid_argument) << "ascending";
  EXPECT_THROW(run({{1.5}, {}}), std::invalid_argument) << "nothing to do";
  EXPECT_THROW(run(idle({1.5}), Placement::endpoint), std::invalid_argument);
  const auto change = [&run](auto adjust) {
    return run({{1.5}, [adjust](Decimation& paused) {
                  adjust(paused.mesh);
                  return true;
                }});
  };
  EXPECT_THROW(change([](IndexedMesh& m) { m.faces.pop_back(); }), std::invalid_argument);
  EXPECT_THROW(change([](IndexedMesh& m) { m.positions.push_back(Vec3::Zero()); }), std::invalid_argument);
  EXPECT_THROW(change([](IndexedMesh& m) { m.faces[0][0] = 1000; }), std::invalid_argument);
  EXPECT_THROW(change([](IndexedMesh& m) { m.positions[0].x() = std::numeric_limits<double>::quiet_NaN(); }),
               std::invalid_argument);
}

}  // namespace
}  // namespace whittle::test
