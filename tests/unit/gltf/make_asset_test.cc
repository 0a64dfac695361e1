#include "whittle/gltf/make_asset.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "assets.hh"
#include "support/shapes/shapes.hh"
#include "support/temporary_folder.hh"

namespace whittle::gltf::test {
namespace {

/// A cube with a chart a side, and all that is written.
NewAsset charted_asset() {
  NewAsset asset;
  asset.name = "cube";
  asset.mesh = whittle::test::charted_cube(2);
  for (Index& group : asset.mesh.face_groups) group = 2 * (group % 2);
  asset.mesh.colors.assign(asset.mesh.attributes[0].size(), {1, 0.5F, 0, 1});
  asset.mesh.normals[0] = {0, 0, 0};
  const auto texture = [](const char* file, const char* bytes) {
    return Texture{.image = std::make_shared<const Image>(Image{.file = file, .bytes = bytes})};
  };
  asset.materials = {
      {.name = "a", .base_color = {1, 0, 0, 1}, .base_color_texture = texture("tex/a 1.png", "")},
      {.name = "none"},
      {.name = "b", .base_color_texture = texture("../b.jpg", "\xFF\xD8\xFF\xE0 and so on"), .double_sided = true}};
  asset.embeds_images = false;
  return asset;
}

TEST(MakeAsset, HasTheMesh) {
  const NewAsset given = charted_asset();
  const Asset asset = Asset::read(make_asset(given).write_glb(), "made");
  ASSERT_EQ(asset.n_meshes(), 1U);
  EXPECT_EQ(asset.mesh_name(0), "cube");
  const IndexedMesh mesh = asset.triangles(0);
  ASSERT_EQ(mesh.faces.size(), given.mesh.faces.size());
  EXPECT_EQ(mesh.group_names, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(mesh.attributes.size(), 1U);
  EXPECT_EQ(mesh.attributes[0].name, "TEXCOORD_0");
  std::size_t n_found = 0;  // faces come primitive by primitive
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = mesh.faces[f][k];
      const auto& n = mesh.normals[v];
      EXPECT_NEAR(Vec3(n[0], n[1], n[2]).norm(), 1, 1e-6);
      EXPECT_EQ(mesh.colors[v][2], 0);
      EXPECT_NEAR(mesh.colors[v][1], 0.5, 1e-5);
    }
    for (std::size_t g = 0; g < given.mesh.faces.size(); ++g) {
      const auto at = [&](std::size_t k) { return given.mesh.positions[given.mesh.faces[g][k]]; };
      const auto& face = mesh.faces[f];
      if (at(0) != mesh.positions[face[0]] || at(1) != mesh.positions[face[1]] || at(2) != mesh.positions[face[2]]) {
        continue;
      }
      ++n_found;
      const auto expected = given.mesh.attributes[0].value(given.mesh.wedge(g, 1));
      EXPECT_NEAR(mesh.attributes[0].value(face[1])[1], expected[1], 1e-7);
    }
  }
  EXPECT_EQ(n_found, mesh.faces.size());
}

TEST(MakeAsset, HasMaterialsAndImages) {
  const Json document = Json::parse(make_asset(charted_asset()).document());
  ASSERT_EQ(document["materials"].size(), 2U) << "no face has the other one";
  EXPECT_EQ(document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"], Json::parse("[1.0,0.0,0.0,1.0]"));
  EXPECT_FALSE(document["materials"][0].contains("doubleSided"));
  EXPECT_EQ(document["materials"][1]["doubleSided"], true);
  EXPECT_EQ(document["images"][0]["uri"], "tex/a%201.png");
  EXPECT_EQ(document["images"][1]["mimeType"], "image/jpeg");
  const Document made = load_glb(make_asset(charted_asset()).write_glb());
  EXPECT_EQ(made.view(made.json["images"][1]["bufferView"]), "\xFF\xD8\xFF\xE0 and so on")
      << "it is outside of the folder";
}

TEST(MakeAsset, LiesInTwoFilesIfItIsText) {
  const whittle::test::TemporaryFolder folder;
  make_asset(charted_asset()).write(folder / "cube.gltf");
  EXPECT_TRUE(std::filesystem::exists(folder / "cube.bin"));
  EXPECT_EQ(Asset::read(folder / "cube.gltf").n_triangles(0), charted_asset().mesh.faces.size());
}

TEST(MakeAsset, RefusesWhatDoesNotFit) {
  NewAsset asset = charted_asset();
  asset.mesh.positions[3].x() = 1e39;
  EXPECT_THROW(make_asset(asset), std::range_error);
}

TEST(MakeAsset, HasAnImageOfSeveralMaterialsOnce) {
  NewAsset asset = charted_asset();
  asset.materials[2].base_color_texture = asset.materials[0].base_color_texture;
  const Json document = Json::parse(make_asset(asset).document());
  EXPECT_EQ(document["images"].size(), 1U);
  for (const std::size_t m : {0U, 1U}) {
    EXPECT_EQ(document["materials"][m]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  }
}

}  // namespace
}  // namespace whittle::gltf::test
