// Our cost modules other than plain Garland–Heckbert: in OpenMesh's decimaters, and the costs they compute.
#include <gtest/gtest.h>

#include <algorithm>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/McDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/MixedDecimaterT.hh>
#include <cmath>
#include <optional>

#include "common/decimation.hh"
#include "common/modules.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

// In OpenMesh's decimaters --------------------------------------------------------------------------------------------

class CostInStockDecimaters : public testing::TestWithParam<NamedCost> {
 protected:
  /// Decimates to 300 faces by `decimate(decimater)` and checks the result.
  template <template <class> class DecimaterT, class MeshT, class Decimate>
  void run(const Decimate& decimate) {
    const IndexedMesh shape = noisy_torus(32, 16, 1, 0.4, 0.02, 5);
    MeshT mesh = open_mesh<MeshT>(shape);
    DecimaterT<MeshT> decimater(mesh);
    auto& cost = add_cost(decimater, GetParam().options);
    add_module<ModFlipGuardT<MeshT>>(decimater).set_cost_module(&cost);
    ASSERT_TRUE(decimater.initialize());
    decimate(decimater);
    mesh.garbage_collection();
    EXPECT_NEAR(static_cast<double>(mesh.n_faces()), 300, 1);
    expect_sound(mesh, "after the run");
    const IndexedMesh after = geometry_of(mesh);
    expect_same_topology(shape, after, "after the run");
    EXPECT_NEAR(signed_volume(after), signed_volume(shape), 0.2 * signed_volume(shape));
  }
};
INSTANTIATE_TEST_SUITE_P(Costs, CostInStockDecimaters, testing::ValuesIn(named_costs()),
                         [](const auto& test) { return test.param.name; });

TEST_P(CostInStockDecimaters, DecimaterTakesIt) {
  run<OpenMesh::Decimater::DecimaterT, DoubleMesh>([](auto& d) { d.decimate_to_faces(0, 300); });
  run<OpenMesh::Decimater::DecimaterT, FloatMesh>([](auto& d) { d.decimate_to_faces(0, 300); });
}

TEST_P(CostInStockDecimaters, McDecimaterTakesIt) {
  run<OpenMesh::Decimater::McDecimaterT, DoubleMesh>([](auto& d) {
    d.set_samples(20);
    d.decimate_to_faces(0, 300);
  });
}

TEST_P(CostInStockDecimaters, MixedDecimaterTakesIt) {
  run<OpenMesh::Decimater::MixedDecimaterT, DoubleMesh>([](auto& d) {
    d.set_samples(20);
    d.decimate_to_faces(0, 300, 0.5F);
  });
}

TEST_P(CostInStockDecimaters, TheUnitOfTheMeshChangesNoCollapse) {
  // Costs scale with up to the sixth power of the size. In model units they would underflow to 0 as floats.
  const IndexedMesh shape = noisy_sphere(2, 0.05, 8);
  const auto collapses = [&](double factor) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(scaled(shape, factor));
    OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
    add_cost(decimater, GetParam().options);
    auto& recorder = add_module<ModCollapsesT<DoubleMesh>>(decimater);
    EXPECT_TRUE(decimater.initialize());
    decimater.decimate(120);
    return recorder.collapses;
  };
  const std::vector<Collapse> expected = collapses(1);
  EXPECT_EQ(expected.size(), 120U);
  for (const double factor : {0x1p-60, 0x1p60}) EXPECT_EQ(collapses(factor), expected) << factor;
}

TEST_P(CostInStockDecimaters, LockedVerticesKeepTheirPlace) {
  const IndexedMesh shape = blob(2, 5);
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
  auto& cost = add_cost(decimater, GetParam().options);
  add_module<ModFlipGuardT<DoubleMesh>>(decimater).set_cost_module(&cost);
  for (const VertexHandle v : mesh.vertices()) mesh.status(v).set_locked(v.idx() % 5 == 0);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate(), 60U);
  for (int v = 0; v < 162; v += 5) EXPECT_TRUE(unmoved(mesh, shape, VertexHandle(v))) << v;
}

