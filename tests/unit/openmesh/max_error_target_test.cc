// DecimateTarget::max_error in PairDecimaterT.
#include <gtest/gtest.h>

#include <algorithm>

#include <whittle/openmesh/mod_max_error.hh>

#include "common/decimation.hh"
#include "common/modules.hh"
#include "common/within_error.hh"
#include "support/shapes/shapes.hh"

namespace whittle::test {
namespace {

template <class MeshT>
class MaxErrorTarget : public testing::Test {};
using Scalars = testing::Types<FloatMesh, DoubleMesh>;
TYPED_TEST_SUITE(MaxErrorTarget, Scalars);

/// A mesh that may be cut into copies of vertices, and PairDecimaterT with a cost module.
template <class MeshT>
struct Prepared {
  explicit Prepared(const IndexedMesh& shape, const CostOptions& cost = {}) : decimater(mesh) {
    (void)to_open_mesh(shape, mesh);
    input = geometry_of(mesh);
    add_cost(decimater, cost);
    EXPECT_TRUE(decimater.initialize());
  }
  MeshT mesh;
  IndexedMesh input;
  PairDecimaterT<MeshT> decimater;
};

TYPED_TEST(MaxErrorTarget, IsKeptByTheMeshAsItIsWritten) {
  for (const NamedMesh& shape : all_meshes()) {
    for (const double share : {0.01, 0.06}) {
      Prepared<TypeParam> run(shape.mesh);
      const double limit = share_of_diagonal(run.input, share);
      const DecimateResult result = run.decimater.decimate(DecimateTarget::max_error(limit));
      EXPECT_EQ(run.decimater.last_driver(), Driver::engine);
      EXPECT_EQ(result.proven_error, limit) << shape.name;
      expect_within(run.input, geometry_of(run.mesh), limit, shape.name);
      expect_sound(run.mesh, shape.name);
    }
  }
}

TYPED_TEST(MaxErrorTarget, IsKeptFarFromTheOrigin) {
  Prepared<TypeParam> run(moved(noisy_sphere(3, 0.1, 4), {3000, -2000, 1000}));
  const double limit = share_of_diagonal(run.input, 0.01);
  EXPECT_GT(run.decimater.decimate(DecimateTarget::max_error(limit)).n_contractions, 50U);
  expect_within(run.input, geometry_of(run.mesh), limit, "");
}

TYPED_TEST(MaxErrorTarget, IsAboveWhatRoundingMayMove) {
  Prepared<TypeParam> run(moved(noisy_sphere(2, 0.1, 4), {3000, -2000, 1000}));
  const double epsilon = std::numeric_limits<typename TypeParam::Scalar>::epsilon();
  EXPECT_THROW(run.decimater.decimate(DecimateTarget::max_error(1000 * epsilon)), std::invalid_argument);
  EXPECT_THROW(run.decimater.decimate(DecimateTarget::max_error(0)), std::invalid_argument);
}

TYPED_TEST(MaxErrorTarget, IsKeptWithEachCost) {
  for (const NamedCost& cost : named_costs()) {
    Prepared<TypeParam> run(noisy_torus(16, 8, 1.0, 0.4, 0.05, 11), cost.options);
    const double limit = share_of_diagonal(run.input, 0.04);
    EXPECT_GT(run.decimater.decimate(DecimateTarget::max_error(limit)).n_contractions, 20U) << cost.name;
    expect_within(run.input, geometry_of(run.mesh), limit, cost.name);
    expect_sound(run.mesh, cost.name);
  }
}

TYPED_TEST(MaxErrorTarget, IsKeptWithEndpointPlacement) {
  CostOptions cost;
  cost.quadric.placement = Placement::endpoint;
  Prepared<TypeParam> run(blob(2, 3), cost);
  const double limit = share_of_diagonal(run.input, 0.04);
  EXPECT_GT(run.decimater.decimate(DecimateTarget::max_error(limit)).n_contractions, 20U);
  expect_within(run.input, geometry_of(run.mesh), limit, "");
  for (const OpenMesh::VertexHandle v : run.mesh.vertices()) EXPECT_TRUE(unmoved(run.mesh, run.input, v));
}

TYPED_TEST(MaxErrorTarget, IsKeptWithThresholdPairs) {
  Prepared<TypeParam> run(boxes(3, 2, 0.05));
  run.decimater.set_pair_threshold(0.06);
  const double limit = share_of_diagonal(run.input, 0.05);
  const DecimateResult result = run.decimater.decimate(DecimateTarget::max_error(limit));
  EXPECT_GT(result.threshold_pairs.contracted, 0U);
  expect_within(run.input, geometry_of(run.mesh), limit, "");
}

TYPED_TEST(MaxErrorTarget, GivesTheEnginesResult) {
  const IndexedMesh shape = noisy_torus(24, 12, 1.0, 0.4, 0.05, 11);
  Prepared<TypeParam> run(shape, {Cost::memoryless, {}, 0, 0});
  const double limit = share_of_diagonal(run.input, 0.02);
  run.decimater.decimate(DecimateTarget::max_error(limit));
  DecimateOptions options;
  options.cost = Cost::memoryless;
  options.order = Order::exact;
  const whittle::Decimation alone = decimate(run.input, DecimateTarget::max_error(limit), options);
  // The limit differs by what rounding may add.
  EXPECT_NEAR(static_cast<double>(run.decimater.result().n_faces), static_cast<double>(alone.mesh.faces.size()),
              0.05 * static_cast<double>(alone.mesh.faces.size()));
}

TYPED_TEST(MaxErrorTarget, TheListenerIsToldOfWhatStands) {
  Prepared<TypeParam> run(noisy_sphere(3, 0.1, 4));
  std::vector<Contraction> told;
  run.decimater.set_listener([&told](const Contraction& made) { told.push_back(made); });
  const double limit = share_of_diagonal(run.input, 0.02);
  const DecimateResult result = run.decimater.decimate(DecimateTarget::max_error(limit));
  EXPECT_EQ(told.size(), result.n_contractions);
  std::vector<bool> is_removed(run.mesh.n_vertices());
  for (const Contraction& made : told) {
    EXPECT_FALSE(is_removed[made.removed] || is_removed[made.survivor]);
    is_removed[made.removed] = true;
  }
  for (int v = 0; v < static_cast<int>(run.mesh.n_vertices()); ++v) {
    EXPECT_EQ(run.mesh.status(OpenMesh::VertexHandle(v)).deleted(), is_removed[static_cast<std::size_t>(v)]);
  }
}

TYPED_TEST(MaxErrorTarget, AttributesAreBlended) {
  Prepared<TypeParam> run(noisy_sphere(3, 0.1, 4));
  run.mesh.request_vertex_texcoords2D();
  for (const OpenMesh::VertexHandle v : run.mesh.vertices()) {
    const Vec3 p = to_vec3(run.mesh.point(v));
    run.mesh.set_texcoord2D(v, {static_cast<float>(p.x()), static_cast<float>(p.y())});
  }
  const double limit = share_of_diagonal(run.input, 0.02);
  run.decimater.decimate(DecimateTarget::max_error(limit));
  for (const OpenMesh::VertexHandle v : run.mesh.vertices()) {
    const Vec3 p = to_vec3(run.mesh.point(v));
    const auto uv = run.mesh.texcoord2D(v);
    EXPECT_NEAR(uv[0], p.x(), 0.3) << "linear in the position but for steps off the edge";
    EXPECT_NEAR(uv[1], p.y(), 0.3);
  }
}

TYPED_TEST(MaxErrorTarget, AnObserverCanAbort) {
  Prepared<TypeParam> run(noisy_sphere(5, 0.02, 4));
  StoppingObserver observer(1000, 100);
  run.decimater.set_observer(&observer);
  const DecimateResult result = run.decimater.decimate(DecimateTarget::max_error(share_of_diagonal(run.input, 0.02)));
  EXPECT_EQ(result.stop, StopReason::cancelled);
  EXPECT_FALSE(result.proven_error);
  EXPECT_EQ(geometry_of(run.mesh).faces.size(), result.n_faces);
  expect_sound(run.mesh, "");
  expect_same_topology(run.input, geometry_of(run.mesh), "");
}

TYPED_TEST(MaxErrorTarget, ASecondRunMeasuresFromTheMeshAsItIs) {
  Prepared<TypeParam> run(noisy_sphere(3, 0.1, 4));
  run.decimater.decimate_to_faces(0, 600);
  const IndexedMesh before = geometry_of(run.mesh);
  const double limit = share_of_diagonal(run.input, 0.02);
  EXPECT_GT(run.decimater.decimate(DecimateTarget::max_error(limit)).n_contractions, 20U);
  expect_within(before, geometry_of(run.mesh), limit, "");
  EXPECT_EQ(run.decimater.decimate(DecimateTarget::faces(100)).n_faces, 100U) << "and others follow";
  expect_sound(run.mesh, "");
}

TYPED_TEST(MaxErrorTarget, OtherLimitsEndTheRunFirst) {
  Prepared<TypeParam> run(noisy_sphere(3, 0.1, 4));
  const double limit = share_of_diagonal(run.input, 0.02);
  const DecimateResult result = run.decimater.decimate(DecimateTarget::faces(1000).or_max_error(limit));
  EXPECT_EQ(result.stop, StopReason::target);
  EXPECT_EQ(result.n_faces, 1000U);
  EXPECT_EQ(result.proven_error, limit);
}

TYPED_TEST(MaxErrorTarget, TheLesserOfTargetAndModuleCounts) {
  for (const double factor : {0.5, 2.0}) {
    Prepared<TypeParam> run(noisy_sphere(3, 0.1, 4));
    const double limit = share_of_diagonal(run.input, 0.02);
    add_module<ModMaxErrorT<TypeParam>>(run.decimater).set_max_error(factor * limit);
    ASSERT_TRUE(run.decimater.initialize());
    const DecimateResult result = run.decimater.decimate(DecimateTarget::max_error(limit));
    EXPECT_EQ(result.proven_error, std::min(factor, 1.0) * limit);
    expect_within(run.input, geometry_of(run.mesh), *result.proven_error, "");
  }
}

TYPED_TEST(MaxErrorTarget, NeedsTheEngineDriver) {
  Prepared<TypeParam> run(noisy_sphere(2, 0.1, 4));
  run.decimater.set_driver(Driver::mesh);
  try {
    run.decimater.decimate(DecimateTarget::max_error(0.1));
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::logic_error& e) {
    EXPECT_NE(std::string(e.what()).find("ModMaxErrorT"), std::string::npos) << e.what();
  }
  // What the message advises:
  add_module<ModMaxErrorT<TypeParam>>(run.decimater).set_max_error(0.1);
  ASSERT_TRUE(run.decimater.initialize());
  EXPECT_GT(run.decimater.decimate(), 20U);
  expect_within(run.input, geometry_of(run.mesh), 0.1, "");
}

}  // namespace
}  // namespace whittle::test
