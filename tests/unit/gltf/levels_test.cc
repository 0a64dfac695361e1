// Levels of detail of nodes: MSFT_lod.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "assets.hh"
#include "scene_builder.hh"
#include "validator.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::gltf::test {
namespace {

using ::testing::ElementsAre;

/// A mesh of so many copies of its first face.
IndexedMesh with_faces(const IndexedMesh& mesh, std::size_t n_faces) {
  IndexedMesh level = mesh;
  level.faces.assign(n_faces, mesh.faces.front());
  level.face_groups.assign(n_faces, mesh.face_groups.front());
  return level;
}

MeshLevels levels_of(const Asset& asset, std::size_t mesh) {
  const IndexedMesh triangles = asset.triangles(mesh);
  return {mesh, {with_faces(triangles, 3), with_faces(triangles, 2)}, {0.5, 0.25, 0}};
}

Json written(const Asset& asset) { return load_glb(asset.write_glb()).json; }

/// The nodes that are levels of a node, it first.
std::vector<std::size_t> level_nodes(const Json& document, std::size_t node) {
  std::vector<std::size_t> nodes{node};
  for (const Json& id : document["nodes"][node]["extensions"]["MSFT_lod"]["ids"]) nodes.push_back(id);
  return nodes;
}

TEST(GltfLevels, GiveANodeOneALevel) {
  SceneBuilder scene = morphing_triangle();
  scene.json["nodes"][0]["translation"] = {1, 2, 3};
  scene.json["nodes"][0]["name"] = "leaf";
  scene.json["nodes"][0]["extras"] = {{"tag", 7}};
  Asset asset = scene.asset();
  const Json before = written(asset);
  EXPECT_FALSE(asset.has_levels(0));
  asset.add_levels({levels_of(asset, 0)});
  EXPECT_TRUE(asset.has_levels(0));
  const Json document = written(asset);
  const std::vector<std::size_t> nodes = level_nodes(document, 0);
  ASSERT_EQ(nodes.size(), 3U);
  EXPECT_THAT(document["extensionsUsed"], ElementsAre("MSFT_lod"));
  EXPECT_THAT(document["nodes"][0]["extras"]["MSFT_screencoverage"], ElementsAre(0.5, 0.25, 0));
  EXPECT_EQ(document["nodes"][0]["extras"]["tag"], 7);
  EXPECT_EQ(document["meshes"][0], before["meshes"][0]) << "the mesh itself stays";
  for (std::size_t level = 1; level < nodes.size(); ++level) {
    const Json& node = document["nodes"][nodes[level]];
    EXPECT_EQ(node["name"], "leaf_LOD" + std::to_string(level));
    EXPECT_EQ(node["translation"], document["nodes"][0]["translation"]);
    EXPECT_FALSE(node.contains("extensions"));
  }
  const Asset again = Asset::read(asset.write_glb(), "output.glb");
  for (std::size_t level = 1; level < nodes.size(); ++level) {
    const IndexedMesh mesh = again.triangles(document["nodes"][nodes[level]]["mesh"].get<std::size_t>());
    EXPECT_EQ(mesh.faces.size(), 4 - level);
    EXPECT_EQ(mesh.attributes.size(), 2U) << "the morph targets";
  }
}

TEST(GltfLevels, AreMovedByTheAnimationsOfTheirNode) {
  SceneBuilder scene = morphing_triangle();
  scene.json["nodes"][0]["weights"] = {0, 0};
  scene.animate(0, "weights", {0, 1}, scene.floats("SCALAR", {0, 0, 1, 1}));
  scene.animate(0, "translation", {0, 1}, scene.floats("VEC3", {0, 0, 0, 5, 0, 0}));
  for (const bool has_child : {false, true}) {
    if (has_child) {
      scene.json["nodes"].push_back({{"name", "child"}});
      scene.json["nodes"][0]["children"] = {1};
    }
    Asset asset = scene.asset();
    asset.add_levels({levels_of(asset, 0)});
    const Json document = written(asset);
    // A node with children passes its mesh on: levels in its place would hide them.
    const std::size_t finest = has_child ? 2 : 0;
    EXPECT_EQ(document["nodes"][0].contains("mesh"), !has_child);
    const std::vector<std::size_t> nodes = level_nodes(document, finest);
    ASSERT_EQ(nodes.size(), 3U);
    const auto moved_by = [&](std::size_t animation) {
      std::vector<std::size_t> moved;
      for (const Json& channel : document["animations"][animation]["channels"]) {
        moved.push_back(channel["target"]["node"]);
      }
      return moved;
    };
    EXPECT_EQ(moved_by(0), nodes) << "weights";
    EXPECT_EQ(moved_by(1), has_child ? std::vector<std::size_t>{0} : nodes) << "translation";
    if (has_child) {
      EXPECT_THAT(document["nodes"][0]["children"], ElementsAre(1, 2));
    }
  }
}

TEST(GltfLevels, KeepTheSkin) {
  Asset asset = bar().asset();
  asset.add_levels({levels_of(asset, 0)});
  const Json document = written(asset);
  for (const std::size_t node : level_nodes(document, 0)) EXPECT_EQ(document["nodes"][node]["skin"], 0);
}

TEST(GltfLevels, RefuseWhatIsWrong) {
  Asset asset = morphing_triangle().asset();
  MeshLevels levels = levels_of(asset, 0);
  EXPECT_THROW(asset.add_levels({levels, levels}), std::invalid_argument) << "a mesh twice";
  MeshLevels elsewhere = levels;
  elsewhere.mesh = 1;
  EXPECT_THROW(asset.add_levels({elsewhere}), std::out_of_range);
  MeshLevels short_of_shares = levels;
  short_of_shares.screen_coverage.pop_back();
  EXPECT_THROW(asset.add_levels({short_of_shares}), std::invalid_argument);
  MeshLevels empty = levels;
  empty.coarser.front().faces.clear();
  empty.coarser.front().face_groups.clear();
  EXPECT_THROW(asset.add_levels({empty}), std::invalid_argument);
  EXPECT_FALSE(written(asset).contains("extensionsUsed")) << "nothing was changed";
  asset.add_levels({levels});
  EXPECT_THROW(asset.add_levels({levels}), std::invalid_argument) << "it has levels already";
}

TEST(GltfLevels, AreRightToTheValidator) {
  if (!has_validator()) GTEST_SKIP() << "there is no gltf-validator";
  const auto files = asset_files({"gltf-realistic"});
  WHITTLE_NEEDS_ASSETS(files);
  Pairs pairs;
  for (const auto& file : files) {
    Asset asset = Asset::read(file);
    std::vector<MeshLevels> levels;
    for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
      if (asset.n_triangles(m) > 0 && !asset.has_levels(m)) levels.push_back(levels_of(asset, m));
    }
    asset.add_levels(std::move(levels));
    asset.write(pairs.add(file, ".glb"));
  }
  EXPECT_TRUE(pairs.have_no_new_errors());
}

}  // namespace
}  // namespace whittle::gltf::test
