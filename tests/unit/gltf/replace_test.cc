// Triangles that replace others: what primitives get, and what leaves the document.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "assets.hh"
#include "geometry/joint_weights.hh"
#include "support/random.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::gltf::test {
namespace {

using ::testing::ElementsAre;

class GltfReplace : public ::testing::Test {
 protected:
  void SetUp() override {
    if (asset_files({"gltf-tiny"}).empty()) GTEST_SKIP() << "the test assets are not there: " << WHITTLE_TEST_ASSETS;
  }
};

/// The faces of some groups.
IndexedMesh with_groups(IndexedMesh mesh, const std::vector<Index>& groups) {
  std::vector<Triangle> faces;
  std::vector<Index> kept;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (std::find(groups.begin(), groups.end(), mesh.face_groups[f]) == groups.end()) continue;
    faces.push_back(mesh.faces[f]);
    kept.push_back(mesh.face_groups[f]);
  }
  mesh.faces = std::move(faces);
  mesh.face_groups = std::move(kept);
  return mesh;
}

TEST_F(GltfReplace, DropsPrimitivesWithoutTriangles) {
  Asset asset = Asset::read(asset_file("gltf-realistic/mannequiny.glb"));
  const IndexedMesh mesh = asset.triangles(0);
  asset.set_triangles(0, with_groups(mesh, {0, 2}));
  const Asset again = Asset::read(asset.write_glb(), "output.glb");
  EXPECT_THAT(again.triangles(0).group_names, ElementsAre(mesh.group_names[0], mesh.group_names[2]));
  EXPECT_EQ(again.triangles(0).faces.size(), with_groups(mesh, {0, 2}).faces.size());
  EXPECT_THROW(asset.set_triangles(0, with_groups(mesh, {})), std::invalid_argument);
}

TEST_F(GltfReplace, IsReadAgainAsItIsWritten) {
  Asset asset = Asset::read(asset_file("gltf-realistic/mannequiny.glb"));
  const IndexedMesh mesh = asset.triangles(0);
  const IndexedMesh fewer = with_groups(mesh, {0, 2});
  const std::string again = asset.as_written({{0, fewer}}).write_glb();
  EXPECT_EQ(asset.triangles(0).faces, mesh.faces);
  EXPECT_THROW(asset.as_written({{0, with_groups(mesh, {})}}), std::invalid_argument);
  asset.set_triangles(0, fewer);
  EXPECT_EQ(again, Asset::read(asset.write_glb(), "output.glb").write_glb());
  EXPECT_EQ(again, asset.as_written({}).write_glb()) << "of a replaced mesh the new triangles";
}

TEST_F(GltfReplace, KeepsLinesAndPointsWhereNoTriangleIsLeft) {
  Asset asset = Asset::read(asset_file("gltf-tiny/generated/triangles_lines_points_mixed.gltf"));
  asset.set_triangles(0, with_groups(asset.triangles(0), {}));
  const Document document = load_glb(asset.write_glb());
  const Json& primitives = document.json["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 2);
  EXPECT_EQ(primitives[0]["mode"], 1);
  EXPECT_EQ(primitives[1]["mode"], 0);
}

TEST_F(GltfReplace, GivesPrimitivesOnlyWhatTheyHad) {
  Asset asset = Asset::read(asset_file("gltf-tiny/gag_Mesh_PrimitivesUV_04/Mesh_PrimitivesUV_04.gltf"));
  const auto names = [](const Json& primitive) {
    std::vector<std::string> all;
    for (const auto& [name, accessor] : primitive["attributes"].items()) all.push_back(name);
    return all;
  };
  const Document before = load_document(asset_file("gltf-tiny/gag_Mesh_PrimitivesUV_04/Mesh_PrimitivesUV_04.gltf"));
  asset.set_triangles(0, asset.triangles(0));
  const Document after = load_glb(asset.write_glb());
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_EQ(names(before.json["meshes"][0]["primitives"][p]), names(after.json["meshes"][0]["primitives"][p]));
  }
}

