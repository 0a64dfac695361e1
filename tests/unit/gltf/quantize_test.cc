// Quantized output: integers in the place of real numbers, and the same scene in each pose.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "assets.hh"
#include "mesh_comparison.hh"
#include "scene_builder.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/gltf/pose.hh"

namespace whittle::gltf::test {
namespace {

using testing::ElementsAre;

/// Moments of animations that are compared.
constexpr std::size_t n_moments = 2;
/// A step is 3e-5 of a side.
constexpr double tolerance = 1e-4;
/// With weights of 8 bits.
constexpr double skinned_tolerance = 1e-3;

/// The asset with its own triangles as new ones, so that they are written anew.
Asset replaced(Asset asset) {
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    if (asset.n_triangles(m) > 0) asset.set_triangles(m, asset.triangles(m));
  }
  return asset;
}

Asset quantized(const Asset& asset) { return Asset::read(asset.write_glb({.quantize = true}), "quantized.glb"); }

Json document_of(const Asset& asset) { return Json::parse(asset.document()); }

/// Largest difference of the corners, sorted along an axis, as a share of the diagonal: scenes have them in any order.
double relative_distance(const IndexedMesh& a, const IndexedMesh& b) {
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> of_a = corners_along(axis, a);
    const std::vector<double> of_b = corners_along(axis, b);
    EXPECT_EQ(of_a.size(), of_b.size());
    for (std::size_t i = 0; i < std::min(of_a.size(), of_b.size()); ++i) {
      farthest = std::max(farthest, std::abs(of_a[i] - of_b[i]));
    }
  }
  const double diagonal = diagonal_of(a.positions);
  return diagonal > 0 ? farthest / diagonal : farthest;
}

/// Compares both scenes at rest and while they move.
void expect_same_poses(const Asset& a, const Asset& b) {
  const Poser of_a(a);
  const Poser of_b(b);
  const double limit = of_a.has_skins() ? skinned_tolerance : tolerance;
  EXPECT_LE(relative_distance(of_a.mesh(of_a.rest()), of_b.mesh(of_b.rest())), limit);
  if (!of_a.is_animated()) return;
  for (const AnimationTime& moment : of_a.moments(n_moments)) {
    EXPECT_LE(relative_distance(of_a.mesh(of_a.animated(moment)), of_b.mesh(of_b.animated(moment))), limit);
  }
}

TEST(GltfQuantize, KeepsEachPose) {
  WHITTLE_NEEDS_CODECS();
  const auto files = asset_files({"gltf-realistic", "gltf-tiny"});
  WHITTLE_NEEDS_ASSETS(files);
  for (const auto& file : files) {
    SCOPED_TRACE(asset_name(file));
    const Asset asset = replaced(Asset::read(file));
    const Asset plain = Asset::read(asset.write_glb(), "plain.glb");
    expect_same_poses(plain, quantized(asset));
    if (asset_name(file).starts_with("gltf-realistic")) continue;
    expect_same_poses(plain, Asset::read(asset.write_glb({.compress = true, .quantize = true}), "small.glb"));
  }
}

TEST(GltfQuantize, PutsTheScaleIntoANodeOfTheMesh) {
  SceneBuilder scene = morphing_triangle();
  scene.json["nodes"][0]["weights"] = {0, 1};
  scene.json["nodes"][0]["translation"] = {1, 2, 3};
  const Asset asset = replaced(scene.asset());
  const Json document = document_of(quantized(asset));
  EXPECT_THAT(document["extensionsRequired"], ElementsAre("KHR_mesh_quantization"));
  ASSERT_EQ(document["nodes"].size(), 2U);
  EXPECT_THAT(document["nodes"][0]["translation"], ElementsAre(1, 2, 3));
  EXPECT_THAT(document["nodes"][0]["children"], ElementsAre(1));
  EXPECT_FALSE(document["nodes"][0].contains("mesh"));
  EXPECT_EQ(document["nodes"][1]["mesh"], 0);
  EXPECT_THAT(document["nodes"][1]["weights"], ElementsAre(0, 1)) << "they go with the mesh";
  const Json& primitive = document["meshes"][0]["primitives"][0];
  EXPECT_EQ(document["accessors"][primitive["attributes"]["POSITION"].get<int>()]["componentType"], 5123);
  EXPECT_EQ(document["accessors"][primitive["targets"][1]["POSITION"].get<int>()]["componentType"], 5122);
  EXPECT_TRUE(asset.warnings({.quantize = true}).empty());
  expect_same_poses(asset, quantized(asset));
}

