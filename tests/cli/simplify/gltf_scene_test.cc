// What of a glTF file the scene shows, and how its meshes go together.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_scene.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/read.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

std::size_t n_faces_of(const std::string& path) { return io::read_mesh(path).mesh.faces.size(); }

/// A sphere that is shown, and one that isn't, for one of several reasons.
class Hidden : public testing::TestWithParam<Json> {
 protected:
  Hidden() { write_gltf_scene(in_, {sphere(3), sphere(2)}, GetParam(), {0}); }

  TemporaryFolder folder_;
  std::string in_ = folder_ / "in.glb";
};

TEST_P(Hidden, IsLeftOutOfOtherFormats) {
  const std::string out = folder_ / "out.ply";
  const Outcome converted = whittle({"convert", in_, out});
  ASSERT_EQ(converted.exit_code, 0) << converted;
  EXPECT_THAT(converted.err, HasSubstr("mesh 1 is left out: the scene doesn't show it"));
  EXPECT_EQ(n_faces_of(out), 1280U);
  const Outcome simplified = whittle({"simplify", in_, "-o", out, "--faces", "100"});
  ASSERT_EQ(simplified.exit_code, 0) << simplified;
  EXPECT_LE(n_faces_of(out), 100U);
  const Outcome levels = whittle({"lod", in_, "-o", folder_ / "{i}.ply", "--faces", "500,100"});
  ASSERT_EQ(levels.exit_code, 0) << levels;
  EXPECT_THAT(n_faces_of(folder_ / "0.ply"), testing::Le(500U));
}

TEST_P(Hidden, IsNotMeasured) {
  const Outcome measured = whittle({"measure", in_, in_, "--samples", "1000", "--json", "-"});
  ASSERT_EQ(measured.exit_code, 0) << measured;
  EXPECT_EQ(parse_json(measured.out)["reference"]["faces"], 1280) << measured;
  const Outcome info = whittle({"info", in_, "--json", "-"});
  ASSERT_EQ(info.exit_code, 0) << info;
  EXPECT_EQ(parse_json(info.out)["components"], 1);
}

bool is_level(const Json& nodes) { return nodes.dump().find("MSFT_lod") != std::string::npos; }

TEST_P(Hidden, StaysAsItIsInGltfIfItIsALevel) {
  const std::string out = folder_ / "out.glb";
  const Outcome simplified = whittle({"simplify", in_, "-o", out, "--faces", "100"});
  ASSERT_EQ(simplified.exit_code, 0) << simplified;
  const gltf::Asset before = gltf::Asset::read(in_);
  const gltf::Asset after = gltf::Asset::read(out);
  EXPECT_EQ(Json::parse(after.document())["nodes"], Json::parse(before.document())["nodes"]);
  if (is_level(GetParam())) {
    EXPECT_THAT(simplified.err, HasSubstr("mesh 1 stays as it is: a level of detail (MSFT_lod)"));
    EXPECT_LE(after.n_triangles(0), 100U);
    EXPECT_EQ(after.triangles(1).positions, before.triangles(1).positions);
  } else {
    EXPECT_LE(after.n_triangles(0) + after.n_triangles(1), 100U);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Hidden,
    testing::Values(
        Json{{{"mesh", 0}}, {{"mesh", 1}, {"translation", {5, 0, 0}}}},  // outside of the scene
        Json{{{"mesh", 0}}, {{"children", {2}}}, {{"mesh", 1}}},         // below such a node
        Json{{{"mesh", 0}}, Json::object()},                             // in no node
        Json{{{"mesh", 0}, {"children", {1}}},                           // hidden
             {{"children", {2}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}},
             {{"mesh", 1}}},
        Json{{{"mesh", 0}, {"extensions", {{"MSFT_lod", {{"ids", {1}}}}}}}, {{"mesh", 1}}},     // a level
        Json{{{"mesh", 0}, {"children", {1}}, {"extensions", {{"MSFT_lod", {{"ids", {1}}}}}}},  // one below its node
             {{"children", {2}}},
             {{"mesh", 1}}}));

TEST(GltfScene, ShowsTheFirstOneIfTheFileNamesNone) {
  const TemporaryFolder folder;
  const std::string in = folder / "in.gltf";
  write_gltf_scene(in, {sphere(3), sphere(2)}, {{{"mesh", 0}}, {{"mesh", 1}}}, {0});
  Json document = Json::parse(std::ifstream(in));
  const auto n_converted = [&] {
    std::ofstream(in) << document;
    const Outcome converted = whittle({"convert", in, folder / "out.ply"});
    EXPECT_EQ(converted.exit_code, 0) << converted;
    return n_faces_of(folder / "out.ply");
  };
  document["scenes"].push_back({{"nodes", {1}}});
  EXPECT_EQ(n_converted(), 1280U);
  document["scene"] = 1;
  EXPECT_EQ(n_converted(), 320U);
  document.erase("scene");
  EXPECT_EQ(n_converted(), 1280U);
  document.erase("scenes");
  EXPECT_EQ(n_converted(), 1600U) << "without scenes all nodes are shown";
}

}  // namespace
}  // namespace whittle::test