TEST(CostModules, FeatureBitsGoWithTheEdgesThatTakeTheirsPlace) {
  // A ridge with a kink: v0 of the collapse is at the kink, and the ridge continues along the wing's edge to v1.
  DoubleMesh mesh = open_mesh<DoubleMesh>(grid(4, 4));
  OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
  auto& cost = add_module<ModMidpointT<DoubleMesh>>(decimater);
  ASSERT_TRUE(decimater.initialize());
  const OpenMesh::HalfedgeHandle h = mesh.find_halfedge(VertexHandle(12), VertexHandle(13));
  const OpenMesh::Decimater::CollapseInfoT<DoubleMesh> collapse(mesh, h);
  ASSERT_TRUE(collapse.vl.is_valid());
  mesh.status(mesh.edge_handle(collapse.v0vl)).set_feature(true);
  cost.preprocess_collapse(collapse);
  mesh.collapse(h);
  cost.postprocess_collapse(collapse);
  const auto left = mesh.find_halfedge(collapse.v1, collapse.vl);
  EXPECT_TRUE(mesh.status(mesh.edge_handle(left)).feature());
  EXPECT_EQ(marked_edges(mesh).size(), 1U);
}

// Options -------------------------------------------------------------------------------------------------------------

TEST(CostModules, HaveNamesOfTheirOwnAndRank) {
  DoubleMesh mesh;
  EXPECT_EQ(ModMidpointT<DoubleMesh>(mesh).name(), "Midpoint");
  EXPECT_EQ(ModLindstromTurkT<DoubleMesh>(mesh).name(), "LindstromTurk");
  EXPECT_EQ(ModMemorylessT<DoubleMesh>(mesh).name(), "Memoryless");
  EXPECT_FALSE(ModMidpointT<DoubleMesh>(mesh).is_binary());
  EXPECT_FALSE(ModLindstromTurkT<DoubleMesh>(mesh).is_binary());
  EXPECT_FALSE(ModMemorylessT<DoubleMesh>(mesh).is_binary());
}

TEST(CostModules, WrongOptionsThrowAndLeaveWhatWasSet) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(tetrahedron());
  ModLindstromTurkT<DoubleMesh> lindstrom_turk(mesh);
  ModGarlandHeckbertT<DoubleMesh> quadric(mesh);
  const double nan = std::nan("");
  lindstrom_turk.set_valence_weight(2);
  for (const double wrong : {-1e-9, nan, static_cast<double>(INFINITY)}) {
    EXPECT_THROW(lindstrom_turk.set_valence_weight(wrong), std::invalid_argument) << wrong;
  }
  EXPECT_EQ(lindstrom_turk.valence_weight(), 2);
  quadric.set_isotropy(0.25);
  for (const double wrong : {-0.01, 1.01, nan}) {
    EXPECT_THROW(quadric.set_isotropy(wrong), std::invalid_argument) << wrong;
  }
  EXPECT_EQ(quadric.isotropy(), 0.25);
  ModMemorylessT<DoubleMesh> memoryless(mesh);
  memoryless.set_options({.boundary_weight = 3});
  for (const QuadricOptions& wrong : {QuadricOptions{.weights = Weights::uniform, .boundary_weight = 4},
                                      QuadricOptions{.weights = Weights::area_angle, .boundary_weight = 4},
                                      QuadricOptions{.boundary_weight = -1}, QuadricOptions{.regularization = nan}}) {
    EXPECT_THROW(memoryless.set_options(wrong), std::invalid_argument);
  }
  EXPECT_EQ(memoryless.options().boundary_weight, 3);
  EXPECT_THROW(lindstrom_turk.set_max_cost(-1), std::invalid_argument);
  try {
    lindstrom_turk.set_max_cost(nan);
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "ModLindstromTurkT: max_cost is negative or not a number");
  }
  mesh.set_point(VertexHandle(1), {0, nan, 0});
  EXPECT_THROW(lindstrom_turk.initialize(), std::invalid_argument);
}

TEST(CostModules, TermsAreUsedFromTheNextInitializeOn) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(blob(2, 5));
  mesh.request_vertex_status();
  ModGarlandHeckbertT<DoubleMesh> module(mesh);
  module.initialize();
  const auto cost = [&] { return module.evaluate(VertexHandle(0), VertexHandle(42), PairConstraint::first).cost; };
  ASSERT_TRUE(mesh.find_halfedge(VertexHandle(0), VertexHandle(42)).is_valid());
  const double plain = cost();
  module.set_isotropy(0.5);
  EXPECT_EQ(cost(), plain);
  EXPECT_EQ(module.reach(), Reach::none);
  EXPECT_EQ(module.cost_dimension(), 4);
  module.initialize();
  EXPECT_NE(cost(), plain);
  EXPECT_EQ(module.reach(), Reach::ends);
  EXPECT_EQ(module.cost_dimension(), 3);
  module.set_valence_weight(0.5);
  EXPECT_EQ(module.reach(), Reach::ends);
  module.initialize();
  EXPECT_EQ(module.reach(), Reach::opposite_rings);
}

