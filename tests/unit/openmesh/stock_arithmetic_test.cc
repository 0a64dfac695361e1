// Arithmetic::stock in the stock decimater: the same collapses as ModQuadricT, one by one, for floats and doubles.
#include <gtest/gtest.h>

#include <algorithm>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <whittle/openmesh/mod_garland_heckbert.hh>

#include "common/meshes.hh"
#include "support/meshes.hh"
#include "support/shapes/shapes.hh"

namespace whittle::test {
namespace {

struct StockRun {
  std::vector<Collapse> collapses;
  IndexedMesh mesh;
};

/// \param prepare called with the cost module before it is initialized
template <template <class> class CostModuleT, class MeshT, class Prepare>
StockRun decimate_by_stock(MeshT mesh, std::size_t n_faces, const Prepare& prepare) {
  OpenMesh::Decimater::DecimaterT<MeshT> decimater(mesh);
  typename CostModuleT<MeshT>::Handle cost;
  typename ModCollapsesT<MeshT>::Handle recorder;
  decimater.add(cost);
  decimater.add(recorder);
  prepare(decimater.module(cost));
  EXPECT_TRUE(decimater.initialize());
  decimater.decimate_to_faces(0, n_faces);
  return {decimater.module(recorder).collapses, geometry_of(mesh)};
}

template <class MeshT>
StockRun by_quadric_module(const MeshT& mesh, std::size_t n_faces, double max_cost) {
  const auto prepare = [&](auto& module) {
    if (max_cost > 0) module.set_max_err(max_cost, false);
  };
  return decimate_by_stock<OpenMesh::Decimater::ModQuadricT>(mesh, n_faces, prepare);
}

template <class MeshT>
StockRun by_our_module(const MeshT& mesh, std::size_t n_faces, double max_cost) {
  const auto prepare = [&](auto& module) {
    module.set_arithmetic(Arithmetic::stock);
    if (max_cost > 0) module.set_max_cost(max_cost);
  };
  return decimate_by_stock<ModGarlandHeckbertT>(mesh, n_faces, prepare);
}

/// Runs to `n_faces`, and once more with a cost limit that ends the run early. \return the collapses of both
template <class MeshT>
std::vector<std::size_t> expect_same_collapses(const MeshT& mesh, std::size_t n_faces, const std::string& context) {
  // A limit that some collapses pass and some don't: a plane's area times a hundredth of the size, squared.
  const IndexedMesh geometry = geometry_of(mesh);
  Vec3 low = geometry.positions.at(0);
  Vec3 high = low;
  for (const Vec3& p : geometry.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).norm();
  const double area_of_a_face = size * size / static_cast<double>(geometry.faces.size());
  const double some_cost = 1e-4 * size * size * area_of_a_face;
  std::vector<std::size_t> n_collapses;
  for (const double max_cost : {0.0, some_cost}) {
    const StockRun expected = by_quadric_module(mesh, n_faces, max_cost);
    const StockRun actual = by_our_module(mesh, n_faces, max_cost);
    const auto [e, a] = std::mismatch(expected.collapses.begin(), expected.collapses.end(), actual.collapses.begin(),
                                      actual.collapses.end());
    EXPECT_TRUE(e == expected.collapses.end() && a == actual.collapses.end())
        << context << ", max cost " << max_cost << ": collapse " << e - expected.collapses.begin() << " of "
        << expected.collapses.size() << " differs";
    EXPECT_EQ(expected.mesh.positions, actual.mesh.positions) << context;
    EXPECT_EQ(expected.mesh.faces, actual.mesh.faces) << context;
    n_collapses.push_back(expected.collapses.size());
  }
  return n_collapses;
}

TEST(StockArithmetic, RepeatsModQuadricOnEveryShape) {
  for (const auto& [name, shape] : holdable_meshes()) {
    expect_same_collapses(open_mesh<FloatMesh>(shape), 0, name + ", float");
    expect_same_collapses(open_mesh<DoubleMesh>(shape), 0, name + ", double");
  }
}

class StockArithmeticOnRealMesh : public testing::TestWithParam<const char*> {};

TEST_P(StockArithmeticOnRealMesh, RepeatsModQuadric) {
  WHITTLE_REAL_MESH_OR_SKIP(file, GetParam());
  const auto single = read_open_mesh<FloatMesh>(file);
  const auto n_collapses = expect_same_collapses(single, single.n_faces() / 100, "float");
  EXPECT_GT(n_collapses[0], single.n_vertices() * 9 / 10);
  EXPECT_GT(n_collapses[1], single.n_vertices() / 100) << "the limit forbade nearly all";
  EXPECT_LT(n_collapses[1], n_collapses[0]) << "the limit forbade nothing";
  expect_same_collapses(read_open_mesh<DoubleMesh>(file), single.n_faces() / 100, "double");
}

INSTANTIATE_TEST_SUITE_P(SlowMeshes, StockArithmeticOnRealMesh,
                         testing::Values("dinosaur.obj", "bunny.obj", "ankylosaurus.obj", "camel.off", "kitten.obj"),
                         [](const auto& test) {
                           const std::string name = test.param;
                           return name.substr(0, name.find('.'));
                         });

TEST(StockArithmetic, PlacesNothingAndIsForeignToPairDecimater) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(sphere(2));
  const IndexedMesh before = geometry_of(mesh);
  PairDecimaterT<DoubleMesh> decimater(mesh);
  ModGarlandHeckbertT<DoubleMesh>::Handle cost;
  decimater.add(cost);
  decimater.module(cost).set_arithmetic(Arithmetic::stock);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_EQ(decimater.decimate(40), 40U);
  EXPECT_EQ(decimater.last_driver(), Driver::mesh);
  for (const OpenMesh::VertexHandle v : mesh.vertices()) {
    EXPECT_EQ(to_vec3(mesh.point(v)), before.positions[static_cast<std::size_t>(v.idx())]);
  }
}

}  // namespace
}  // namespace whittle::test
