// Problems that users of the modules had: chains of levels, attributes, calls through the base.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <whittle/openmesh/detail/attributes/vertex_properties.hh>

#include "common/meshes.hh"
#include "common/modules.hh"

namespace whittle::test {
namespace {

using Mesh = DoubleMesh;
using OpenMesh::VertexHandle;

TEST(BaseReference, ModulesAddedThroughItAreRefused) {
  Mesh mesh = open_mesh<Mesh>(torus(14, 8));
  PairDecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::BaseDecimaterT<Mesh>& base = decimater;
  ModGarlandHeckbertT<Mesh>::Handle cost;
  base.add(cost);
  EXPECT_THROW(decimater.initialize(), std::logic_error);
  EXPECT_THROW(decimater.decimate_to(10), std::logic_error);
}

// `decimate(100)` and `decimate({100})` can only mean contractions: a number doesn't convert to a target.
static_assert(!std::is_convertible_v<int, DecimateTarget>);

// Nor does OpenMesh's share of collapses by `McDecimaterT` mean that only selected vertices take part.
template <class Number>
concept TakenForABool = requires(PairDecimaterT<Mesh> decimater, Number number) {
  decimater.decimate_to(9, number);
}
|| requires(PairDecimaterT<Mesh> decimater, Number number) { decimater.decimate_to_faces(0, 9, number); }
|| requires(PairDecimaterT<Mesh> decimater, Number number) { decimater.decimate(9, number); }
|| requires(PairDecimaterT<Mesh> decimater, Number number) { decimater.decimate(to_faces(9), number); };
static_assert(TakenForABool<bool>);
static_assert(!TakenForABool<float> && !TakenForABool<double> && !TakenForABool<int>);

TEST(StockCalls, ANumberMeansContractions) {
  Mesh mesh = open_mesh<Mesh>(noisy_torus(24, 12, 1, 0.4, 0.03, 3));
  PairDecimaterT<Mesh> decimater(mesh);
  add_module<ModGarlandHeckbertT<Mesh>>(decimater);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_EQ(decimater.decimate(100), 100U);
  EXPECT_EQ(decimater.result().n_contractions, 100U);
}

TEST(StockCalls, MaxErrLimitsTheCost) {
  Mesh mesh = open_mesh<Mesh>(noisy_torus(24, 12, 1, 0.4, 0.03, 3));
  PairDecimaterT<Mesh> decimater(mesh);
  auto& cost = add_module<ModGarlandHeckbertT<Mesh>>(decimater);
  const Mesh whole = mesh;
  ASSERT_TRUE(decimater.initialize());
  const double limit = decimater.decimate(to_faces(400)).max_cost;
  mesh = whole;
  cost.set_max_err(limit);
  ASSERT_TRUE(decimater.initialize());
  const DecimateResult limited = decimater.decimate(DecimateTarget::as_far_as_possible());
  EXPECT_EQ(limited.stop, StopReason::cost);
  EXPECT_LE(limited.max_cost, limit);
  EXPECT_GT(limited.n_contractions, 0U);
  cost.unset_max_err();
  EXPECT_FALSE(cost.max_cost());
  EXPECT_THROW(cost.set_max_err(1, true), std::invalid_argument);
}

TEST(Setters, AfterInitializeAreNotIgnored) {
  Mesh mesh = open_mesh<Mesh>(noisy_torus(24, 12, 1, 0.4, 0.03, 3));
  PairDecimaterT<Mesh> decimater(mesh);
  auto& cost = add_module<ModGarlandHeckbertT<Mesh>>(decimater);
  ASSERT_TRUE(decimater.initialize());
  cost.set_isotropy(1);
  EXPECT_THROW(decimater.decimate(to_faces(300)), std::logic_error);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_EQ(decimater.decimate(to_faces(300)).n_faces, 300U);
}

/// Compares several levels of one decimater with one run to the last level.
void expect_chain_is_one_run(const NamedCost& cost, const IndexedMesh& shape, Driver driver) {
  const std::string context = cost.name + (driver == Driver::engine ? ", engine" : ", mesh");
  const auto run = [&](const std::vector<std::uint64_t>& levels) {
    Mesh mesh = open_mesh<Mesh>(shape);
    PairDecimaterT<Mesh> decimater(mesh);
    add_cost(decimater, cost.options);
    decimater.set_driver(driver);
    std::vector<Contraction> result;
    decimater.set_listener([&](const Contraction& made) { result.push_back(made); });
    EXPECT_TRUE(decimater.initialize());
    for (const std::uint64_t level : levels) {
      decimater.decimate(to_faces(level));
      EXPECT_EQ(decimater.last_driver(), driver) << context;
      expect_sound(mesh, context);
    }
    return result;
  };
  expect_same_contractions(run({80}), run({400, 200, 80}), context);
}

TEST(ChainsOfLevels, StayOnTheEngineAndAreOneRun) {
  for (const NamedCost& cost : named_costs()) {
    expect_chain_is_one_run(cost, noisy_torus(24, 12, 1, 0.4, 0.03, 3), Driver::engine);
    expect_chain_is_one_run(cost, noisy_grid(16, 16, 0.2, 9), Driver::engine);
    expect_chain_is_one_run(cost, noisy_torus(24, 12, 1, 0.4, 0.03, 3), Driver::mesh);
  }
}

TEST(ChainsOfLevels, MayChangeDrivers) {
  const IndexedMesh shape = noisy_torus(24, 12, 1, 0.4, 0.03, 3);
  for (const NamedCost& cost : named_costs()) {
    const auto run = [&](Driver first, Driver second) {
      Mesh mesh = open_mesh<Mesh>(shape);
      PairDecimaterT<Mesh> decimater(mesh);
      add_cost(decimater, cost.options);
      std::vector<Contraction> result;
      decimater.set_listener([&](const Contraction& made) { result.push_back(made); });
      EXPECT_TRUE(decimater.initialize());
      decimater.set_driver(first);
      decimater.decimate(to_faces(300));
      decimater.set_driver(second);
      decimater.decimate(to_faces(100));
      return result;
    };
    const auto expected = run(Driver::engine, Driver::engine);
    expect_same_contractions(expected, run(Driver::engine, Driver::mesh), cost.name + ", engine then mesh");
    expect_same_contractions(expected, run(Driver::mesh, Driver::engine), cost.name + ", mesh then engine");
  }
}

const Mesh::Color grid_color(250, 101, 3);

/// A flat grid whose texture coordinates equal the positions, and whose colours and normals are constant.
Mesh textured_grid() {
  IndexedMesh shape = noisy_grid(12, 12, 0, 1);
  Mesh mesh = open_mesh<Mesh>(shape);
  mesh.request_vertex_texcoords1D();
  mesh.request_vertex_texcoords2D();
  mesh.request_vertex_texcoords3D();
  mesh.request_vertex_colors();
  mesh.request_vertex_normals();
  for (const VertexHandle v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    const auto x = static_cast<float>(p[0]);
    const auto y = static_cast<float>(p[1]);
    mesh.set_texcoord1D(v, y);
    mesh.set_texcoord2D(v, {x, y});
    mesh.set_texcoord3D(v, {y, x, x + y});
    mesh.set_color(v, grid_color);
    mesh.set_normal(v, {0, 0, 1});
  }
  return mesh;
}

void expect_texture_in_place(const Mesh& mesh, const std::string& context) {
  std::size_t n = 0;
  for (const VertexHandle v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    EXPECT_NEAR(mesh.texcoord2D(v)[0], p[0], 1e-4) << context << ", vertex " << v.idx();
    EXPECT_NEAR(mesh.texcoord2D(v)[1], p[1], 1e-4) << context << ", vertex " << v.idx();
    EXPECT_NEAR(mesh.texcoord1D(v), p[1], 1e-4) << context << ", vertex " << v.idx();
    EXPECT_NEAR(mesh.texcoord3D(v)[0], p[1], 1e-4) << context << ", vertex " << v.idx();
    EXPECT_NEAR(mesh.texcoord3D(v)[1], p[0], 1e-4) << context << ", vertex " << v.idx();
    EXPECT_NEAR(mesh.texcoord3D(v)[2], p[0] + p[1], 1e-4) << context << ", vertex " << v.idx();
    EXPECT_EQ(mesh.color(v), grid_color) << context << ", vertex " << v.idx();
    EXPECT_NEAR(mesh.normal(v).norm(), 1, 1e-6) << context;
    ++n;
  }
  EXPECT_LT(n, 120U) << context;
}

TEST(VertexAttributes, MoveAlongTheEdgeWithTheVertex) {
  for (const Driver driver : {Driver::engine, Driver::mesh}) {
    Mesh mesh = textured_grid();
    PairDecimaterT<Mesh> decimater(mesh);
    add_module<ModMidpointT<Mesh>>(decimater);
    decimater.set_driver(driver);
    ASSERT_TRUE(decimater.initialize());
    decimater.decimate(to_vertices(90));
    expect_texture_in_place(mesh, driver == Driver::engine ? "engine" : "mesh");
  }
}

/// The colours of two vertices, merged at a share of the way from the first to the second.
Mesh::Color blended(const Mesh::Color& first, const Mesh::Color& second, double share) {
  Mesh mesh = open_mesh<Mesh>(single_triangle());
  mesh.request_vertex_colors();
  mesh.set_color(VertexHandle(0), first);
  mesh.set_color(VertexHandle(1), second);
  mesh.set_color(VertexHandle(2), first);
  const Vec3 from = to_vec3(mesh.point(VertexHandle(0)));
  const Vec3 to = to_vec3(mesh.point(VertexHandle(1)));
  whittle::VertexProperties(mesh).merge(mesh, VertexHandle(0), VertexHandle(1), from + share * (to - from));
  return mesh.color(VertexHandle(0));
}

TEST(VertexAttributes, ColoursOfBytesAreRoundedToTheNearest) {
  EXPECT_EQ(blended({0, 100, 255}, {1, 200, 254}, 0.75), Mesh::Color(1, 175, 254));
  EXPECT_EQ(blended({0, 100, 255}, {1, 200, 254}, 0.25), Mesh::Color(0, 125, 255));
  for (int i = 0; i <= 1000; ++i) {
    EXPECT_EQ(blended(grid_color, grid_color, i / 1000.0), grid_color) << "share " << i / 1000.0;
  }
}

TEST(StockCalls, AnOptionThatWasSetCanBeAsked) {
  Mesh mesh = open_mesh<Mesh>(blob(2, 1));
  PairDecimaterT<Mesh> decimater(mesh);
  EXPECT_EQ(decimater.driver(), Driver::automatic);
  decimater.set_driver(Driver::mesh);
  EXPECT_EQ(decimater.driver(), Driver::mesh);
  auto& cost = add_module<ModGarlandHeckbertT<Mesh>>(decimater);
  EXPECT_EQ(cost.arithmetic(), Arithmetic::local);
  cost.set_arithmetic(Arithmetic::stock);
  EXPECT_EQ(cost.arithmetic(), Arithmetic::stock);
}

TEST(EngineDriver, GivesTheSameOnAnyNumberOfThreads) {
  const auto run = [](unsigned threads) {
    Mesh mesh = open_mesh<Mesh>(blob(4, 2));
    PairDecimaterT<Mesh> decimater(mesh);
    add_module<ModGarlandHeckbertT<Mesh>>(decimater);
    decimater.set_threads(threads);
    std::vector<Contraction> contractions;
    decimater.set_listener([&](const Contraction& made) { contractions.push_back(made); });
    EXPECT_TRUE(decimater.initialize());
    decimater.decimate(to_faces(500));
    EXPECT_EQ(decimater.last_driver(), Driver::engine);
    return contractions;
  };
  const std::vector<Contraction> expected = run(1);
  EXPECT_GT(expected.size(), 1000U);
  expect_same_contractions(expected, run(3), "three threads");
}

}  // namespace
}  // namespace whittle::test