// Numbers -------------------------------------------------------------------------------------------------------------

TEST(ModMidpoint, TheCostIsTheLengthInModelUnitsAndThePlaceTheMiddle) {
  const IndexedMesh shape = moved(scaled(blob(2, 5), 250), Vec3(1000, -3000, 10));
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  mesh.request_vertex_status();
  ModMidpointT<DoubleMesh> module(mesh);
  module.initialize();
  for (const OpenMesh::EdgeHandle e : mesh.edges()) {
    const VertexPair pair = ends(mesh, e);
    const VertexHandle first(static_cast<int>(pair.a));
    const VertexHandle second(static_cast<int>(pair.b));
    const Vec3& p = shape.positions[pair.a];
    const Vec3& q = shape.positions[pair.b];
    const PairEvaluation free = module.evaluate(first, second, PairConstraint::none);
    EXPECT_NEAR(module.frame().cost_to_model(free.cost, 1), (q - p).norm(), 1e-9);
    EXPECT_NEAR((module.frame().to_model(free.position) - 0.5 * (p + q)).norm(), 0, 1e-9);
    EXPECT_EQ(module.frame().to_model(module.evaluate(first, second, PairConstraint::second).position), q);
  }
}

TEST(ModLindstromTurk, KeepsTheVolumeInOpenMeshsDecimaterToo) {
  const IndexedMesh shape = noisy_torus(48, 24, 1, 0.4, 0.01, 5);
  const auto volume_after = [&](const CostOptions& options) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
    OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
    auto& cost = add_cost(decimater, options);
    add_module<ModFlipGuardT<DoubleMesh>>(decimater).set_cost_module(&cost);
    EXPECT_TRUE(decimater.initialize());
    decimater.decimate_to_faces(0, 500);
    return signed_volume(geometry_of(mesh));
  };
  const double volume = signed_volume(shape);
  EXPECT_NEAR(volume_after({Cost::lindstrom_turk, {}, 0, 0}), volume, 1e-3 * volume);
  EXPECT_GT(std::abs(volume_after({Cost::midpoint, {}, 0, 0}) - volume), 1e-2 * volume) << "nothing special";
}

TEST(ModMemoryless, KeepsTheVolumeInOpenMeshsDecimaterToo) {
  const IndexedMesh shape = noisy_torus(48, 24, 1, 0.4, 0.01, 5);
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
  auto& cost = add_module<ModMemorylessT<DoubleMesh>>(decimater);
  add_module<ModFlipGuardT<DoubleMesh>>(decimater).set_cost_module(&cost);
  ASSERT_TRUE(decimater.initialize());
  decimater.decimate_to_faces(0, 500);
  EXPECT_NEAR(signed_volume(geometry_of(mesh)), signed_volume(shape), 1e-12 * signed_volume(shape));
}

TEST(ModMemoryless, WhereTheBestPlaceIsRefusedTheMinimumIsTried) {
  // A guard that requires v1 to be at the position of least cost.
  struct ModLeastCost : OpenMesh::Decimater::ModBaseT<DoubleMesh> {
    explicit ModLeastCost(DoubleMesh& mesh) : ModBaseT(mesh, true) {}
    float collapse_priority(const CollapseInfo& collapse) override {
      const auto [first, second] = std::minmax(collapse.v0, collapse.v1);
      const Vec3 minimum = cost->evaluate(first, second, PairConstraint::none).position;
      return static_cast<float>(to_vec3(collapse.p1) == cost->frame().to_model(minimum) ? LEGAL_COLLAPSE
                                                                                        : ILLEGAL_COLLAPSE);
    }
    const PairCostModuleT<DoubleMesh>* cost = nullptr;
  };
  const IndexedMesh shape = noisy_sphere(3, 0.05, 4);
  const auto volume_after = [&](bool with_guard) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
    PairDecimaterT<DoubleMesh> decimater(mesh);
    auto& cost = add_module<ModMemorylessT<DoubleMesh>>(decimater);
    OpenMesh::Decimater::ModHandleT<ModLeastCost> guard;
    if (with_guard) {
      decimater.add(guard);
      decimater.module(guard).cost = &cost;
    }
    decimater.set_driver(Driver::mesh);
    EXPECT_TRUE(decimater.initialize());
    EXPECT_EQ(decimater.decimate_to_faces(0, 200), 540U);
    EXPECT_TRUE(decimater.module_refusals().empty()) << "no contraction was refused";
    return signed_volume(geometry_of(mesh));
  };
  const double volume = signed_volume(shape);
  EXPECT_NEAR(volume_after(false), volume, 1e-12 * volume);
  EXPECT_LT(volume_after(true), 0.995 * volume) << "at the minima it shrinks";
}

