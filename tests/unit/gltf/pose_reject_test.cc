// Skins and animations that are no valid glTF: refused in one line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "scene_builder.hh"
#include "whittle/gltf/pose.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr float infinite = std::numeric_limits<float>::infinity();

SceneBuilder moving_bar() {
  SceneBuilder scene = bar();
  scene.animate(2, "translation", {0, 1}, scene.floats("VEC3", {1, 0, 0, 1, 4, 0}));
  return scene;
}

/// What the message says; empty if the scene is posed.
std::string problem_in(const SceneBuilder& scene) {
  const Asset asset = scene.asset();
  try {
    const Poser poser(asset);
    poser.mesh(poser.rest());
    for (const AnimationTime& moment : poser.moments(5)) poser.mesh(poser.animated(moment));
    poser.mesh(poser.artificial(0));
  } catch (const io::ReadError& error) {
    EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    return error.what();
  }
  return {};
}

TEST(PoseReject, SaysWhatIsWrongWithASkin) {
  EXPECT_EQ(problem_in(moving_bar()), "");
  SceneBuilder scene = bar();
  scene.json["nodes"][0]["skin"] = 1;
  EXPECT_THAT(problem_in(scene), HasSubstr("node 0: \"skin\" names skin 1, there are 1"));
  scene = bar();
  scene.json["skins"][0]["joints"] = {1, 9};
  EXPECT_THAT(problem_in(scene), HasSubstr("skin 0: \"joints\" names a node that is not there"));
  scene = bar();
  scene.json["skins"][0]["joints"] = {1};
  EXPECT_THAT(problem_in(scene), HasSubstr("mesh 0: joint 1 is above the 1 joints of skin 0"));
  scene = bar();
  scene.json["skins"][0]["joints"] = {1, 2, 1};
  EXPECT_THAT(problem_in(scene), HasSubstr("skin 0: it has 2 inverse bind matrices for 3 joints"));
  scene = bar();
  scene.json["skins"][0]["inverseBindMatrices"] = 0;
  EXPECT_THAT(problem_in(scene), HasSubstr("skin 0: its inverse bind matrices are VEC3"));
  scene = bar();
  scene.json["skins"][0]["inverseBindMatrices"] = scene.floats("MAT4", std::vector<float>(32, infinite));
  EXPECT_THAT(problem_in(scene), HasSubstr("skin 0: inverse bind matrix 0 is not finite"));
  scene = bar();
  scene.json["nodes"][0]["weights"] = {"a"};
  EXPECT_THAT(problem_in(scene), HasSubstr("node 0: \"weights\" is not an array of numbers"));
}

TEST(PoseReject, SaysWhatIsWrongWithAnAnimation) {
  const auto changed = [](const char* key, const Json& value) {
    SceneBuilder scene = moving_bar();
    scene.json["animations"][0]["samplers"][0][key] = value;
    return problem_in(scene);
  };
  EXPECT_THAT(changed("interpolation", "LOOSE"),
              HasSubstr("animation 0 sampler 0: the interpolation LOOSE is not known"));
  EXPECT_THAT(changed("interpolation", "CUBICSPLINE"), HasSubstr("animation 0 sampler 0: it has 2 values for 2 times"));
  EXPECT_THAT(changed("input", 0), HasSubstr("its times are VEC3"));
  EXPECT_THAT(changed("output", 2), HasSubstr("its values are VEC4"));
  EXPECT_THAT(changed("output", 99), HasSubstr("names accessor 99"));
  SceneBuilder scene = moving_bar();
  scene.json["animations"][0]["channels"][0]["sampler"] = 1;
  EXPECT_THAT(problem_in(scene), HasSubstr("animation 0 channel 0: \"sampler\" names sampler 1, there are 1"));
  scene = moving_bar();
  scene.json["animations"][0]["channels"][0]["target"]["node"] = 3;
  EXPECT_THAT(problem_in(scene), HasSubstr("names node 3, there are 3"));
  scene = moving_bar();
  scene.json["animations"][0]["channels"][0].erase("target");
  EXPECT_THAT(problem_in(scene), HasSubstr("\"target\" is missing"));
  scene = moving_bar();
  scene.json["nodes"][2] = {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
  EXPECT_THAT(problem_in(scene), HasSubstr("node 2 has a matrix, which can't be animated"));
}

TEST(PoseReject, SaysWhichNumbersAreWrong) {
  const auto keyed = [](const std::vector<float>& times, const std::vector<float>& values) {
    SceneBuilder scene = bar();
    scene.animate(2, "translation", times, scene.floats("VEC3", values));
    return problem_in(scene);
  };
  EXPECT_THAT(keyed({}, {0, 0, 0}), HasSubstr("it has no times"));
  EXPECT_THAT(keyed({0, infinite}, {0, 0, 0, 0, 0, 0}), HasSubstr("time 1 is not finite"));
  EXPECT_THAT(keyed({1, 0}, {0, 0, 0, 0, 0, 0}), HasSubstr("time 1 is before the one before it"));
  EXPECT_THAT(keyed({0, 1}, {0, 0, 0, 0, -infinite, 0}), HasSubstr("value 1 is not finite"));
  EXPECT_THAT(keyed({0, 1}, {0, 0, 0}), HasSubstr("it has 1 values for 2 times"));
  EXPECT_EQ(keyed({0, 0, 1}, {0, 0, 0, 1, 1, 1, 2, 2, 2}), "") << "two keys at one time";
  SceneBuilder scene = bar();
  scene.json["nodes"][1]["scale"] = {1e200, 1, 1};
  scene.json["nodes"][2]["scale"] = {1e200, 1, 1};
  EXPECT_THAT(problem_in(scene), HasSubstr("mesh 0: a position of its pose is not finite"));
}

TEST(PoseReject, IgnoresWhatItDoesNotPose) {
  SceneBuilder scene = moving_bar();
  scene.json["animations"][0]["channels"][0]["target"] = {{"path", "pointer"}};
  EXPECT_EQ(problem_in(scene), "");
  const Asset asset = scene.asset();
  EXPECT_FALSE(Poser(asset).is_animated());
  scene = bar();
  scene.animate(0, "weights", {0}, scene.floats("SCALAR", {1}));
  EXPECT_EQ(problem_in(scene), "") << "the mesh has no targets";
}

TEST(PoseReject, RefusesScenesThatAreTooLarge) {
  SceneBuilder scene = morphing_triangle();
  const std::size_t n = 20'000;
  std::vector<float> zeros(9 * n);
  scene.json["meshes"][0]["primitives"] = {{{"attributes", {{"POSITION", scene.floats("VEC3", zeros)}}}}};
  scene.json["nodes"] = Json::array();
  for (std::size_t i = 0; i < 3'000; ++i) scene.json["nodes"].push_back({{"mesh", 0}});
  EXPECT_THAT(problem_in(scene), HasSubstr("the scene has more than 2^27 vertices or triangles"));
}

TEST(PoseReject, TakesNoPoseOfAnotherAsset) {
  const Asset one = bar().asset();
  const Asset other = morphing_triangle().asset();
  const Poser poser(one);
  EXPECT_THROW(poser.mesh(Poser(other).rest()), std::invalid_argument);
  EXPECT_THROW(poser.animated({0, 0}), std::out_of_range);
}

}  // namespace
}  // namespace whittle::gltf::test
