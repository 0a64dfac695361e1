#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"
#include "program/stand_in_programs.hh"
#include "support/shapes/shapes.hh"
#include "support/temporary_folder.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;

/// A sphere with colours, as a mesh file and as a document; and one of few faces without.
class BakeCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_pictures(folder_)) GTEST_SKIP() << "this program reads no images";
    IndexedMesh mesh = sphere(4);
    for (const Vec3& p : mesh.positions) {
      mesh.colors.push_back({static_cast<float>(p.x()) / 2 + 0.5F, 1, p.z() > 0 ? 1.0F : 0.0F, 1});
    }
    io::write_mesh(high_, mesh);
    ASSERT_EQ(whittle({"convert", high_, document_, "--quiet"}).exit_code, 0);
    ASSERT_EQ(whittle({"simplify", high_, "-o", low_, "--faces", "300", "--attributes", "position-only", "--quiet"})
                  .exit_code,
              0);
  }

  Outcome bake(const std::string& high, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"bake", high, low_, "-o", out_});
    return whittle(more);
  }

  /// Bakes the document with another material.
  Outcome bake_with(const Json& material) const {
    Json document = parse_json(read_text(document_));
    document["materials"] = Json::array({material});
    for (Json& mesh : document["meshes"]) {
      for (Json& primitive : mesh["primitives"]) primitive["material"] = 0;
    }
    const std::string changed = folder_ / "changed.gltf";
    write_text(changed, document.dump());
    return bake(changed);
  }

  TemporaryFolder folder_;
  std::string high_ = folder_ / "high.ply";
  std::string document_ = folder_ / "high.gltf";
  std::string low_ = folder_ / "low.ply";
  std::string out_ = folder_ / "out.glb";
};