/// The positions of least cost of all edges, in model units.
std::vector<Vec3> minima_of_edges(const DoubleMesh& mesh, const PairCostModuleT<DoubleMesh>& module) {
  std::vector<Vec3> minima;
  for (const OpenMesh::EdgeHandle e : mesh.edges()) {
    const auto [a, b] = ends(mesh, e);
    const PairEvaluation evaluation =
        module.evaluate(VertexHandle(static_cast<int>(a)), VertexHandle(static_cast<int>(b)), PairConstraint::none);
    minima.push_back(module.frame().to_model(evaluation.position));
  }
  return minima;
}

TEST(ModMemoryless, GoesByTheFacesThereAreAfterJoints) {
  // Two spheres that share a vertex. The engine joins its copies, and the vertices around keep their planes.
  const auto by_x = [](const Vec3& p, const Vec3& q) { return p.x() < q.x(); };
  const IndexedMesh left = noisy_sphere(3, 0.1, 1);
  IndexedMesh right = noisy_sphere(3, 0.1, 2);
  const auto leftmost = std::ranges::min_element(right.positions, by_x) - right.positions.begin();
  const Vec3 contact = *std::ranges::max_element(left.positions, by_x);
  right = moved(right, contact - right.positions[static_cast<std::size_t>(leftmost)]);
  right.positions[static_cast<std::size_t>(leftmost)] = contact;
  DoubleMesh mesh;
  ASSERT_EQ(to_open_mesh(glued(joined(left, right)), mesh, NonManifold::cut).size(), 0U);
  PairDecimaterT<DoubleMesh> decimater(mesh);
  auto& module = add_module<ModMemorylessT<DoubleMesh>>(decimater);
  ASSERT_TRUE(decimater.initialize());
  decimater.decimate_to_faces(0, 200);
  ASSERT_EQ(decimater.last_driver(), Driver::engine);
  ModMemorylessT<DoubleMesh> fresh(mesh);
  fresh.initialize();
  const std::vector<Vec3> minima = minima_of_edges(mesh, module);
  const std::vector<Vec3> expected = minima_of_edges(mesh, fresh);
  ASSERT_EQ(minima.size(), expected.size());
  for (std::size_t e = 0; e < minima.size(); ++e) EXPECT_LE((minima[e] - expected[e]).norm(), 1e-9) << e;
  decimater.decimate_to_faces(0, 150);
  EXPECT_EQ(decimater.last_driver(), Driver::engine) << "it goes on";
  decimater.set_driver(Driver::mesh);
  decimater.decimate_to_faces(0, 100);
  expect_sound(mesh, "after all runs");
}

TEST(ModLindstromTurk, TheCostGrowsWithTheSixthPowerOfTheSize) {
  const IndexedMesh shape = noisy_grid(4, 4, 0.3, 3);
  const auto costs = [&](double factor) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(scaled(shape, factor));
    mesh.request_vertex_status();
    ModLindstromTurkT<DoubleMesh> module(mesh);
    module.initialize();
    std::vector<double> result;
    for (const OpenMesh::EdgeHandle e : mesh.edges()) {
      const auto [a, b] = ends(mesh, e);
      const auto cost =
          module.evaluate(VertexHandle(static_cast<int>(a)), VertexHandle(static_cast<int>(b)), PairConstraint::first)
              .cost;
      result.push_back(module.frame().cost_to_model(cost, module.cost_dimension()));
    }
    return result;
  };
  const std::vector<double> expected = costs(1);
  const std::vector<double> larger = costs(1000);
  for (std::size_t e = 0; e < expected.size(); ++e) EXPECT_NEAR(larger[e] * 1e-18, expected[e], 1e-12 * expected[e]);
  EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 1e-3);
}

/// Valences and edge lengths of the result.
struct Shape {
  int n_three = 0;
  int n_irregular = 0;  ///< valences other than 5, 6, 7
  double length_variation = 0;
};

