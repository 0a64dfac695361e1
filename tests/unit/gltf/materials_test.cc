// What a renderer needs: materials, textures, images.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "document/uri.hh"
#include "support/temporary_folder.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/output_file.hh"

namespace whittle::gltf::test {
namespace {

/// An asset with a mesh of a triangle without a material, and one of each of the first materials.
Asset asset_with(const std::string& materials, int n_materials, const std::string& more = {}) {
  const std::string attributes = R"("attributes": {"POSITION": 0})";
  std::string primitives = "{" + attributes + "}";
  for (int m = 0; m < n_materials; ++m) {
    primitives += ", {" + attributes + R"(, "material": )" + std::to_string(m) + "}";
  }
  return Asset::read(R"({"asset": {"version": "2.0"},
    "buffers": [{"byteLength": 3, "uri": "data:application/octet-stream;base64,BAUG"}],
    "bufferViews": [{"buffer": 0, "byteLength": 2}],
    "accessors": [{"componentType": 5126, "count": 3, "type": "VEC3"}],
    "meshes": [{"primitives": [)" +
                         primitives + R"(]}], "materials": [)" + materials + "]" + more + "}",
                     "test.gltf");
}

constexpr char textures[] = R"(,
  "images": [{"uri": "data:image/png;base64,AQID"}, {"bufferView": 0, "mimeType": "image/png"}, {"uri": "no.png"}],
  "samplers": [{"wrapS": 33071, "wrapT": 33648}, {"wrapS": 10497}],
  "textures": [{"source": 1, "sampler": 0}, {"source": 2, "sampler": 1}, {"extensions": {"EXT_texture_webp": {"source": 0}}}])";

TEST(GltfMaterials, HaveTheDefaultsOfTheFormat) {
  const std::vector<Material> materials = asset_with("{}", 1).materials()[0];
  ASSERT_EQ(materials.size(), 2U);
  for (const Material& material : materials) {
    EXPECT_EQ(material.base_color, (std::array<double, 4>{1, 1, 1, 1}));
    EXPECT_FALSE(material.base_color_texture);
    EXPECT_EQ(material.alpha_mode, Alpha::opaque);
    EXPECT_EQ(material.alpha_cutoff, 0.5);
    EXPECT_FALSE(material.double_sided);
  }
}

TEST(GltfMaterials, AreThoseOfTheDocument) {
  const Asset asset = asset_with(
      R"({"pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 2], "baseColorTexture": {"index": 0, "texCoord": 3}},
          "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true},
         {"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}},
         {"pbrMetallicRoughness": {"baseColorTexture": {"index": 2}}},
         {"extensions": {"KHR_materials_pbrSpecularGlossiness":
           {"diffuseFactor": [0.5, 0.5, 0.5, 1], "diffuseTexture": {"index": 1}}}})",
      4, textures);
  const std::vector<Material> materials = asset.materials()[0];
  ASSERT_EQ(materials.size(), 5U);
  EXPECT_EQ(materials[1].base_color, (std::array<double, 4>{0.1, 0.2, 0.3, 1}));
  ASSERT_TRUE(materials[1].base_color_texture);
  EXPECT_EQ(materials[1].name, "material 0");
  EXPECT_EQ(materials[1].base_color_texture->image->name, "image 1");
  EXPECT_EQ(materials[1].base_color_texture->texcoord, "TEXCOORD_3");
  EXPECT_TRUE(materials[1].base_color_texture->is_tinted);
  EXPECT_EQ(materials[1].base_color_texture->wrap, (std::array{Wrap::clamp_to_edge, Wrap::mirrored_repeat}));
  EXPECT_EQ(materials[1].alpha_mode, Alpha::mask);
  EXPECT_EQ(materials[1].alpha_cutoff, 0.25);
  EXPECT_TRUE(materials[1].double_sided);
  EXPECT_EQ(materials[2].alpha_mode, Alpha::blend);
  EXPECT_EQ(materials[2].base_color_texture->wrap[0], Wrap::repeat);
  EXPECT_FALSE(materials[3].base_color_texture) << "the image is known to an extension alone";
  EXPECT_EQ(materials[4].base_color[0], 0.5);
  EXPECT_EQ(materials[4].base_color_texture->image, materials[2].base_color_texture->image) << "each is read once";
}

TEST(GltfMaterials, HaveTheTransformsOfTextures) {
  const Asset asset = asset_with(
      R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1, "extensions": {"KHR_texture_transform":
           {"offset": [10, 20], "rotation": 1.5707963267948966, "scale": [2, 3], "texCoord": 5}}}}})",
      1, textures);
  const std::vector<Material> materials = asset.materials()[0];
  const Texture& use = materials.at(1).base_color_texture.value();
  EXPECT_EQ(use.texcoord, "TEXCOORD_5");
  // u, scaled by 2, turns upwards in the image, which is -v; v, scaled by 3, turns to +u.
  EXPECT_LT((use.transform * Eigen::Vector2d(1, 0) - Eigen::Vector2d(10, 18)).norm(), 1e-12);
  EXPECT_LT((use.transform * Eigen::Vector2d(0, 1) - Eigen::Vector2d(13, 20)).norm(), 1e-12);
}

