// ModGarlandHeckbertT and ModFlipGuardT in OpenMesh's own decimaters.
#include <gtest/gtest.h>

#include <algorithm>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/McDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/MixedDecimaterT.hh>
#include <cmath>
#include <numbers>
#include <whittle/openmesh/mod_flip_guard.hh>
#include <whittle/openmesh/mod_garland_heckbert.hh>

#include "common/meshes.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

using OpenMesh::VertexHandle;

template <class MeshT>
class InStockDecimaters : public testing::Test {};
using MeshTypes = testing::Types<FloatMesh, DoubleMesh>;
TYPED_TEST_SUITE(InStockDecimaters, MeshTypes);

TYPED_TEST(InStockDecimaters, EveryDecimaterTakesTheModules) {
  using MeshT = TypeParam;
  const IndexedMesh shape = noisy_torus(32, 16, 1, 0.4, 0.02, 5);
  const auto run = [&shape](auto decimate, auto& decimater, MeshT& mesh) {
    typename ModGarlandHeckbertT<MeshT>::Handle cost;
    typename ModFlipGuardT<MeshT>::Handle guard;
    ASSERT_TRUE(decimater.add(cost));
    ASSERT_TRUE(decimater.add(guard));
    decimater.module(guard).set_cost_module(&decimater.module(cost));
    ASSERT_TRUE(decimater.initialize());
    decimate();
    mesh.garbage_collection();
    EXPECT_NEAR(static_cast<double>(mesh.n_faces()), 300, 1);
    expect_sound(mesh, "after the run");
    const IndexedMesh after = geometry_of(mesh);
    expect_same_topology(shape, after, "after the run");
    EXPECT_NEAR(signed_volume(after), signed_volume(shape), 0.05 * signed_volume(shape));
  };
  MeshT mesh = open_mesh<MeshT>(shape);
  {
    OpenMesh::Decimater::DecimaterT<MeshT> decimater(mesh);
    run([&] { decimater.decimate_to_faces(0, 300); }, decimater, mesh);
  }
  mesh = open_mesh<MeshT>(shape);
  {
    OpenMesh::Decimater::McDecimaterT<MeshT> decimater(mesh);
    decimater.set_samples(20);
    run([&] { decimater.decimate_to_faces(0, 300); }, decimater, mesh);
  }
  mesh = open_mesh<MeshT>(shape);
  {
    OpenMesh::Decimater::MixedDecimaterT<MeshT> decimater(mesh);
    decimater.set_samples(20);
    run([&] { decimater.decimate_to_faces(0, 300, 0.5F); }, decimater, mesh);
  }
}

TEST(ModGarlandHeckbert, ItsNameIsNotTheOneThatIsTreatedSpecially) {
  DoubleMesh mesh;
  EXPECT_EQ(ModGarlandHeckbertT<DoubleMesh>(mesh).name(), "GarlandHeckbert");
  EXPECT_EQ(ModFlipGuardT<DoubleMesh>(mesh).name(), "FlipGuard");
  EXPECT_FALSE(ModGarlandHeckbertT<DoubleMesh>(mesh).is_binary());
  EXPECT_TRUE(ModFlipGuardT<DoubleMesh>(mesh).is_binary());
}

TEST(ModGarlandHeckbert, WrongOptionsThrow) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(tetrahedron());
  ModGarlandHeckbertT<DoubleMesh> module(mesh);
  const double nan = std::nan("");
  QuadricOptions options;
  options.regularization = -1;
  EXPECT_THROW(module.set_options(options), std::invalid_argument);
  options = {};
  options.boundary_weight = nan;
  EXPECT_THROW(module.set_options(options), std::invalid_argument);
  EXPECT_THROW(module.set_max_cost(-1e-9), std::invalid_argument);
  EXPECT_THROW(module.set_max_cost(nan), std::invalid_argument);
  EXPECT_EQ(module.options().boundary_weight, QuadricOptions().boundary_weight);

  ModFlipGuardT<DoubleMesh> guard(mesh);
  EXPECT_THROW(guard.set_max_normal_flip_deg(0), std::invalid_argument);
  EXPECT_THROW(guard.set_max_normal_flip_deg(181), std::invalid_argument);
  EXPECT_THROW(guard.set_max_normal_flip_deg(nan), std::invalid_argument);

  mesh.set_point(VertexHandle(1), {0, nan, 0});
  EXPECT_THROW(module.initialize(), std::invalid_argument);
}

