// Output for engines: integers in the place of real numbers, fewer primitives, and the same scene in each pose.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "assets.hh"
#include "mesh_comparison.hh"
#include "scene_builder.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::gltf::test {
namespace {

using testing::ElementsAre;

Asset quantized(const Asset& asset) { return Asset::read(asset.write_glb({.quantize = true}), "quantized.glb"); }

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
  EXPECT_EQ(document["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()]["componentType"], 5123);
  EXPECT_EQ(document["accessors"][primitive["targets"][1]["POSITION"].get<std::size_t>()]["componentType"], 5122);
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
  EXPECT_EQ(json["accessors"][attributes["JOINTS_0"].get<std::size_t>()]["componentType"], 5121);
  EXPECT_EQ(json["accessors"][attributes["WEIGHTS_0"].get<std::size_t>()]["componentType"], 5121);
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

TEST(GltfQuantize, LeavesPositionsThatPointersMayBlend) {
  SceneBuilder scene = morphing_triangle();
  const std::size_t weights = scene.floats("SCALAR", {0, 0, 1, 1});
  scene.animate(0, "weights", {0, 1}, weights);
  EXPECT_EQ(document_of(quantized(replaced(scene.asset())))["nodes"].size(), 2U);
  Json& target = scene.json["animations"][0]["channels"][0]["target"];
  target = {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/0/weights"}}}}}};
  EXPECT_EQ(document_of(quantized(replaced(scene.asset())))["nodes"].size(), 1U);
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

Asset merged(const Asset& asset) { return Asset::read(asset.write_glb({.merge = true}), "merged.glb"); }

std::size_t n_primitives(const Asset& asset) {
  std::size_t n = 0;
  const Json document = document_of(asset);
  for (const Json& mesh : document["meshes"]) n += mesh["primitives"].size();
  return n;
}

/// Three triangles with normals, each a mesh in a node of its own; the second node is mirrored. Two materials.
SceneBuilder three_triangles() {
  SceneBuilder scene;
  const std::size_t positions = scene.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 2, 0});
  const std::size_t normals = scene.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
  for (int m = 0; m < 3; ++m) {
    scene.json["meshes"].push_back(
        {{"primitives",
          {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"material", m == 2 ? 1 : 0}}}}});
  }
  scene.json["materials"] = {{{"name", "a"}}, {{"name", "b"}}};
  scene.json["nodes"] = {{{"mesh", 0}, {"translation", {5, 0, 0}}},
                         {{"mesh", 1}, {"scale", {-1, 1, 3}}, {"name", "mirror"}},
                         {{"mesh", 2}}};
  return scene;
}

TEST(GltfMerge, KeepsEachScene) {
  WHITTLE_NEEDS_CODECS();
  const auto files = asset_files({"gltf-realistic", "gltf-tiny"});
  WHITTLE_NEEDS_ASSETS(files);
  for (const auto& file : files) {
    SCOPED_TRACE(asset_name(file));
    const Asset asset = replaced(Asset::read(file));
    const Asset again = merged(asset);
    EXPECT_LE(n_primitives(again), n_primitives(asset));
    expect_same_poses(Asset::read(asset.write_glb(), "plain.glb"), again);
  }
}

TEST(GltfMerge, GivesOneMeshTheTrianglesOfAnother) {
  const Asset asset = replaced(three_triangles().asset());
  const Asset again = merged(asset);
  expect_same_poses(asset, again);
  ASSERT_EQ(again.n_meshes(), 2U);
  EXPECT_EQ(n_primitives(again), 2U);
  EXPECT_EQ(again.n_triangles(0), 2U);
  const Json nodes = document_of(again)["nodes"];
  EXPECT_EQ(nodes[0]["mesh"], 0);
  EXPECT_FALSE(nodes[1].contains("mesh"));
  EXPECT_EQ(nodes[1]["name"], "mirror");
  EXPECT_EQ(nodes[2]["mesh"], 1);
  const IndexedMesh triangles = again.triangles(0);
  const Triangle& mirrored = triangles.faces[1];
  const Vec3 u = triangles.positions[mirrored[1]] - triangles.positions[mirrored[0]];
  const Vec3 v = triangles.positions[mirrored[2]] - triangles.positions[mirrored[0]];
  EXPECT_GT(u.cross(v).z(), 0) << "it is turned over";
  EXPECT_EQ(triangles.normals[mirrored[0]][2], 1);
}

TEST(GltfMerge, LeavesMeshesWhereAPictureCouldChange) {
  const auto count = [](SceneBuilder& scene) { return merged(replaced(scene.asset())).n_meshes(); };
  SceneBuilder moved = three_triangles();
  moved.animate(1, "translation", {0, 1}, moved.floats("VEC3", {0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(count(moved), 3U);
  SceneBuilder blended = three_triangles();
  blended.json["materials"][0]["alphaMode"] = "BLEND";
  EXPECT_EQ(count(blended), 3U);
  SceneBuilder tagged = three_triangles();
  tagged.json["meshes"][1]["extras"]["tag"] = 1;
  EXPECT_EQ(count(tagged), 3U);
  SceneBuilder repeated = three_triangles();
  repeated.json["nodes"].push_back({{"mesh", 1}});
  EXPECT_EQ(count(repeated), 3U);
  SceneBuilder skinned = bar();
  skinned.json["meshes"].push_back(skinned.json["meshes"][0]);
  skinned.json["nodes"].push_back({{"mesh", 1}, {"skin", 0}});
  EXPECT_EQ(count(skinned), 2U);
}

TEST(GltfMerge, MergesPrimitivesOfOneMesh) {
  SceneBuilder scene = morphing_triangle();
  Json& primitives = scene.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  const Asset asset = replaced(scene.asset());
  EXPECT_EQ(n_primitives(merged(asset)), 1U);
  expect_same_poses(asset, merged(asset));
  expect_same_poses(asset, Asset::read(asset.write_glb({.quantize = true, .merge = true}), "small.glb"));
}

}  // namespace
}  // namespace whittle::gltf::test
