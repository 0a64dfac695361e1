// Where the vertices of a scene are in a pose.
#include "whittle/gltf/pose.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "assets.hh"
#include "mesh_comparison.hh"
#include "scene_builder.hh"

namespace whittle::gltf::test {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

constexpr double exact = 1e-12;                                 // of numbers that are exact in 32 bits
constexpr double rounded = 1e-6;                                // of others
const auto half = static_cast<float>(std::numbers::sqrt2 / 2);  // cosine and sine of half a right angle

std::vector<double> numbers_of(const IndexedMesh& mesh) {
  std::vector<double> numbers;
  for (const Vec3& p : mesh.positions) numbers.insert(numbers.end(), p.begin(), p.end());
  return numbers;
}

/// The vertices of a scene, one after another, at a moment of its only animation.
std::vector<double> at(const SceneBuilder& scene, double seconds) {
  const Asset asset = scene.asset();
  const Poser poser(asset);
  return numbers_of(poser.mesh(poser.animated({0, seconds})));
}

std::vector<double> at_rest(const SceneBuilder& scene) {
  const Asset asset = scene.asset();
  const Poser poser(asset);
  return numbers_of(poser.mesh(poser.rest()));
}

auto are(const std::vector<double>& numbers, double tolerance = exact) {
  return Pointwise(DoubleNear(tolerance), numbers);
}

/// Joint 1 of the bar turns about z, from 0 to 90 degrees in two seconds.
SceneBuilder turning_bar() {
  SceneBuilder scene = bar();
  scene.animate(2, "rotation", {0, 2}, scene.floats("VEC4", {0, 0, 0, 1, 0, 0, half, half}));
  return scene;
}

TEST(Pose, BendsASkin) {
  EXPECT_THAT(at_rest(bar()), are({0, 0, 0, 1, 0, 0, 2, 0, 0})) << "the node's own place doesn't count";
  EXPECT_THAT(at(turning_bar(), 0), are({0, 0, 0, 1, 0, 0, 2, 0, 0}));
  EXPECT_THAT(at(turning_bar(), 2), are({0, 0, 0, 1, 0, 0, 1, 1, 0}, rounded));
  const double c = std::cos(std::numbers::pi / 4);
  EXPECT_THAT(at(turning_bar(), 1), are({0, 0, 0, 1, 0, 0, 1 + c, c, 0}, rounded)) << "half the angle at half the time";
  const double twelfth = std::numbers::pi / 12;
  EXPECT_THAT(at(turning_bar(), 1.0 / 3),
              are({0, 0, 0, 1, 0, 0, 1 + std::cos(twelfth), std::sin(twelfth), 0}, rounded));
}

TEST(Pose, WeighsJoints) {
  SceneBuilder scene = bar();
  scene.animate(2, "translation", {0, 1}, scene.floats("VEC3", {1, 0, 0, 1, 4, 0}));
  EXPECT_THAT(at(scene, 1), are({0, 0, 0, 1, 2, 0, 2, 4, 0}));
}

TEST(Pose, MakesTheSumOfWeightsOne) {
  SceneBuilder scene = bar();
  scene.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
      scene.floats("VEC4", {2, 0, 0, 0, 3, 3, 0, 0, 0, 0, 0, 0});
  EXPECT_THAT(at_rest(scene), are({0, 0, 0, 1, 0, 0, 102, 0, 0})) << "a vertex without joints is where the node has it";
}

TEST(Pose, TakesNoInverseBindMatricesAsIdentity) {
  SceneBuilder scene = bar();
  scene.json["skins"][0].erase("inverseBindMatrices");
  EXPECT_THAT(at_rest(scene), are({0, 0, 0, 1.5, 0, 0, 3, 0, 0}));
}

TEST(Pose, BlendsMorphTargets) {
  SceneBuilder scene = morphing_triangle();
  EXPECT_THAT(at_rest(scene), are({0, 0, 0, 1, 0, 0, 0, 1, 0}));
  scene.json["meshes"][0]["weights"] = {0.5, 0.25};
  EXPECT_THAT(at_rest(scene), are({0, 0, 0.5, 2, 0, 0.5, 0, 1, 0.5})) << "the mesh's weights";
  scene.json["nodes"][0]["weights"] = {2};
  EXPECT_THAT(at_rest(scene), are({0, 0, 2, 1, 0, 2, 0, 1, 2})) << "the node's weights";
  scene.animate(0, "weights", {0, 1}, scene.floats("SCALAR", {0, 0, 1, 0.5F}));
  EXPECT_THAT(at(scene, 1), are({0, 0, 1, 3, 0, 1, 0, 1, 1})) << "those of the animation";
  EXPECT_THAT(at(scene, 0.5), are({0, 0, 0.5, 2, 0, 0.5, 0, 1, 0.5}));
}

TEST(Pose, MorphsBeforeItBends) {
  SceneBuilder scene = turning_bar();
  scene.json["meshes"][0]["primitives"][0]["targets"] = {
      {{"POSITION", scene.floats("VEC3", {0, 0, 0, 0, 0, 0, 1, 0, 0})}}};
  scene.json["meshes"][0]["weights"] = {1};
  EXPECT_THAT(at(scene, 2), are({0, 0, 0, 1, 0, 0, 1, 2, 0}, rounded));
}

TEST(Pose, ReadsSparseTargets) {
  SceneBuilder scene = morphing_triangle();
  const std::size_t index = scene.bytes("SCALAR", {2});
  const std::size_t value = scene.floats("VEC3", {0, 8, 0});
  Json& target = scene.json["accessors"][1];
  target.erase("bufferView");
  target["sparse"] = {
      {"count", 1}, {"indices", {{"bufferView", index}, {"componentType", 5121}}}, {"values", {{"bufferView", value}}}};
  scene.json["meshes"][0]["weights"] = {0.5};
  EXPECT_THAT(at_rest(scene), are({0, 0, 0, 1, 0, 0, 0, 5, 0}));
}

/// The first vertex of a triangle whose node is moved by an animation.
std::vector<double> moved(const std::vector<float>& times, const std::vector<float>& values,
                          const std::string& interpolation, double seconds) {
  SceneBuilder scene = morphing_triangle();
  scene.animate(0, "translation", times, scene.floats("VEC3", values), interpolation);
  std::vector<double> numbers = at(scene, seconds);
  numbers.resize(3);
  return numbers;
}

TEST(Pose, InterpolatesLinearly) {
  const std::vector<float> times{1, 2, 4};
  const std::vector<float> values{0, 0, 0, 1, 2, 3, 5, 2, 3};
  EXPECT_THAT(moved(times, values, "LINEAR", 0), are({0, 0, 0})) << "before the first time";
  EXPECT_THAT(moved(times, values, "LINEAR", 1.5), are({0.5, 1, 1.5}));
  EXPECT_THAT(moved(times, values, "LINEAR", 2), are({1, 2, 3}));
  EXPECT_THAT(moved(times, values, "LINEAR", 3), are({3, 2, 3}));
  EXPECT_THAT(moved(times, values, "LINEAR", 9), are({5, 2, 3})) << "after the last time";
}

TEST(Pose, StepsAtTheTimesOfKeys) {
  const std::vector<float> times{1, 2, 4};
  const std::vector<float> values{7, 0, 0, 1, 2, 3, 5, 2, 3};
  EXPECT_THAT(moved(times, values, "STEP", 0), are({7, 0, 0}));
  EXPECT_THAT(moved(times, values, "STEP", 1.75), are({7, 0, 0}));
  EXPECT_THAT(moved(times, values, "STEP", 2), are({1, 2, 3}));
  EXPECT_THAT(moved(times, values, "STEP", 4), are({5, 2, 3}));
}

TEST(Pose, FollowsCubicSplines) {
  // A key: the tangent that arrives, the value, the tangent that leaves.
  const std::vector<float> values{9, 9, 9, 1, 0, 0, 2, 4, 0,  //
                                  0, 8, 0, 3, 1, 0, 9, 9, 9};
  const std::vector<float> times{0, 2};
  EXPECT_THAT(moved(times, values, "CUBICSPLINE", 0), are({1, 0, 0}));
  EXPECT_THAT(moved(times, values, "CUBICSPLINE", 2), are({3, 1, 0}));
  // At half the time both values weigh 1/2, and the tangents 1/8 and -1/8 of the two seconds.
  EXPECT_THAT(moved(times, values, "CUBICSPLINE", 1), are({2 + 0.5, 0.5 + 1 - 2, 0}));
  // At a quarter: 27/32 and 5/32, 9/64 and -3/64.
  EXPECT_THAT(moved(times, values, "CUBICSPLINE", 0.5), are({42.0 / 32 + 36.0 / 64, 5.0 / 32 + (72.0 - 48.0) / 64, 0}));
}

TEST(Pose, FollowsCubicSplinesOfRotationsAndWeights) {
  SceneBuilder scene = bar();
  scene.animate(2, "rotation", {0, 1}, scene.floats("VEC4", {0, 0, 0, 0, 0, 0, 0,    1,    0, 0, 0, 0,  //
                                                             0, 0, 0, 0, 0, 0, half, half, 0, 0, 0, 0}),
                "CUBICSPLINE");
  const double c = std::cos(std::numbers::pi / 4);
  EXPECT_THAT(at(scene, 0.5), are({0, 0, 0, 1, 0, 0, 1 + c, c, 0}, rounded)) << "a unit quaternion again";
  SceneBuilder morph = morphing_triangle();
  morph.animate(0, "weights", {0, 1}, morph.floats("SCALAR", {0, 0, 1, 0, 0, 0, 0, 0, 3, 1, 0, 0}), "CUBICSPLINE");
  EXPECT_THAT(at(morph, 0.5), are({0, 0, 2, 3, 0, 2, 0, 1, 2})) << "tangents and values of both targets together";
}

TEST(Pose, ReadsRotationsOfIntegers) {
  SceneBuilder scene = bar();
  scene.animate(2, "rotation", {0, 1}, scene.fractions("VEC4", {0, 0, 0, 32767, 0, 0, 23170, 23170}));
  EXPECT_THAT(at(scene, 1), are({0, 0, 0, 1, 0, 0, 1, 1, 0}, 1e-4));
}

TEST(Pose, TurnsTheShorterWay) {
  SceneBuilder scene = bar();
  scene.animate(2, "rotation", {0, 1}, scene.floats("VEC4", {0, 0, 0, 1, 0, 0, -half, -half}));
  const double c = std::cos(std::numbers::pi / 4);
  EXPECT_THAT(at(scene, 0.5), are({0, 0, 0, 1, 0, 0, 1 + c, c, 0}, rounded));
}

TEST(Pose, MovesChildrenWithTheirParents) {
  SceneBuilder scene = morphing_triangle();
  scene.json["nodes"] = {{{"children", {1}}, {"scale", {2, 2, 2}}},
                         {{"children", {2}}, {"translation", {0, 0, 5}}},
                         {{"mesh", 0}, {"rotation", {0, 0, half, half}}}};
  EXPECT_THAT(at_rest(scene), are({0, 0, 10, 0, 2, 10, -2, 0, 10}, rounded));
  scene.animate(0, "scale", {0}, scene.floats("VEC3", {1, 1, 3}));
  EXPECT_THAT(at(scene, 0), are({0, 0, 15, 0, 1, 15, -1, 0, 15}, rounded));
  scene.json["animations"].clear();
  scene.animate(1, "translation", {0}, scene.floats("VEC3", {0, 0, 0}));
  EXPECT_THAT(at(scene, 0), are({0, 0, 0, 0, 2, 0, -2, 0, 0}, rounded));
}

TEST(Pose, AtRestIsWhereNodesPlaceMeshes) {
  const auto files = asset_files({"gltf-tiny", "gltf-quirky"});
  WHITTLE_NEEDS_ASSETS(files);
  std::size_t n_compared = 0;
  for (const auto& file : files) {
    const Asset asset = Asset::read(file);
    const Poser poser(asset);
    if (poser.has_skins() || poser.has_morph_targets()) continue;
    IndexedMesh placed;
    std::size_t n_faces = 0;
    for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
      const IndexedMesh mesh = asset.triangles(m);
      for (const Eigen::Matrix4d& matrix : asset.world_transforms(m)) {
        n_faces += mesh.faces.size();
        for (const Vec3& p : mesh.positions) placed.positions.push_back(Eigen::Affine3d(matrix) * p);
      }
    }
    if (n_faces == 0) continue;
    const IndexedMesh scene = poser.mesh(poser.rest());
    EXPECT_EQ(scene.faces.size(), n_faces) << asset_name(file);
    EXPECT_LE(largest_difference(scene, placed), 1e-9) << asset_name(file);
    ++n_compared;
  }
  EXPECT_GT(n_compared, 20U);
}

