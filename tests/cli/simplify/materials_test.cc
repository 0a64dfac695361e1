// Files beside meshes: material libraries and textures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/read.hh"

namespace whittle::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

/// Two squares of two materials: one has a texture, the other one is red.
class Materials : public testing::Test {
 protected:
  Materials() {
    fs::create_directories(folder_.path() / "in" / "tex");
    fs::create_directories(folder_.path() / "out");
    write_text(in_,
               "mtllib two.mtl none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\n"
               "vt 1 0.25\nusemtl wall\nf 1/1 2/2 3/3 4/1\nusemtl red\nf 2/1 5/1 6/1 3/1\n");
    write_text(folder_ / "in/two.mtl",
               "newmtl wall\nmap_Kd tex\\wall 1.png\nmap_d ../outside.png\nnewmtl red\nKd 1 0 0\nd 0.5\n");
    write_text(folder_ / "in/tex/wall 1.png", wall_);
    write_text(folder_ / "outside.png", wall_ + "another");
  }

  std::vector<std::string> warnings(const Outcome& outcome) { return parse_json(outcome.out)["warnings"]; }

  const std::string wall_ = "\x89PNG\r\n\x1A\n an image";
  TemporaryFolder folder_;
  const std::string in_ = folder_ / "in/two.obj";
};