TEST_F(GltfReplace, ForgetsExtensionsThatNothingHas) {
  WHITTLE_NEEDS_CODECS();
  for (const std::string name : {"guitar_quantized.glb", "chess-board.glb", "Ingenuity.glb"}) {
    Asset asset = Asset::read(asset_file("gltf-realistic/" + name));
    for (std::size_t m = 0; m < asset.n_meshes(); ++m) asset.set_triangles(m, asset.triangles(m));
    const Json document = load_glb(asset.write_glb()).json;
    for (const std::string extension :
         {"KHR_mesh_quantization", "KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
      EXPECT_EQ(document.dump().find(extension), std::string::npos) << name << ' ' << extension;
    }
  }
}

TEST_F(GltfReplace, LeavesNumbersThatUnknownExtensionsMayMean) {
  const auto file = asset_file("gltf-tiny/generated/shared_vertex_buffer_two_prims.gltf");
  Json document = Json::parse(bytes_of_file(file));
  document["extensionsUsed"] = {"ACME_refers"};
  document["extensions"]["ACME_refers"] = {{"positions", 0}};
  Asset asset = Asset::read(document.dump(), "input.gltf", file.parent_path());
  const Json before = document["accessors"][0];
  asset.set_triangles(0, asset.triangles(0));
  const Document after = load_glb(asset.write_glb());
  EXPECT_EQ(after.accessor(0)["count"], before["count"]);
  EXPECT_EQ(after.accessor(0)["max"], before["max"]);
  EXPECT_EQ(after.view(after.accessor(0)["bufferView"]), load_document(file).view(before["bufferView"]));
}

TEST_F(GltfReplace, StoresWeightsWhoseSumIsOne) {
  Asset asset = Asset::read(asset_file("gltf-tiny/gag_Animation_SkinType_01/Animation_SkinType_01.gltf"));
  IndexedMesh mesh = asset.triangles(0);
  whittle::test::Random random(3);
  for (Attribute& attribute : mesh.attributes) {
    if (attribute.kind != AttributeKind::joint_weights) continue;
    for (std::size_t v = 0; v < attribute.size(); ++v) {
      for (std::size_t k = 4; k < 8; ++k) attribute.value(v)[k] = random.uniform();
    }
  }
  asset.set_triangles(0, mesh);
  const Document document = load_glb(asset.write_glb());
  const Json& accessor = document.accessor(document.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"]);
  EXPECT_EQ(accessor["componentType"], 5121);
  const std::string bytes = document.view(accessor["bufferView"]);
  for (std::size_t v = 0; v < bytes.size(); v += 4) {
    int sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += static_cast<unsigned char>(bytes[v + k]);
    EXPECT_EQ(sum, 255);
  }
}

TEST(GltfJointWeights, KeepTheLargestWhereThereAreTooMany) {
  const std::vector<double> value = {1, 2, 3, 4, 5, 6, 7, 8, 0.1, 0.1, 0.1, 0, 0.3, 0, 0.4, 0};
  const JointWeights kept = kept_joints(value, 4);
  EXPECT_THAT(kept.joints, ElementsAre(7, 5, 1, 2));
  EXPECT_NEAR(std::accumulate(kept.weights.begin(), kept.weights.end(), 0.0), 1, 1e-12);
  const std::vector<double> few = {9, 8, 7, 6, 0.25, 0.25, 0.5, 0};
  EXPECT_THAT(kept_joints(few, 4).joints, ElementsAre(9, 8, 7, 6));
  EXPECT_THAT(kept_joints(few, 4).weights, ElementsAre(0.25, 0.25, 0.5, 0));
}

TEST(GltfJointWeights, AreRoundedToTheSameSum) {
  std::vector<double> thirds = {1.0 / 3, 1.0 / 3, 1.0 / 3, 0};
  round_weights(thirds, 255);
  EXPECT_EQ(thirds[0] + thirds[1] + thirds[2], 1);
  std::vector<double> zeros(4);
  round_weights(zeros, 255);
  EXPECT_THAT(zeros, ElementsAre(0, 0, 0, 0));
}

}  // namespace
}  // namespace whittle::gltf::test