TEST_F(BakeCommand, WritesAMeshThatLooksLikeTheDetailedOne) {
  const Outcome outcome = bake(high_, {"--texture-size", "256", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const Json json = parse_json(outcome.out);
  EXPECT_EQ(json["output"]["faces"], 300);
  EXPECT_EQ(json["texture"]["size"], 256);
  EXPECT_EQ(json["texture"]["normal_map"], true);
  EXPECT_EQ(json["texture"]["missed_share"], 0);
  EXPECT_TRUE(json["warnings"].empty()) << json;
  const Outcome info = whittle({"info", out_});
  for (const char* said : {"300 faces", "vertex normals", "TEXCOORD_0", "TANGENT"}) {
    EXPECT_NE(info.out.find(said), std::string::npos) << said << '\n' << info;
  }
  const auto psnr = [&](const std::string& mesh) {
    const Outcome measured = whittle({"measure", high_, mesh, "--render", "6", "--json", "-"});
    EXPECT_EQ(measured.exit_code, 0) << measured;
    return parse_json(measured.out)["render"]["psnr"]["pooled"].get<double>();
  };
  EXPECT_GT(psnr(out_), psnr(low_) + 10);
}

TEST_F(BakeCommand, KeepsPositionsAndFaces) {
  ASSERT_EQ(bake(document_, {"--quiet"}).exit_code, 0);
  const std::string back = folder_ / "back.ply";
  ASSERT_EQ(whittle({"convert", out_, back, "--quiet"}).exit_code, 0);
  const Outcome measured = whittle({"measure", low_, back, "--json", "-"});
  EXPECT_LT(parse_json(measured.out)["max"].get<double>(), 1e-6) << measured;
  EXPECT_EQ(io::read_mesh(back).mesh.faces.size(), io::read_mesh(low_).mesh.faces.size());
}

TEST_F(BakeCommand, KeepsTheShadingOfTheMaterial) {
  ASSERT_EQ(bake_with({{"pbrMetallicRoughness", {{"metallicFactor", 0.25}, {"roughnessFactor", 0.5}}}}).exit_code, 0);
  const std::string text = folder_ / "out.gltf";
  ASSERT_EQ(whittle({"convert", out_, text, "--quiet"}).exit_code, 0);
  const Json lit = parse_json(read_text(text))["materials"][0];
  EXPECT_EQ(lit["pbrMetallicRoughness"]["metallicFactor"], 0.25);
  EXPECT_EQ(lit["pbrMetallicRoughness"]["roughnessFactor"], 0.5);
  EXPECT_TRUE(lit.contains("normalTexture"));
  ASSERT_EQ(bake_with({{"extensions", {{"KHR_materials_unlit", Json::object()}}}}).exit_code, 0);
  ASSERT_EQ(whittle({"convert", out_, text, "--quiet"}).exit_code, 0);
  const Json unlit = parse_json(read_text(text))["materials"][0];
  EXPECT_TRUE(unlit["extensions"].contains("KHR_materials_unlit"));
  EXPECT_FALSE(unlit.contains("normalTexture"));  // nothing would show it
}

TEST_F(BakeCommand, RefusesALookThatItWouldLose) {
  const Json image = {{"index", 0}};
  const std::vector<std::pair<Json, std::string>> cases{
      {{{"normalTexture", image}}, "a normal map"},
      {{{"occlusionTexture", image}}, "a map of occlusion"},
      {{{"pbrMetallicRoughness", {{"metallicRoughnessTexture", image}}}}, "metalness"},
      {{{"emissiveFactor", {0, 1, 0}}}, "emission"},
      {{{"alphaMode", "BLEND"}}, "transparency"},
      {{{"extensions", {{"KHR_materials_clearcoat", Json::object()}}}}, "KHR_materials_clearcoat"}};
  for (const auto& [material, said] : cases) {
    expect_failure(bake_with(material), 4, {"changed.gltf", said});
    EXPECT_FALSE(std::filesystem::exists(out_)) << said;
  }
}

TEST_F(BakeCommand, RefusesTransparencyOfEveryFormat) {
  const std::string obj = folder_ / "glass.obj";
  write_text(folder_ / "glass.mtl", "newmtl glass\nKd 1 0 0\nd 0.5\n");
  write_text(obj, "mtllib glass.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl glass\nf 1 2 3\n");
  expect_failure(bake(obj), 4, {"glass.obj", "transparency"});
}

TEST_F(BakeCommand, RefusesInvalidMaterials) {
  for (const Json& material : {Json{{"pbrMetallicRoughness", {{"metallicFactor", "much"}}}},
                               Json{{"extensions", {1, 2}}}, Json{{"emissiveFactor", "red"}}}) {
    expect_failure(bake_with(material), 4, {"changed.gltf", "material"});
  }
}

TEST_F(BakeCommand, RefusesWhatItCannotDo) {
  expect_failure(bake(low_), 4, {"low.ply", "no colours"});
  expect_usage_error(whittle({"bake", high_, low_, "-o", folder_ / "out.ply"}), {"--output", ".glb"});
  expect_usage_error(bake(high_, {"--texture-size", "1000"}), {"--texture-size", "power of two"});
  expect_usage_error(bake(high_, {"--texture-size", "16384"}), {"--texture-size"});
  expect_failure(bake(folder_ / "missing.ply"), 4, {"missing.ply"});
  IndexedMesh elsewhere = sphere(1);
  for (Vec3& p : elsewhere.positions) p.x() += 5;
  io::write_mesh(low_, elsewhere);
  expect_failure(bake(high_), 4, {"low.ply", "near"});
  write_text(low_, "ply\nformat ascii 1.0\n");
  expect_failure(bake(high_), 4, {"low.ply"});
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(BakeCommand, WarnsOfPlacesThatHighDoesNotHave) {
  IndexedMesh low = sphere(3);
  const IndexedMesh far = sphere(2);
  const auto n = static_cast<Index>(low.positions.size());
  for (const Vec3& p : far.positions) low.positions.push_back(0.5 * p + Vec3(4, 0, 0));
  for (const Triangle& face : far.faces) low.faces.push_back({face[0] + n, face[1] + n, face[2] + n});
  io::write_mesh(low_, low);
  const Outcome outcome = bake(high_, {"--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const Json json = parse_json(outcome.out);
  EXPECT_GT(json["texture"]["missed_share"], 0.1);
  EXPECT_EQ(json["warnings"].size(), 1U) << json;
  EXPECT_NE(outcome.err.find("nearest other part"), std::string::npos) << outcome;
}

}  // namespace
}  // namespace whittle::test