TEST(ModGarlandHeckbert, PropertiesGoWithTheModule) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(tetrahedron());
  const auto n_properties = [&mesh] {
    return std::count_if(mesh.vprops_begin(), mesh.vprops_end(), [](const auto* property) { return property; });
  };
  const auto before = n_properties();
  {
    const ModGarlandHeckbertT<DoubleMesh> module(mesh);
    EXPECT_GT(n_properties(), before);
  }
  EXPECT_EQ(n_properties(), before);
}

/// Compares every stored face normal with the face after each collapse.
template <class MeshT>
class NormalObserver : public OpenMesh::Decimater::Observer {
 public:
  explicit NormalObserver(MeshT& mesh) : OpenMesh::Decimater::Observer(1), mesh_(mesh) {}
  void notify(std::size_t) override {
    ++n_seen;
    for (const OpenMesh::FaceHandle f : mesh_.faces()) {
      const auto off = (mesh_.normal(f) - mesh_.calc_face_normal(f)).norm();
      worst_normal = std::max(worst_normal, static_cast<double>(off));
    }
  }

  std::size_t n_seen = 0;
  double worst_normal = 0;

 private:
  MeshT& mesh_;
};

TYPED_TEST(InStockDecimaters, FaceNormalsAreRightAfterEveryCollapse) {
  using MeshT = TypeParam;
  for (const Placement placement : {Placement::optimal, Placement::midpoint, Placement::endpoint}) {
    MeshT mesh = open_mesh<MeshT>(noisy_sphere(2, 0.1, 6));
    mesh.request_face_normals();
    mesh.update_face_normals();
    OpenMesh::Decimater::DecimaterT<MeshT> decimater(mesh);
    typename ModGarlandHeckbertT<MeshT>::Handle cost;
    decimater.add(cost);
    QuadricOptions options;
    options.placement = placement;
    decimater.module(cost).set_options(options);
    ASSERT_TRUE(decimater.initialize());
    NormalObserver<MeshT> observer(mesh);
    decimater.set_observer(&observer);
    decimater.decimate(100);
    EXPECT_EQ(observer.n_seen, 100U);
    EXPECT_EQ(observer.worst_normal, 0) << "placement " << static_cast<int>(placement);
  }
}

TEST(ModGarlandHeckbert, OtherModulesSeeTheMergedVertexInItsPlace) {
  // A module that compares, in its own postprocess_collapse, v1's point with the position given by the cost module.
  struct ModWitness : OpenMesh::Decimater::ModBaseT<DoubleMesh> {
    explicit ModWitness(DoubleMesh& mesh) : ModBaseT(mesh, true) {}
    void preprocess_collapse(const CollapseInfo& collapse) override {
      expected = cost->frame().to_model(cost->evaluate(collapse).position);
    }
    void postprocess_collapse(const CollapseInfo& collapse) override {
      n_moved += to_vec3(collapse.p1) != expected;
      n_wrong += to_vec3(mesh().point(collapse.v1)) != expected;
    }
    const PairCostModuleT<DoubleMesh>* cost = nullptr;
    Vec3 expected = Vec3::Zero();
    int n_moved = 0;
    int n_wrong = 0;
  };
  DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_sphere(2, 0.1, 6));
  OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
  OpenMesh::Decimater::ModHandleT<ModWitness> witness;
  ModGarlandHeckbertT<DoubleMesh>::Handle cost;
  decimater.add(witness);
  decimater.add(cost);
  decimater.module(witness).cost = &decimater.module(cost);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_EQ(decimater.decimate(100), 100U);
  EXPECT_EQ(decimater.module(witness).n_moved, 100);
  EXPECT_EQ(decimater.module(witness).n_wrong, 0);
}