/// The images of materials whose textures are the document's: 0, 1, …
std::vector<std::shared_ptr<const Image>> images_of(const Asset& asset) {
  std::vector<std::shared_ptr<const Image>> images;
  const std::vector<std::vector<Material>> materials = asset.materials();
  for (std::size_t i = 1; i < materials[0].size(); ++i) {
    images.push_back(materials[0][i].base_color_texture.value().image);
  }
  return images;
}

std::string textured(int n) {
  std::string materials;
  for (int i = 0; i < n; ++i) {
    materials += R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": )" + std::to_string(i) + "}}},";
  }
  return materials.substr(0, materials.size() - 1);
}

TEST(GltfMaterials, HaveTheBytesOfImages) {
  const auto images = images_of(asset_with(textured(4), 4, R"(,
    "images": [{"uri": "data:image/png;base64,AQID"}, {"bufferView": 0, "mimeType": "image/png"}, {"uri": "no.png"}],
    "textures": [{"source": 0}, {"source": 1}, {"source": 2}, {"source": 3}])"));
  EXPECT_EQ(images[0]->bytes, "\1\2\3");
  EXPECT_EQ(images[1]->bytes, "\4\5");
  for (const std::size_t i : {0U, 1U}) EXPECT_TRUE(images[i]->problem.empty() && images[i]->file.empty()) << i;
  EXPECT_EQ(images[2]->problem, "test.gltf: image 2: its file \"no.png\" is not there") << "the asset has no folder";
  EXPECT_EQ(images[3]->problem, "test.gltf: image 3 is not there");
}

TEST(GltfMaterials, HaveImagesBesideTheFile) {
  const whittle::test::TemporaryFolder folder;
  const auto write = [&](const char* name, const std::string& bytes) {
    io::OutputFile file(folder.path() / name);
    file.stream() << bytes;
    file.commit();
  };
  write("a b.png", "pixels");
  write("a.gltf", asset_with(textured(2), 2, R"(, "images": [{"uri": "a%20b.png"}, {"uri": "c.png"}],
    "textures": [{"source": 0}, {"source": 1}])")
                      .document());
  const auto images = images_of(Asset::read(folder.path() / "a.gltf"));
  EXPECT_EQ(images[0]->bytes, "pixels");
  EXPECT_EQ(images[0]->file, "a b.png");
  EXPECT_FALSE(images[1]->problem.empty());
}

TEST(GltfMaterials, AreRefusedWhereTheyAreWrong) {
  const auto problem_of = [](const std::string& material) -> std::string {
    try {
      asset_with(material, 1, textures).materials();
    } catch (const io::ReadError& error) {
      return error.what();
    }
    return "none";
  };
  const std::string start = "test.gltf: material 0";
  EXPECT_EQ(problem_of(R"({"pbrMetallicRoughness": {"baseColorFactor": [1]}})"),
            start + " pbrMetallicRoughness: \"baseColorFactor\" is not 4 numbers");
  EXPECT_EQ(problem_of(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 9}}})"),
            "test.gltf: texture 9 is not there");
  EXPECT_EQ(problem_of(R"({"alphaCutoff": "x"})"), start + ": \"alphaCutoff\" is not a number");
  EXPECT_THROW(asset_with("{}", 2).materials(), io::ReadError) << "there is no material 1";
}

}  // namespace
}  // namespace whittle::gltf::test