TEST(WorldTransforms, AreThoseOfTheFirstJointWhereASkinMovesTheMesh) {
  SceneBuilder scene = bar();
  EXPECT_EQ(scene.asset().world_transforms(0).at(0), Eigen::Matrix4d::Identity()) << "the node's place doesn't count";
  scene.json["nodes"][1]["translation"] = {0, 7, 0};
  EXPECT_EQ(scene.asset().world_transforms(0).at(0)(1, 3), 7);
  scene.json["skins"][0]["joints"] = {1, 99};
  EXPECT_EQ(scene.asset().world_transforms(0).at(0)(0, 3), 100) << "a skin that is wrong doesn't count";
}

TEST(Pose, OfAssetsWithoutNodesHasAllMeshes) {
  SceneBuilder scene = morphing_triangle();
  scene.json.erase("nodes");
  EXPECT_THAT(at_rest(scene), are({0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST(Pose, SaysWhatCanMove) {
  const Asset bent = turning_bar().asset();
  EXPECT_TRUE(Poser(bent).has_skins() && Poser(bent).is_animated() && !Poser(bent).has_morph_targets());
  const Asset morphing = morphing_triangle().asset();
  EXPECT_TRUE(!Poser(morphing).has_skins() && !Poser(morphing).is_animated() && Poser(morphing).has_morph_targets());
  SceneBuilder scene = bar();
  scene.json["nodes"][0].erase("skin");
  const Asset stiff = scene.asset();
  EXPECT_FALSE(Poser(stiff).has_skins()) << "no node has the skin";
}

TEST(Pose, SpreadsMomentsOverAllAnimations) {
  SceneBuilder scene = bar();
  const std::size_t values = scene.floats("VEC3", {0, 0, 0, 1, 0, 0});
  scene.animate(1, "translation", {1, 2}, values);
  scene.animate(2, "translation", {0, 3}, values);
  scene.json["animations"][1]["name"] = "walk\n";
  const Asset asset = scene.asset();
  const Poser poser(asset);
  EXPECT_EQ(poser.animation_name(0), "animation 0");
  EXPECT_EQ(poser.animation_name(1), "walk ");
  std::vector<std::size_t> animations;
  std::vector<double> times;
  for (const AnimationTime& moment : poser.moments(4)) {
    animations.push_back(moment.animation);
    times.push_back(moment.seconds);
  }
  EXPECT_THAT(animations, ElementsAre(0, 1, 1, 1));
  EXPECT_THAT(times, are({1.5, 0.5, 1.5, 2.5}));
}

TEST(Pose, SpreadsMomentsOverAnimationsThatTakeNoTime) {
  SceneBuilder scene = bar();
  const std::size_t value = scene.floats("VEC3", {0, 0, 0});
  for (const float time : {3.0F, 4.0F}) scene.animate(1, "translation", {time}, value);
  const Asset asset = scene.asset();
  const auto moments = Poser(asset).moments(4);
  ASSERT_EQ(moments.size(), 4U);
  EXPECT_EQ(moments[1].animation, 0U);
  EXPECT_EQ(moments[1].seconds, 3);
  EXPECT_EQ(moments[2].animation, 1U);
  EXPECT_EQ(moments[2].seconds, 4);
}

TEST(Pose, TurnsJointsThatNothingAnimates) {
  const Asset asset = bar().asset();
  const Poser poser(asset);
  double sum = 0;
  constexpr std::size_t n_poses = 200;
  for (std::size_t k = 0; k < n_poses; ++k) {
    const Pose pose = poser.artificial(k);
    EXPECT_EQ(pose.nodes[0], poser.rest().nodes[0]) << "no joint";
    const Eigen::Matrix4d turn = poser.rest().nodes[2].inverse() * pose.nodes[2];
    EXPECT_LT((turn.topRightCorner<3, 1>().norm()), exact) << "about its own origin";
    const double angle = Eigen::AngleAxisd(turn.topLeftCorner<3, 3>()).angle();
    EXPECT_LE(angle, std::numbers::pi / 6 + exact);
    sum += angle;
    EXPECT_NE(pose.nodes[1](0, 1), pose.nodes[2](0, 1)) << "joints turn differently";
    EXPECT_EQ(pose.nodes[2], poser.artificial(k).nodes[2]);
  }
  EXPECT_NEAR(sum / n_poses, std::numbers::pi / 12, 0.01) << "angles are spread evenly";
}

TEST(Pose, BlendsTargetsThatNothingAnimates) {
  const Asset asset = morphing_triangle().asset();
  const Poser poser(asset);
  double sum = 0;
  for (std::size_t k = 0; k < 100; ++k) {
    const std::vector<double> weights = poser.artificial(k).weights.at(0);
    ASSERT_EQ(weights.size(), 2U);
    EXPECT_NE(weights[0], weights[1]);
    for (const double weight : weights) {
      EXPECT_TRUE(weight >= 0 && weight <= 1) << weight;
      sum += weight;
    }
  }
  EXPECT_NEAR(sum / 200, 0.5, 0.02);
}

TEST(Pose, KeepsVerticesAndFacesInTheirOrder) {
  const Asset asset = turning_bar().asset();
  const Poser poser(asset);
  const IndexedMesh rest = poser.mesh(poser.rest());
  const IndexedMesh posed = poser.mesh(poser.animated({0, 2}));
  EXPECT_EQ(rest.faces, posed.faces);
  EXPECT_EQ(rest.positions.size(), posed.positions.size());
}

}  // namespace
}  // namespace whittle::gltf::test