/// The vertices that moved or vanished.
template <class MeshT>
std::vector<int> changed_vertices(const MeshT& mesh, const IndexedMesh& before) {
  std::vector<int> changed;
  for (int v = 0; v < static_cast<int>(mesh.n_vertices()); ++v) {
    const VertexHandle handle(v);
    const bool moved = to_vec3(mesh.point(handle)) != before.positions[static_cast<std::size_t>(v)];
    if (mesh.status(handle).deleted() || moved) changed.push_back(v);
  }
  return changed;
}

TEST(ModGarlandHeckbert, LockedAndFeatureVerticesKeepTheirPlace) {
  const IndexedMesh shape = blob(2, 5);
  for (const bool feature : {false, true}) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
    OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
    ModGarlandHeckbertT<DoubleMesh>::Handle cost;
    decimater.add(cost);
    for (const VertexHandle v : mesh.vertices()) {
      if (v.idx() % 5 != 0) continue;
      feature ? mesh.status(v).set_feature(true) : mesh.status(v).set_locked(true);
    }
    ASSERT_TRUE(decimater.initialize());
    EXPECT_GT(decimater.decimate(), 80U);
    for (const int v : changed_vertices(mesh, shape)) EXPECT_NE(v % 5, 0) << (feature ? "feature" : "locked");
    expect_sound(mesh, "after the run");
  }
}

TEST(ModGarlandHeckbert, AFeatureLineKeepsToItsVertices) {
  // A ridge along the middle of a flat strip. Its edges and vertices are features.
  IndexedMesh shape = grid(12, 4);
  for (Vec3& p : shape.positions) p.z() = p.y() == 2 ? 0.7 + 0.05 * std::sin(p.x()) : 0;
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
  ModGarlandHeckbertT<DoubleMesh>::Handle cost;
  decimater.add(cost);
  const auto on_ridge = [&mesh](VertexHandle v) { return mesh.point(v)[1] == 2; };
  for (const OpenMesh::EdgeHandle e : mesh.edges()) {
    const VertexHandle a = mesh.to_vertex_handle(mesh.halfedge_handle(e, 0));
    const VertexHandle b = mesh.to_vertex_handle(mesh.halfedge_handle(e, 1));
    if (!on_ridge(a) || !on_ridge(b)) continue;
    mesh.status(e).set_feature(true);
    for (const VertexHandle v : {a, b}) mesh.status(v).set_feature(true);
  }
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate(40), 20U);
  int n_left = 0;
  for (const VertexHandle v : mesh.vertices()) {
    if (!mesh.status(v).feature()) continue;
    ++n_left;
    EXPECT_EQ(to_vec3(mesh.point(v)), shape.positions[static_cast<std::size_t>(v.idx())]) << v.idx();
  }
  EXPECT_LT(n_left, 13) << "nothing was collapsed along the ridge";
}

TEST(ModGarlandHeckbert, BorderPlanesHoldTheOutline) {
  // A border vertex v1 moves, but only along the border: the flat rectangle stays a rectangle.
  const IndexedMesh shape = grid(10, 7);
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
  ModGarlandHeckbertT<DoubleMesh>::Handle cost;
  ModFlipGuardT<DoubleMesh>::Handle guard;
  decimater.add(cost);
  decimater.add(guard);
  decimater.module(guard).set_cost_module(&decimater.module(cost));
  decimater.module(cost).set_max_cost(1e-6);  // far above the regularisation, far below the cost of cutting a corner
  ASSERT_TRUE(decimater.initialize());
  decimater.decimate();
  const IndexedMesh after = geometry_of(mesh);
  EXPECT_LT(after.faces.size(), 20U);
  EXPECT_NEAR(surface_area(after), 70, 70 * 1e-6);
}

TEST(ModGarlandHeckbert, TheUnitOfTheMeshChangesNoCollapse) {
  // Costs scale with the fourth power of the size. In model units they would be 0 as floats below a size of 1e-9.
  const IndexedMesh shape = noisy_sphere(3, 0.05, 8);
  const auto collapses = [](const IndexedMesh& s) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(s);
    OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
    ModGarlandHeckbertT<DoubleMesh>::Handle cost;
    ModCollapsesT<DoubleMesh>::Handle recorder;
    decimater.add(cost);
    decimater.add(recorder);
    EXPECT_TRUE(decimater.initialize());
    decimater.decimate(500);
    return decimater.module(recorder).collapses;
  };
  const std::vector<Collapse> expected = collapses(shape);
  EXPECT_EQ(expected.size(), 500U);
  for (const double factor : {0x1p-60, 0x1p10, 0x1p60}) EXPECT_EQ(collapses(scaled(shape, factor)), expected) << factor;
}