Shape shape_of(const DoubleMesh& mesh) {
  Shape shape;
  for (const VertexHandle v : mesh.vertices()) {
    const auto valence = static_cast<int>(mesh.valence(v));
    shape.n_three += valence == 3;
    shape.n_irregular += valence < 5 || valence > 7;
  }
  double sum = 0;
  double squares = 0;
  int n = 0;
  for (const OpenMesh::EdgeHandle e : mesh.edges()) {
    const double length = mesh.calc_edge_length(e);
    sum += length;
    squares += length * length;
    ++n;
  }
  const double mean = sum / n;
  shape.length_variation = std::sqrt(std::max(0.0, squares / n - mean * mean)) / mean;
  return shape;
}

TEST(CostTerms, WeightsMakeValencesRegularAndEdgesEven) {
  const auto shape_with = [](double isotropy, double valence_weight) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_torus(64, 32, 1, 0.4, 0.02, 3));
    PairDecimaterT<DoubleMesh> decimater(mesh);
    add_cost(decimater, {Cost::quadric, {}, isotropy, valence_weight});
    EXPECT_TRUE(decimater.initialize());
    decimater.decimate_to_faces(0, 500);
    EXPECT_EQ(decimater.last_driver(), Driver::engine);
    return shape_of(mesh);
  };
  const Shape plain = shape_with(0, 0);
  const Shape regular = shape_with(0, 1);
  EXPECT_GT(plain.n_irregular, 20);
  EXPECT_LT(regular.n_irregular, plain.n_irregular / 2);
  EXPECT_EQ(regular.n_three, 0);
  const Shape half = shape_with(0.5, 0);
  const Shape even = shape_with(1, 0);
  EXPECT_LT(half.length_variation, 0.9 * plain.length_variation);
  EXPECT_LT(even.length_variation, 0.9 * half.length_variation);
}

class CostsInParts : public testing::TestWithParam<NamedCost> {};
INSTANTIATE_TEST_SUITE_P(Costs, CostsInParts, testing::ValuesIn(named_costs()),
                         [](const auto& test) { return test.param.name; });

TEST_P(CostsInParts, TwoRunsAreOneWhicheverDriverMakesTheFirst) {
  const IndexedMesh shape = moved(terrain(12, 4), Vec3(500, -70, 90));
  const auto contractions = [&](Driver first_driver, std::size_t n_first) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
    PairDecimaterT<DoubleMesh> decimater(mesh);
    add_cost(decimater, GetParam().options);
    std::vector<Contraction> result;
    decimater.set_listener([&](const Contraction& made) { result.push_back(made); });
    EXPECT_TRUE(decimater.initialize());
    decimater.set_driver(first_driver);
    decimater.decimate(n_first);
    decimater.set_driver(Driver::mesh);
    if (n_first < 100) decimater.decimate(100 - n_first);
    return result;
  };
  const std::vector<Contraction> at_once = contractions(Driver::mesh, 100);
  EXPECT_EQ(at_once.size(), 100U);
  expect_same_contractions(at_once, contractions(Driver::mesh, 40), "mesh driver twice");
  expect_same_contractions(at_once, contractions(Driver::engine, 40), "engine, then mesh driver");
}

// The angle by which faces may turn -----------------------------------------------------------------------------------

TEST(FlipAngle, IsTheCostsOwnWithoutAFlipGuard) {
  const IndexedMesh shape = noisy_sphere(3, 0.3, 2);
  for (const CostTraits& traits : all_cost_traits) {
    for (const Driver driver : {Driver::engine, Driver::mesh}) {
      const auto contractions = [&](std::optional<double> angle_deg) {
        DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
        PairDecimaterT<DoubleMesh> decimater(mesh);
        add_cost(decimater, {traits.cost, {}, 0, 0});
        if (angle_deg) add_module<ModFlipGuardT<DoubleMesh>>(decimater).set_max_normal_flip_deg(*angle_deg);
        std::vector<Contraction> result;
        decimater.set_listener([&](const Contraction& made) { result.push_back(made); });
        EXPECT_TRUE(decimater.initialize());
        decimater.set_driver(driver);
        decimater.decimate_to(60);
        return result;
      };
      const std::string context(traits.name);
      const std::vector<Contraction> by_cost = contractions(std::nullopt);
      expect_same_contractions(by_cost, contractions(traits.default_max_normal_flip_deg), context);
      const auto same_pair = [](const Contraction& a, const Contraction& b) {
        return a.survivor == b.survivor && a.removed == b.removed;
      };
      const std::vector<Contraction> otherwise = contractions(traits.default_max_normal_flip_deg - 20);
      EXPECT_FALSE(std::equal(by_cost.begin(), by_cost.end(), otherwise.begin(), otherwise.end(), same_pair))
          << context << ": the angle should matter on this mesh";
    }
  }
}

}  // namespace
}  // namespace whittle::test