TEST_F(Materials, ComeAlongInAnotherFolder) {
  const std::string out = folder_ / "out/small.obj";
  const Outcome outcome = whittle({"convert", in_, out, "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(read_text(folder_ / "out/two.mtl"), read_text(folder_ / "in/two.mtl"));
  EXPECT_EQ(read_text(folder_ / "out/tex/wall 1.png"), wall_);
  EXPECT_THAT(outcome.err, HasSubstr("small.obj: copied two.mtl and 1 more file beside it\n"));
  EXPECT_THAT(warnings(outcome),
              testing::ElementsAre(HasSubstr("../outside.png (outside of the folder), none.mtl (not there)")));
  const Outcome again = whittle({"simplify", in_, "-o", out, "--faces", "4"});
  EXPECT_THAT(again.err, testing::Not(HasSubstr("copied two")));
}

TEST_F(Materials, ReplaceNoFile) {
  write_text(folder_ / "out/two.mtl", "newmtl mine\n");
  const Outcome outcome = whittle({"simplify", in_, "-o", folder_ / "out/o.obj", "--faces", "4", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(read_text(folder_ / "out/two.mtl"), "newmtl mine\n");
  EXPECT_THAT(warnings(outcome), testing::Contains(HasSubstr("two.mtl (there is another one)")));
}

TEST_F(Materials, AreNotReplacedWithoutForce) {
  for (const char* file : {"in/tex/wall 1.png", "in/two.mtl"}) {
    const std::string before = read_text(folder_ / file);
    std::vector<std::string> arguments{"convert", in_, folder_ / file, "--output-format", "ply", "--quiet"};
    expect_usage_error(whittle(arguments), {"an input needs this file", "--force"});
    EXPECT_EQ(read_text(folder_ / file), before);
    arguments.insert(arguments.end(), {"--json", folder_ / "report.json", "--force"});
    EXPECT_EQ(whittle(arguments).exit_code, 0);
    EXPECT_TRUE(read_text(folder_ / file).starts_with("ply\n"));
  }
}

TEST_F(Materials, GoWithThePositionsAlone) {
  for (const char* extension : {"obj", "ply", "glb"}) {
    const std::string out = folder_ / (std::string("out/bare.") + extension);
    const Outcome outcome =
        whittle({"simplify", in_, "-o", out, "--faces", "4", "--attributes", "position-only", "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_EQ(warnings(outcome).size(), 0U) << outcome;
    for (const char* word : {"mtllib", "usemtl", "TextureFile", "wall"}) {
      EXPECT_THAT(read_text(out), testing::Not(HasSubstr(word))) << extension;
    }
    fs::remove(out);
  }
  EXPECT_TRUE(fs::is_empty(folder_.path() / "out"));
}

TEST_F(Materials, OfOneTextureNameItInPly) {
  const Outcome outcome = whittle({"convert", in_, folder_ / "out/two.ply"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_THAT(read_text(folder_ / "out/two.ply"), HasSubstr("\ncomment TextureFile tex/wall 1.png\n"));
  EXPECT_EQ(read_text(folder_ / "out/tex/wall 1.png"), wall_);
  // The way back says nothing of what is left out: the library names the texture.
  EXPECT_THAT(whittle({"convert", folder_ / "out/two.ply", folder_ / "out/back.obj"}).err,
              testing::Not(HasSubstr("OBJ names textures")));

  write_text(folder_ / "in/two.mtl", "newmtl wall\nmap_Kd tex\\wall 1.png\nnewmtl red\nmap_Kd b.png\n");
  const Outcome several = whittle({"convert", in_, folder_ / "in/several.ply"});
  EXPECT_THAT(several.err, HasSubstr("has 2 textures, which other programs don't read from PLY: write OBJ or glTF"));
  EXPECT_THAT(read_text(folder_ / "in/several.ply"), testing::Not(HasSubstr("TextureFile")));
}

/// Each triangle has a corner of the texture to itself.
TEST(Charts, OfOneTriangleEachAreSaid) {
  const TemporaryFolder folder;
  const IndexedMesh shape = io::read_mesh(data_file("blob.obj")).mesh;
  std::ostringstream obj;
  for (const Vec3& p : shape.positions) obj << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const double u = static_cast<double>(f) / static_cast<double>(shape.faces.size());
    obj << "vt " << u << " 0\nvt " << u << " 0.5\nvt " << u << " 1\n";
    obj << 'f';
    for (std::size_t c = 0; c < 3; ++c) obj << ' ' << shape.faces[f][c] + 1 << '/' << 3 * f + c + 1;
    obj << '\n';
  }
  const std::string in = folder / "in.obj";
  write_text(in, obj.str());
  const auto mean_error = [&](std::vector<std::string> more, bool is_said) {
    std::vector<std::string> run{"simplify", in, "-o", folder / "out.obj", "--faces", "500"};
    run.insert(run.end(), more.begin(), more.end());
    const Outcome outcome = whittle(run);
    EXPECT_EQ(outcome.err.find("each triangle is a chart of its own") != std::string::npos, is_said) << outcome;
    return parse_json(whittle({"measure", in, folder / "out.obj", "--json", "-"}).out)["mean"].get<double>();
  };
  const double with_texture = mean_error({}, true);
  EXPECT_LT(mean_error({"--attributes", "position-only"}, false), with_texture) << "as the warning advises";
  EXPECT_EQ(whittle({"simplify", data_file("blob.obj"), "-o", folder / "o.obj", "--faces", "500"}).err.find("chart"),
            std::string::npos);
}

TEST_F(Materials, StayWhereTheOutputDoesNotNameThem) {
  for (const char* name : {"out/o.stl", "in/o.obj"}) {
    const Outcome outcome = whittle({"convert", in_, folder_ / name});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_THAT(outcome.err, testing::Not(HasSubstr("copied")));
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "out" / "two.mtl"));
}

TEST_F(Materials, OfPlyAreItsTextures) {
  const std::string in = folder_ / "in/t.ply";
  write_text(in,
             "ply\nformat ascii 1.0\ncomment TextureFile tex/wall 1.png\nelement vertex 3\nproperty float x\n"
             "property float y\nproperty float z\nproperty float s\nproperty float t\nelement face 1\n"
             "property list uchar int vertex_indices\nend_header\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 0.25\n3 0 1 2\n");
  ASSERT_EQ(whittle({"convert", in, folder_ / "out/t.ply"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out/tex/wall 1.png"));
  ASSERT_EQ(whittle({"convert", in, folder_ / "out/t.glb"}).exit_code, 0);
  const Json document = Json::parse(gltf::Asset::read(folder_ / "out/t.glb").document());
  EXPECT_TRUE(document["materials"][0]["pbrMetallicRoughness"].contains("baseColorTexture")) << document;
  std::string several = read_text(in);
  several.insert(several.find("element"), "comment TextureFile b.png\n");
  write_text(in, several);
  const Outcome outcome = whittle({"convert", in, folder_ / "out/s.glb", "--json", "-"});
  EXPECT_THAT(warnings(outcome), testing::Contains(HasSubstr("nothing says which faces have which")));
  EXPECT_FALSE(Json::parse(gltf::Asset::read(folder_ / "out/s.glb").document()).contains("images"));
}

TEST_F(Materials, BecomeThoseOfGltf) {
  for (const char* name : {"out/o.glb", "out/o.gltf"}) {
    const std::string out = folder_ / name;
    const Outcome outcome = whittle({"simplify", in_, "-o", out, "--faces", "4", "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    const gltf::Asset asset = gltf::Asset::read(out);
    const Json document = Json::parse(asset.document());
    EXPECT_EQ(document["materials"][0]["name"], "wall");
    EXPECT_EQ(document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
    EXPECT_EQ(document["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"][3], 0.5);
    EXPECT_EQ(document["materials"][1]["alphaMode"], "BLEND");
    const IndexedMesh mesh = asset.triangles(0);
    EXPECT_EQ(mesh.faces.size(), 4U);
    const auto& values = mesh.attributes[0].values;
    EXPECT_THAT(values, testing::Contains(0.75)) << "textures begin at the top";
    EXPECT_THAT(warnings(outcome), testing::Contains(HasSubstr("none.mtl")));
  }
  EXPECT_TRUE(fs::exists(folder_ / "out/tex/wall 1.png")) << "a text names it";
  ASSERT_EQ(whittle({"convert", folder_ / "out/o.glb", folder_ / "back.obj"}).exit_code, 0);
  EXPECT_THAT(io::read_mesh(folder_ / "back.obj").mesh.attributes[0].values, testing::Contains(0.25));
}

TEST_F(Materials, LeaveOutImagesThatGltfDoesNotHave) {
  write_text(folder_ / "in/tex/wall 1.png", "GIF89a");
  write_text(folder_ / "in/two.mtl", "newmtl wall\nKd 0 1 0\nmap_Kd tex\\wall 1.png\n");
  const Outcome outcome = whittle({"convert", in_, folder_ / "out/o.glb", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_THAT(warnings(outcome), testing::Contains(HasSubstr("neither PNG nor JPEG are left out: tex/wall 1.png")));
  const Json document = Json::parse(gltf::Asset::read(folder_ / "out/o.glb").document());
  EXPECT_FALSE(document.contains("images"));
  EXPECT_EQ(document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"], Json::parse("[0, 1, 0, 1]"))
      << "no texture hides Kd";
}

TEST_F(Materials, DoNotMatterToWhatIsRefused) {
  expect_usage_error(whittle({"convert", in_, folder_ / "out/o.glb", "--ascii"}), {"--ascii"});
  write_text(folder_ / "far.obj", "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome far = whittle({"convert", folder_ / "far.obj", folder_ / "out/far.glb"});
  EXPECT_EQ(far.exit_code, 1) << far;
  EXPECT_THAT(far.err, HasSubstr("a coordinate is too large"));
}

TEST_F(Materials, AreKeptWhereOnlyTheContainerOfGltfChanges) {
  ASSERT_EQ(whittle({"convert", in_, folder_ / "out/o.gltf"}).exit_code, 0);
  ASSERT_EQ(whittle({"convert", folder_ / "out/o.gltf", folder_ / "out/p.glb"}).exit_code, 0);
  const gltf::Asset asset = gltf::Asset::read(folder_ / "out/p.glb");
  EXPECT_EQ(asset.n_triangles(0), 4U);
  EXPECT_EQ(Json::parse(asset.document())["materials"].size(), 2U);
}

TEST_F(Materials, MayHaveNamesThatAreNoText) {
  const std::string in = folder_ / "in/latin.obj";
  write_text(in, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl b\xf6se\nf 1 2 3\nusemtl gut\nf 1 3 4\n");
  const Outcome outcome = whittle({"simplify", in, "-o", folder_ / "latin.glb", "--faces", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const Json document = Json::parse(gltf::Asset::read(folder_ / "latin.glb").document());
  EXPECT_EQ(document["materials"][0]["name"], "b\uFFFDse");
}

}  // namespace
}  // namespace whittle::test