TEST(ModGarlandHeckbert, MaxCostIsDistanceSquaredTimesArea) {
  // Two faces over a ridge. Contracting across it costs what the definition gives, also at any other size.
  const IndexedMesh shape = two_triangles();
  const auto first_cost = [](const IndexedMesh& s, Weights weights) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(s);
    ModGarlandHeckbertT<DoubleMesh> module(mesh);
    mesh.request_vertex_status();
    QuadricOptions options;
    options.weights = weights;
    module.set_options(options);
    module.initialize();
    const auto evaluation = module.evaluate(VertexHandle(0), VertexHandle(1), PairConstraint::first);
    return module.frame().cost_to_model(evaluation.cost, module.cost_dimension());
  };
  for (const double factor : {1e-3, 7.0, 1e6}) {
    const IndexedMesh larger = scaled(shape, factor);
    const double area = first_cost(shape, Weights::area);
    const double uniform = first_cost(shape, Weights::uniform);
    EXPECT_NEAR(first_cost(larger, Weights::area), area * std::pow(factor, 4), 1e-12 * area * std::pow(factor, 4));
    EXPECT_NEAR(first_cost(larger, Weights::uniform), uniform * factor * factor, 1e-12 * uniform * factor * factor);
  }
}

TEST(ModGarlandHeckbert, MaxCostRefusesAndTheToleranceFactorScalesIt) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_sphere(2, 0.1, 2));
  mesh.request_vertex_status();
  ModGarlandHeckbertT<DoubleMesh> module(mesh);
  module.initialize();
  const OpenMesh::Decimater::CollapseInfoT<DoubleMesh> collapse(mesh, OpenMesh::HalfedgeHandle(0));
  const double cost = module.frame().cost_to_model(module.evaluate(collapse).cost, 4);
  ASSERT_GT(cost, 0);
  EXPECT_FALSE(module.max_cost());
  EXPECT_GE(module.collapse_priority(collapse), 0);
  module.set_max_cost(cost * 1.001);
  EXPECT_GE(module.collapse_priority(collapse), 0);
  module.set_max_cost(cost * 0.999);
  EXPECT_LT(module.collapse_priority(collapse), 0);
  // The factor scales the limit that was set, not the limit scaled last. After a factor of 0 another factor works
  // again.
  module.set_max_cost(cost * 3);
  for (const double factor : {0.5, 0.0, 0.25, 0.5, 1.0}) {
    module.set_error_tolerance_factor(factor);
    EXPECT_DOUBLE_EQ(*module.max_cost(), cost * 3 * factor);
    EXPECT_EQ(module.collapse_priority(collapse) >= 0, factor * 3 > 1) << factor;
  }
  module.unset_max_cost();
  EXPECT_FALSE(module.max_cost());
}

TEST(ModFlipGuard, TheToleranceFactorScalesTheAngle) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(tetrahedron());
  ModFlipGuardT<DoubleMesh> guard(mesh);
  EXPECT_EQ(guard.max_normal_flip_deg(), 75);
  for (const double factor : {0.5, 0.0, 0.4, 1.0}) {
    guard.set_error_tolerance_factor(factor);
    EXPECT_DOUBLE_EQ(guard.max_normal_flip_deg(), 75 * factor);
  }
}

/// A hexagonal fan around vertex 0 in the plane, and the collapse of its edge 0 → 1.
struct FlatFan {
  FlatFan() {
    const VertexHandle center = mesh.add_vertex({0, 0, 0});
    for (int i = 0; i < 6; ++i) {
      const double angle = i * std::numbers::pi / 3;
      mesh.add_vertex({std::cos(angle), std::sin(angle), 0});
    }
    for (int i = 0; i < 6; ++i) mesh.add_face(center, VertexHandle(1 + i), VertexHandle(1 + (i + 1) % 6));
    mesh.request_vertex_status();
    mesh.request_edge_status();
  }
  OpenMesh::Decimater::CollapseInfoT<DoubleMesh> collapse(int v0, int v1) {
    return {mesh, mesh.find_halfedge(VertexHandle(v0), VertexHandle(v1))};
  }
  DoubleMesh mesh;
};

