// The subcommand `polish`.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "program/gltf_cube.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/wedges.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"
#include "whittle/metrics/distance.hh"

namespace whittle::test {
namespace {

class PolishCommand : public testing::Test {
 protected:
  void SetUp() override {
    const Outcome outcome = whittle(
        {"simplify", knot_, "-o", small_, "--ratio", "10%", "--effort", "fast", "--engine", "openmesh", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
  }
  double rms(const std::string& mesh) const {
    return metrics::surface_distance(io::read_mesh(knot_).mesh, io::read_mesh(mesh).mesh, {.samples = 50'000}).rms;
  }

  TemporaryFolder folder_;
  std::string knot_ = data_file("knot.ply");
  std::string small_ = folder_ / "small.ply";
  std::string better_ = folder_ / "better.ply";
};

TEST_F(PolishCommand, FitsAResultOfAnotherProgram) {
  const Outcome outcome = whittle({"polish", knot_, small_, "-o", better_, "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const auto json = parse_json(outcome.out);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["polish"]["passes"], 3);
  EXPECT_GT(json["polish"]["moved"], 2000);
  EXPECT_LT(json["polish"]["rms_after"], json["polish"]["rms_before"]);
  EXPECT_GT(json["seconds"]["polish"], 0);
  EXPECT_LT(rms(better_), 0.9 * rms(small_));
  EXPECT_EQ(io::read_mesh(better_).mesh.faces, io::read_mesh(small_).mesh.faces);
  EXPECT_NE(outcome.err.find("3 passes"), std::string::npos) << outcome;
}

TEST_F(PolishCommand, LeavesWhatFitsAsItIs) {
  const Outcome outcome = whittle({"polish", small_, small_, "-o", better_, "--json", "-", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(parse_json(outcome.out)["polish"]["moved"], 0);
  EXPECT_EQ(io::read_mesh(better_).mesh.positions, io::read_mesh(small_).mesh.positions);
}

TEST_F(PolishCommand, SaysThatNoPassWasAskedFor) {
  const Outcome outcome = whittle({"polish", knot_, small_, "-o", better_, "--passes", "0"});
  EXPECT_NE(outcome.err.find("left as it was, no pass was asked for"), std::string::npos) << outcome;
}

TEST_F(PolishCommand, KeepsWhatGltfHas) {
  const std::string in = folder_ / "cube.glb";
  const std::string small = folder_ / "cube_small.glb";
  const std::string polished = folder_ / "cube_polished.glb";
  write_gltf_cube(in, 8);
  ASSERT_EQ(whittle({"simplify", in, "-o", small, "--faces", "60", "--quiet"}).exit_code, 0);
  const Outcome outcome = whittle({"polish", in, small, "-o", polished, "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_TRUE(parse_json(outcome.out)["warnings"].empty());
  const gltf::Asset before = gltf::Asset::read(small);
  const gltf::Asset after = gltf::Asset::read(polished);
  for (const char* const kept : {"materials", "nodes", "animations", "scenes", "extras"}) {
    EXPECT_EQ(parse_json(after.document())[kept], parse_json(before.document())[kept]);
  }
  const IndexedMesh a = before.triangles(0);
  const IndexedMesh b = after.triangles(0);
  ASSERT_EQ(a.faces.size(), b.faces.size());
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(a.normals[a.wedge(f, k)], b.normals[b.wedge(f, k)]) << "the edges of the cube stay sharp";
      EXPECT_TRUE(std::ranges::equal(a.attributes[0].value(a.wedge(f, k)), b.attributes[0].value(b.wedge(f, k))));
    }
  }
}

TEST_F(PolishCommand, KeepsTextureCoordinatesAndSeams) {
  const std::string torus = folder_ / "torus.obj";
  const std::string small = folder_ / "torus_small.obj";
  io::write_mesh(torus, textured_torus(60, 40));
  ASSERT_EQ(whittle({"simplify", torus, "-o", small, "--faces", "500", "--effort", "fast", "--quiet"}).exit_code, 0);
  const Outcome outcome = whittle({"polish", torus, small, "-o", folder_ / "torus_polished.obj", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_GT(parse_json(outcome.out)["polish"]["moved"], 0);
  const io::ReadOptions all{.attributes = io::AttributeScope::all};
  const IndexedMesh before = io::read_mesh(small, all).mesh;
  const IndexedMesh after = io::read_mesh(folder_ / "torus_polished.obj", all).mesh;
  EXPECT_EQ(after.wedges, before.wedges);
  EXPECT_EQ(after.attributes[0].values, before.attributes[0].values);
  EXPECT_EQ(seam_edges(after), seam_edges(before));
}

TEST_F(PolishCommand, WritesNothingWhereSomethingIsWrong) {
  EXPECT_EQ(whittle({"polish", knot_, small_}).exit_code, 2);
  EXPECT_EQ(whittle({"polish", knot_, small_, "-o", small_}).exit_code, 2) << "without --force";
  EXPECT_EQ(whittle({"polish", knot_, folder_ / "missing.ply", "-o", better_}).exit_code, 4);
  EXPECT_EQ(whittle({"polish", knot_, small_, "-o", better_, "--passes", "-1"}).exit_code, 2);
  EXPECT_EQ(folder_.files(), std::vector<std::string>{"small.ply"});
}

}  // namespace
}  // namespace whittle::test
