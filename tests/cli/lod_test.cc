#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "support/temporary_folder.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"
#include "whittle/metrics/certify.hh"

namespace whittle::test {
namespace {

TEST(Lod, WritesLevelsByCount) {
  const TemporaryFolder folder;
  const Outcome outcome = whittle({"lod", data_file("blob.obj"), "--faces", "300,2000,300", "-o",
                                   folder / "blob_{faces}_{vertices}_{i}.ply", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const auto levels = nlohmann::json::parse(outcome.out)["levels"];
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_EQ(levels[0]["path"], folder / "blob_2000_1002_0.ply");
  EXPECT_EQ(levels[1]["path"], folder / "blob_300_152_1.ply");
  EXPECT_LT(levels[0]["max_cost"], levels[1]["max_cost"]);
  EXPECT_EQ(levels[0]["max_error"], nullptr);
  for (const auto& level : levels) EXPECT_TRUE(std::filesystem::exists(std::string(level["path"])));
}

TEST(Lod, WritesLevelsThatAreProven) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("terrain.ply");
  const Outcome outcome =
      whittle({"lod", mesh, "--errors", "2%,0.5%", "-o", folder / "terrain_{i}.ply", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const auto levels = nlohmann::json::parse(outcome.out)["levels"];
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_GT(levels[0]["faces"], levels[1]["faces"]);
  const IndexedMesh input = io::read_mesh(mesh).mesh;
  for (const auto& level : levels) {
    const IndexedMesh written = io::read_mesh(std::string(level["path"])).mesh;
    EXPECT_EQ(metrics::certify(input, written, level["max_error"]).verdict, Verdict::proven);
    EXPECT_LT(written.faces.size(), input.faces.size() / 2);
  }
}

TEST(Lod, WarnsOfLevelsWhoseWallsCross) {
  const TemporaryFolder folder;
  const std::string mesh = folder / "wall.ply";
  io::write_mesh(mesh, thin_wall(60));
  const Outcome outcome = whittle({"lod", mesh, "--ratios", "90%,4%", "-o", folder / "{i}.ply", "--json", "-"});
  const auto report = nlohmann::json::parse(outcome.out);
  const std::string coarse = "at " + report["levels"][1]["faces"].dump() + " faces, ";
  EXPECT_THAT(outcome.err, testing::ContainsRegex(coarse + "[0-9]+ pairs of faces of one part cross"));
  EXPECT_THAT(report["warnings"].dump(), testing::HasSubstr(coarse));
  EXPECT_THAT(outcome.err, testing::Not(testing::HasSubstr("at " + report["levels"][0]["faces"].dump())));
}

TEST(Lod, SaysThatAFileCantHoldALevelSoNear) {
  const TemporaryFolder folder;
  const Outcome outcome = whittle({"lod", data_file("terrain.ply"), "--errors", "1e-12", "-o", folder / "{i}.stl"});
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, testing::HasSubstr("1e-12"));
  EXPECT_FALSE(std::filesystem::exists(folder / "0.stl"));
}

/// Texture coordinates of the cube are linear in the position, a side.
void expect_charts(const IndexedMesh& mesh) {
  ASSERT_FALSE(mesh.attributes.empty());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 normal = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    if (normal.norm() == 0) continue;
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const std::size_t side = 2 * static_cast<std::size_t>(axis) + (normal[axis] > 0 ? 1 : 0);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto expected = chart_position(side, mesh.positions[mesh.faces[f][i]]);
      const auto value = mesh.attributes[0].value(mesh.wedge(f, i));
      for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(value[k], expected[k], 1e-3);
    }
  }
}

nlohmann::json read_document(const std::string& path) {
  return nlohmann::json::parse(gltf::Asset::read(path).document());
}

TEST(Lod, KeepsWhatGltfHasInFilesOfLevels) {
  const TemporaryFolder folder;
  const std::string in = folder / "cube.glb";
  write_gltf_cube(in, 8);
  for (const std::vector<std::string>& levels :
       {std::vector<std::string>{"--faces", "300,60"}, std::vector<std::string>{"--errors", "0.01%,1%"}}) {
    for (const std::string effort : {"normal", "best"}) {
      const Outcome outcome =
          whittle({"lod", in, levels[0], levels[1], "--effort", effort, "-o", folder / "{i}.gltf", "--json", "-"});
      ASSERT_EQ(outcome.exit_code, 0) << outcome;
      EXPECT_EQ(parse_json(outcome.out)["warnings"].size(), 0U) << outcome;
      for (const char* const level : {"0.gltf", "1.gltf"}) {
        const nlohmann::json document = read_document(folder / level);
        EXPECT_EQ(document["materials"], read_document(in)["materials"]);
        EXPECT_EQ(document["nodes"], read_document(in)["nodes"]);
        expect_charts(gltf::Asset::read(folder / level).triangles(0));
      }
    }
  }
}

TEST(Lod, WritesLevelsIntoOneGltfFile) {
  const TemporaryFolder folder;
  const std::string in = folder / "cube.glb";
  write_gltf_cube(in, 8);
  const std::string out = folder / "levels.glb";
  const Outcome outcome = whittle({"lod", in, "--faces", "300,60", "-o", out, "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const gltf::Asset asset = gltf::Asset::read(out);
  const nlohmann::json document = nlohmann::json::parse(asset.document());
  EXPECT_EQ(document["materials"], read_document(in)["materials"]);
  const IndexedMesh finest = asset.triangles(0);
  EXPECT_EQ(finest.faces, gltf::Asset::read(in).triangles(0).faces) << "the input stays as it was";
  for (const nlohmann::json& node : document["nodes"]) {
    if (!node.contains("extensions")) continue;
    const nlohmann::json& ids = node["extensions"]["MSFT_lod"]["ids"];
    ASSERT_EQ(ids.size(), 2U);
    const auto mesh_of = [&](std::size_t i) {
      return document["nodes"][ids[i].get<std::size_t>()]["mesh"].get<std::size_t>();
    };
    EXPECT_LE(asset.n_triangles(mesh_of(0)), 300U);
    EXPECT_LE(asset.n_triangles(mesh_of(1)), 60U);
    expect_charts(asset.triangles(mesh_of(1)));
    const nlohmann::json& coverage = node["extras"]["MSFT_screencoverage"];
    ASSERT_EQ(coverage.size(), 3U);
    EXPECT_GE(coverage[0], coverage[1]);
    EXPECT_EQ(coverage[2], 0);
    EXPECT_LE(coverage[0], 1);
  }
  expect_usage_error(whittle({"lod", out, "--faces", "50", "-o", folder / "again.glb", "--quiet"}),
                     {"MSFT_lod", "{i}"});
}

TEST(Lod, MakesOneGltfFileOfOtherFormats) {
  const TemporaryFolder folder;
  const std::string out = folder / "blob.glb";
  const Outcome outcome = whittle({"lod", data_file("blob.obj"), "--ratios", "50%,10%", "-o", out});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const gltf::Asset asset = gltf::Asset::read(out);
  ASSERT_EQ(asset.n_meshes(), 3U);
  EXPECT_EQ(asset.n_triangles(0), io::read_mesh(data_file("blob.obj")).mesh.faces.size());
  EXPECT_LT(asset.n_triangles(2), asset.n_triangles(1) / 4);
}

TEST(Lod, KeepsTextureCoordinatesAndMaterialsOfObj) {
  const TemporaryFolder folder;
  write_gltf_cube(folder / "cube.glb", 8);
  ASSERT_EQ(whittle({"convert", folder / "cube.glb", folder / "cube.obj"}).exit_code, 0);
  const Outcome outcome = whittle({"lod", folder / "cube.obj", "--faces", "300,60", "-o", folder / "{faces}.obj"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const IndexedMesh level = io::read_mesh(folder / "60.obj", {.attributes = io::AttributeScope::all}).mesh;
  EXPECT_EQ(level.group_names.size(), 2U);
  IndexedMesh turned = level;
  for (Vec3& p : turned.positions) p /= 3;  // the scene has the cube three times as large
  for (std::size_t w = 0; w < turned.attributes[0].size(); ++w) {
    turned.attributes[0].value(w)[1] = 1 - turned.attributes[0].value(w)[1];
  }
  expect_charts(turned);
}

TEST(Lod, SaysWhichLevelsAreNotReached) {
  const TemporaryFolder folder;
  const Outcome outcome = whittle({"lod", data_file("bracket.stl"), "--faces", "100,15,10", "-o", folder / "{i}.ply"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_THAT(outcome.err, testing::HasSubstr("2 levels not reached"));
}

TEST(Lod, GoesAsFarAsPossibleForAShareOfNothing) {
  const TemporaryFolder folder;
  for (const std::string option : {"--face-ratios", "--ratios"}) {
    const std::vector<std::string> levels{"lod", data_file("blob.obj"), option, "50%,0.001%", "-o", folder / "{i}.ply"};
    const Outcome outcome = whittle(levels);
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_THAT(outcome.err, testing::HasSubstr("1 level not reached: the last one has 4 faces, and the pairs left"));
    EXPECT_EQ(io::read_mesh(folder / "1.ply").mesh.faces.size(), 4U);
  }
}

TEST(Lod, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("cubes.obj");
  const std::string out = folder / "out{i}.obj";
  const auto lod = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"lod", mesh});
    return whittle(more);
  };
  expect_usage_error(lod({"-o", out}), {"--ratios", "only one"});
  expect_usage_error(lod({"-o", out, "--ratios", "0.5", "--faces", "100"}), {"only one"});
  expect_usage_error(lod({"-o", folder / "out.obj", "--faces", "100"}), {"{faces}"});
  expect_usage_error(lod({"-o", out, "--ratios", "0.5,1"}), {"--ratios", "1"});
  expect_usage_error(lod({"-o", out, "--faces", "100,"}), {"--faces"});
  expect_usage_error(lod({"-o", out, "--errors", "0"}), {"--errors", "above 0"});
  expect_usage_error(lod({"-o", out, "--faces", "1000"}), {"has 300 faces", "1000"});
  expect_failure(whittle({"lod", folder / "missing.obj", "-o", out, "--faces", "100"}), 4, {"missing.obj"});
}

}  // namespace
}  // namespace whittle::test