TEST(ModFlipGuard, WithoutAPlacementV1KeepsItsPlace) {
  FlatFan fan;
  ModFlipGuardT<DoubleMesh> guard(fan.mesh);
  EXPECT_GE(guard.collapse_priority(fan.collapse(0, 1)), 0) << "a flat convex fan collapses onto its rim";
  fan.mesh.set_point(VertexHandle(2), {0.2, 0.1, 0});  // a notch: now 0 → 1 flips the face (0, 2, 3)
  EXPECT_LT(guard.collapse_priority(fan.collapse(0, 1)), 0);
  fan.mesh.set_point(VertexHandle(3), {-0.5, 0.75, 0});
  fan.mesh.set_point(VertexHandle(2), {0.25, 0.375, 0});  // 2 is halfway between 1 and 3: that face loses its area
  EXPECT_LT(guard.collapse_priority(fan.collapse(0, 1)), 0);
  guard.set_max_normal_flip_deg(180);
  EXPECT_LT(guard.collapse_priority(fan.collapse(0, 1)), 0);
  EXPECT_EQ(to_vec3(fan.mesh.point(VertexHandle(0))), Vec3::Zero()) << "the guard moved a vertex";
}

TEST(ModFlipGuard, WithAPlacementBothStarsAreTested) {
  // Every direction of every edge of a bumpy shape, compared with the same test written over the list of faces.
  const IndexedMesh shape = noisy_torus(16, 8, 1, 0.4, 0.15, 3);
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  mesh.request_vertex_status();
  ModGarlandHeckbertT<DoubleMesh> cost(mesh);
  cost.initialize();
  ModFlipGuardT<DoubleMesh> guard(mesh);
  guard.set_cost_module(&cost);
  guard.set_max_normal_flip_deg(60);
  int n_refused_for_v1_alone = 0;
  int n_refused = 0;
  for (const OpenMesh::HalfedgeHandle h : mesh.halfedges()) {
    const OpenMesh::Decimater::CollapseInfoT<DoubleMesh> collapse(mesh, h);
    const Vec3 to = cost.frame().to_model(cost.evaluate(collapse).position);
    const auto worst_angle = [&](VertexHandle v, VertexHandle other) {
      double worst = 0;
      for (const Triangle& face : shape.faces) {
        const auto has = [&face](VertexHandle w) { return std::ranges::count(face, static_cast<Index>(w.idx())) > 0; };
        if (!has(v) || has(other)) continue;
        std::array<Vec3, 3> p;
        std::array<Vec3, 3> q;
        for (std::size_t i = 0; i < 3; ++i) {
          p[i] = q[i] = shape.positions[face[i]];
          if (face[i] == static_cast<Index>(v.idx())) q[i] = to;
        }
        const Vec3 n0 = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
        const Vec3 n1 = (q[1] - q[0]).cross(q[2] - q[0]).normalized();
        worst = std::max(worst, std::atan2(n0.cross(n1).norm(), n0.dot(n1)) * 180 / std::numbers::pi);
      }
      return worst;
    };
    const double at_v0 = worst_angle(collapse.v0, collapse.v1);
    const double at_v1 = worst_angle(collapse.v1, collapse.v0);
    EXPECT_EQ(guard.collapse_priority(collapse) < 0, std::max(at_v0, at_v1) > 60) << at_v0 << ' ' << at_v1;
    n_refused += std::max(at_v0, at_v1) > 60;
    n_refused_for_v1_alone += at_v1 > 60 && at_v0 <= 60;
  }
  EXPECT_GT(n_refused_for_v1_alone, 0) << "the shape tests nothing";
  EXPECT_LT(n_refused, static_cast<int>(mesh.n_halfedges()));
  EXPECT_EQ(geometry_of(mesh).positions, shape.positions) << "the guard moved a vertex";
}

}  // namespace
}  // namespace whittle::test
