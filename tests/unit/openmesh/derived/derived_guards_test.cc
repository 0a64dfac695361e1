// Classes that users derive from our guards: what they override counts, in each decimater.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <whittle/openmesh/mod_attributes.hh>
#include <whittle/openmesh/mod_recorder.hh>

#include "derived.hh"

namespace whittle::test::derived {
namespace {

template <class ModuleT>
class DerivedGuards : public testing::Test {};
using Guards = testing::Types<ModFlipGuardT<Mesh>, ModRadiusRatioT<Mesh>, ModValenceT<Mesh>, ModMaxErrorT<Mesh>,
                              ModAttributesT<Mesh>, ModRecorderT<Mesh>>;
TYPED_TEST_SUITE(DerivedGuards, Guards);

TYPED_TEST(DerivedGuards, RefuseCollapsesInEachDecimater) { expect_region_kept_by_each_decimater<TypeParam>(false); }

TEST(DerivedMaxError, MustCallWhatItOverrides) {
  expect_that_calls_are_missed<Forgetful<ModMaxErrorT<Mesh>, true>>();
  expect_that_calls_are_missed<Forgetful<ModMaxErrorT<Mesh>, false>>();
}

// Guards --------------------------------------------------------------------------------------------------------------

/// The largest angle in degrees by which a contraction turned a face.
template <class... ModuleTs, class SetUp>
double largest_turn(const SetUp& set_up) {
  Mesh mesh = open_mesh<Mesh>(noisy_sphere(3, 0.3, 2));
  PairDecimaterT<Mesh> decimater(mesh);
  decimater.set_driver(Driver::mesh);
  add_module<ModGarlandHeckbertT<Mesh>>(decimater);
  set_up(add_module<ModuleTs>(decimater)...);
  std::map<int, Mesh::Normal> before;
  double least_cosine = 1;
  const auto look = [&](const Contraction&) {
    for (const OpenMesh::FaceHandle f : mesh.faces()) {
      const auto normal = mesh.calc_face_normal(f);
      const auto [known, is_new] = before.try_emplace(f.idx(), normal);
      if (!is_new) least_cosine = std::min(least_cosine, known->second | normal);
      known->second = normal;
    }
  };
  look({});
  decimater.set_listener(look);
  EXPECT_TRUE(decimater.initialize());
  decimater.decimate_to(30);
  return std::acos(least_cosine) * 180 / std::numbers::pi;
}

TEST(DerivedFlipGuard, TakesThePlaceOfOurs) {
  using Guard = ByFunction<ModFlipGuardT<Mesh>>;
  const auto turn_of = [](double angle_deg, const Priority& priority) {
    return largest_turn<Guard>([&](Guard& guard) {
      guard.set_max_normal_flip_deg(angle_deg);
      guard.priority = priority;
    });
  };
  EXPECT_LE(turn_of(40, own_value), 40.001);
  const double wide = turn_of(150, own_value);
  EXPECT_GT(wide, 76) << "overruled by ours";
  EXPECT_LE(wide, 150.001);
  EXPECT_GT(turn_of(40, [](const Info&, const auto&) { return 0.F; }), 76) << "overruled by ours";
}

TEST(FlipGuards, AllHoldIfThereAreSeveral) {
  using Guard = ModFlipGuardT<Mesh>;
  for (const bool first : {true, false}) {
    const double turn = largest_turn<Guard, Guard>([first](Guard& a, Guard& b) {
      a.set_max_normal_flip_deg(first ? 40 : 120);
      b.set_max_normal_flip_deg(first ? 120 : 40);
    });
    EXPECT_LE(turn, 40.001);
  }
}

TEST(FlipGuards, LookAtWhereTheVertexGoesWhateverTheyWereTold) {
  // `set_cost_module` is for OpenMesh's decimaters. The module would say where the vertex goes at first, but here the
  // second choice is tried, too.
  const auto run = [](bool tells_cost) {
    Mesh mesh = open_mesh<Mesh>(noisy_sphere(3, 0.3, 2));
    PairDecimaterT<Mesh> decimater(mesh);
    auto& cost = add_module<ModMemorylessT<Mesh>>(decimater);
    auto& guard = add_module<ByFunction<ModFlipGuardT<Mesh>>>(decimater);
    guard.priority = own_value;
    if (tells_cost) guard.set_cost_module(&cost);
    std::vector<Contraction> contractions;
    decimater.set_listener([&](const Contraction& made) { contractions.push_back(made); });
    EXPECT_TRUE(decimater.initialize());
    decimater.decimate_to(60);
    return contractions;
  };
  expect_same_contractions(run(false), run(true), "sphere");
}

TEST(DerivedMaxError, HasProofAndStopReason) {
  using Guard = ByFunction<ModMaxErrorT<Mesh>>;
  const auto limit_by = [](const Priority& priority) {
    return run<ModGarlandHeckbertT<Mesh>>(open_mesh<Mesh>(shape()), DecimateTarget::as_far_as_possible(), nullptr,
                                          [&](PairDecimaterT<Mesh>& decimater) {
                                            Guard& guard = add_module<Guard>(decimater);
                                            guard.priority = priority;
                                            guard.set_max_error(0.02);
                                          });
  };
  const Outcome own = limit_by(own_value);
  EXPECT_GT(own.contractions.size(), 20U);
  EXPECT_EQ(own.result.proven_error, 0.02);
  EXPECT_EQ(own.result.stop, StopReason::error);
  EXPECT_GT(own.result.refusals[Refusal::error], 0U);

  const Outcome loose = limit_by([](const Info&, const std::function<float()>&) { return 0.F; });
  EXPECT_FALSE(loose.result.proven_error) << "all was allowed";

  const Outcome strict = limit_by([](const Info&, const std::function<float()>&) { return illegal; });
  EXPECT_EQ(strict.result.proven_error, 0.02) << "nothing was changed";
  EXPECT_EQ(strict.result.stop, StopReason::exhausted);
  EXPECT_EQ(strict.result.refusals[Refusal::error], 0U);
  ASSERT_EQ(strict.refusals.size(), 1U);
  EXPECT_EQ(strict.refusals[0].module, "MaxError");
}

TEST(DerivedModules, NeedTheMeshDriver) {
  Mesh mesh = open_mesh<Mesh>(shape());
  PairDecimaterT<Mesh> decimater(mesh);
  add_module<ModGarlandHeckbertT<Mesh>>(decimater);
  auto& guard = add_module<ByFunction<ModMaxErrorT<Mesh>>>(decimater);
  guard.priority = own_value;
  guard.set_max_error(0.02);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_THAT(decimater.engine_obstacle(), testing::HasSubstr("MaxError"));
  decimater.set_driver(Driver::engine);
  EXPECT_THROW(decimater.decimate(), std::logic_error);
}
/// A flip guard that refuses everything.
template <class MeshT>
class ModRefuseT : public ModFlipGuardT<MeshT> {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<ModRefuseT>;
  explicit ModRefuseT(MeshT& mesh) : ModFlipGuardT<MeshT>(mesh) {}
  float collapse_priority(const OpenMesh::Decimater::CollapseInfoT<MeshT>&) override { return -1; }
};

TEST(DerivedModules, AGuardDerivedFromOursIsAsked) {
  Mesh mesh = open_mesh<Mesh>(torus(14, 8));
  PairDecimaterT<Mesh> decimater(mesh);
  add_module<ModGarlandHeckbertT<Mesh>>(decimater);
  add_module<ModRefuseT<Mesh>>(decimater);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_THAT(decimater.engine_obstacle(), testing::HasSubstr("FlipGuard"));
  EXPECT_EQ(decimater.decimate(), 0U);
}

}  // namespace
}  // namespace whittle::test::derived
