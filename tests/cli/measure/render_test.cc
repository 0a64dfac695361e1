// `measure --render`: pictures of both meshes.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program/gltf_cube.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

constexpr char png_signature[] = "\x89PNG\r\n\x1A\n";

/// Skips where the program, or the machine, can't draw.
class Render : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string mesh = data_file("cubes.obj");
    const Outcome outcome = whittle({"measure", mesh, mesh, "--samples", "1", "--render", "1"});
    if (outcome.exit_code != 0) GTEST_SKIP() << outcome.err;
  }

  nlohmann::json measured(const std::string& reference, const std::string& test, const std::string& warning = {}) {
    const Outcome outcome = whittle({"measure", reference, test, "--samples", "2000", "--render", "3", "--json", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_NE(outcome.err.find(warning), std::string::npos) << outcome;
    if (warning.empty()) {
      EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome;
    }
    return parse_json(outcome.out);
  }

  /// A picture of many colours, as a file for textures.
  void write_texture(const std::string& name) const {
    const Outcome outcome = whittle({"measure", data_file("terrain.ply"), data_file("knot.ply"), "--samples", "1",
                                     "--render", "1", "--render-image", folder_ / name});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
  }

  /// A square of the material "m". \param u of its left side
  std::string obj_square(const std::string& name, double u) const {
    const std::string left = std::to_string(u), right = std::to_string(u + 1);
    write_text(folder_.path() / name, "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt " + left + " 0\nvt " +
                                          right + " 0\nvt " + right + " 1\nvt " + left +
                                          " 1\nusemtl m\nf 1/1 2/2 3/3 4/4\n");
    return folder_ / name;
  }

  const TemporaryFolder folder_;
};

TEST_F(Render, FindsNoDifferenceBetweenAMeshAndItself) {
  const auto render = measured(data_file("knot.ply"), data_file("knot.ply"))["render"];
  EXPECT_EQ(render["views"], 3);
  EXPECT_TRUE(render["psnr"]["pooled"].is_null());
  EXPECT_EQ(render["flip"]["mean"], 0.0);
  EXPECT_EQ(render["flip"]["worst"], 0.0);
}

TEST_F(Render, SeesThatATextureSlips) {
  write_texture("t.png");
  write_text(folder_.path() / "m.mtl", "newmtl m\nmap_Kd t.png\n");
  const auto json = measured(obj_square("a.obj", 0), obj_square("b.obj", 0.25));
  EXPECT_EQ(json["max"], 0.0);
  ASSERT_EQ(json["attributes"].size(), 1U);
  EXPECT_NEAR(json["attributes"][0]["mean"].get<double>(), 0.25, 1e-9);
  EXPECT_LT(json["render"]["psnr"]["pooled"].get<double>(), 30);
  EXPECT_GT(json["render"]["flip"]["mean"].get<double>(), 0.001);
}

TEST_F(Render, SeesMaterials) {
  write_text(folder_.path() / "m.mtl", "newmtl m\nKd 1 0 0\n");
  const auto json = measured(obj_square("a.obj", 0), obj_square("b.obj", 0.25));
  EXPECT_TRUE(json["render"]["psnr"]["pooled"].is_null()) << "both are red all over";
  write_text(folder_.path() / "n.mtl", "newmtl m\nKd 0 1 0\n");
  std::string green = read_text(folder_.path() / "b.obj");
  green.replace(green.find("m.mtl"), 5, "n.mtl");
  write_text(folder_.path() / "green.obj", green);
  EXPECT_LT(measured(folder_ / "a.obj", folder_ / "green.obj")["render"]["psnr"]["pooled"].get<double>(), 20);
}

TEST_F(Render, FindsNoDifferenceToTheGltfOfAnOpenSurface) {
  write_texture("t.png");
  write_text(folder_.path() / "m.mtl", "newmtl m\nKd 1 0 0\nmap_Kd t.png\n");
  ASSERT_EQ(whittle({"convert", obj_square("a.obj", 0), folder_ / "a.glb"}).exit_code, 0);
  EXPECT_TRUE(measured(folder_ / "a.obj", folder_ / "a.glb")["render"]["psnr"]["pooled"].is_null());
}

TEST_F(Render, ReadsTheTextureOfPly) {
  write_texture("t.png");
  const auto ply = [&](const std::string& name, const std::string& comment) {
    write_text(folder_.path() / name, "ply\nformat ascii 1.0\n" + comment +
                                          "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                                          "property float s\nproperty float t\nelement face 1\n"
                                          "property list uchar int vertex_indices\nend_header\n"
                                          "0 0 0 0 0\n1 0 0 1 0\n0 0 1 0 1\n3 0 1 2\n");
    return folder_ / name;
  };
  const std::string textured = ply("a.ply", "comment TextureFile t.png\n");
  const std::string plain = ply("b.ply", "");
  EXPECT_FALSE(measured(textured, plain)["render"]["psnr"]["pooled"].is_null());
  EXPECT_TRUE(measured(plain, ply("c.ply", "comment TextureFile no.png\n"),
                       "c.ply: texture no.png is not drawn")["render"]["psnr"]["pooled"]
                  .is_null());
}

TEST_F(Render, SaysWhichTexturesAreNotDrawn) {
  const auto json =
      measured(obj_square("a.obj", 0), data_file("flat.off"), "a.obj: material library m.mtl can't be read");
  EXPECT_EQ(json["render"]["warnings"].size(), 1U);
  write_text(folder_.path() / "m.mtl", "newmtl m\nmap_Kd m.mtl\n");
  measured(folder_ / "a.obj", data_file("flat.off"), "texture m.mtl is not drawn: an image is neither PNG nor JPEG");
}

TEST_F(Render, DrawsTheSceneOfGltf) {
  const std::string cube = folder_ / "cube.glb", small = folder_ / "small.glb";
  write_gltf_cube(cube, 6);
  ASSERT_EQ(whittle({"simplify", cube, "-o", small, "--faces", "60"}).exit_code, 0);
  const auto json = measured(cube, small);
  EXPECT_TRUE(json["render"]["psnr"]["pooled"].is_null() || json["render"]["psnr"]["pooled"].get<double>() > 40);
  std::vector<std::string> names;
  for (const auto& attribute : json["attributes"]) names.push_back(attribute["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"NORMAL", "TEXCOORD_0"}));
  // The node enlarges the cube to 3; the box of the same size without the node's scale is drawn larger than its meshes.
  io::write_mesh(folder_ / "box.off", charted_cube(6));
  EXPECT_LT(measured(cube, folder_ / "box.off")["render"]["psnr"]["pooled"].get<double>(), 30);
}

TEST_F(Render, WritesTheWorstView) {
  const std::string image = folder_ / "worst.png";
  const Outcome outcome = whittle({"measure", data_file("blob.obj"), data_file("cubes.obj"), "--samples", "10",
                                   "--render", "2", "--render-image", image});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_NE(outcome.out.find("PSNR, dB"), std::string::npos) << outcome;
  EXPECT_NE(outcome.out.find("FLIP"), std::string::npos) << outcome;
  EXPECT_TRUE(read_text(image).starts_with(png_signature));
}

TEST_F(Render, RefusesWhatItCantDo) {
  const std::string mesh = data_file("cubes.obj");
  for (const char* views : {"0", "10001", "x", "1.5"}) {
    EXPECT_EQ(whittle({"measure", mesh, mesh, "--render", views}).exit_code, 2) << views;
  }
  const Outcome alone = whittle({"measure", mesh, mesh, "--render-image", folder_ / "a.png"});
  EXPECT_EQ(alone.exit_code, 2) << alone;
  EXPECT_NE(alone.err.find("--render-image needs --render N"), std::string::npos) << alone;
  EXPECT_EQ(whittle({"measure", mesh, mesh, "--render", "1", "--render-image", mesh}).exit_code, 2);
  EXPECT_EQ(whittle({"measure", mesh, mesh, "--render", "1", "--render-image", folder_ / "no/a.png"}).exit_code, 1);
}

}  // namespace
}  // namespace whittle::test