TEST(GltfQuantize, PutsTheScaleIntoTheSkin) {
  SceneBuilder scene = bar();
  scene.json["skins"].push_back({{"joints", {1, 2}}});  // whose inverse bind matrices are the identity
  scene.json["nodes"].push_back({{"mesh", 0}, {"skin", 1}});
  const Asset asset = replaced(scene.asset());
  const Asset again = quantized(asset);
  EXPECT_EQ(document_of(again)["nodes"], document_of(asset)["nodes"]);
  EXPECT_TRUE(document_of(again)["skins"][1].contains("inverseBindMatrices"));
  expect_same_poses(asset, again);
  const Json json = document_of(again);
  const Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
  EXPECT_EQ(json["accessors"][attributes["JOINTS_0"].get<int>()]["componentType"], 5121);
  EXPECT_EQ(json["accessors"][attributes["WEIGHTS_0"].get<int>()]["componentType"], 5121);
}

TEST(GltfQuantize, GivesMeshesOfOneSkinOneScale) {
  SceneBuilder scene = bar();
  scene.json["meshes"].push_back(scene.json["meshes"][0]);
  const std::size_t large = scene.floats("VEC3", {0, 0, 0, 50, 0, 0, 0, 9, 0});
  scene.json["meshes"][1]["primitives"][0]["attributes"]["POSITION"] = large;
  scene.json["nodes"].push_back({{"mesh", 1}, {"skin", 0}});
  const Asset asset = replaced(scene.asset());
  expect_same_poses(asset, quantized(asset));
}

TEST(GltfQuantize, LeavesPositionsWhereNoNodeCanScaleThem) {
  SceneBuilder scene = morphing_triangle();
  const std::size_t places = scene.floats("VEC3", {0, 0, 0, 5, 0, 0});
  scene.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = places;
  const Asset asset = replaced(scene.asset());
  const Asset again = quantized(asset);
  EXPECT_EQ(document_of(again)["nodes"].size(), 1U);
  EXPECT_FALSE(document_of(again).contains("extensionsRequired"));
  EXPECT_THAT(asset.warnings({.quantize = true}),
              ElementsAre("mesh 0: its positions stay real numbers, as EXT_mesh_gpu_instancing places it"));
  EXPECT_EQ(relative_distance(asset.triangles(0), again.triangles(0)), 0);
}

TEST(GltfQuantize, KeepsLevelsOfDetail) {
  Asset asset = replaced(morphing_triangle().asset());
  asset.add_levels({{0, {asset.triangles(0)}, {0.5, 0}}});
  asset.set_triangles(0, asset.triangles(0));
  const Asset again = quantized(asset);
  EXPECT_TRUE(again.has_levels(0));
  EXPECT_TRUE(again.is_level(1));
  EXPECT_EQ(document_of(again)["nodes"][0]["extensions"], document_of(asset)["nodes"][0]["extensions"]);
  expect_same_poses(asset, again);
}

TEST(GltfQuantize, TakesLessSpace) {
  WHITTLE_NEEDS_ASSETS(asset_files({"gltf-realistic"}));
  const Asset asset = replaced(Asset::read(asset_file("gltf-realistic/helicopter.glb")));
  const double share = 0.7;  // half of its bytes are faces
  EXPECT_LT(static_cast<double>(asset.write_glb({.quantize = true}).size()),
            share * static_cast<double>(asset.write_glb().size()));
}

}  // namespace
}  // namespace whittle::gltf::test
