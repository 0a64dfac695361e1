// Meshes far from the origin keep their shape in files whose numbers have 32 bits, or a warning says what is lost.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_scene.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

using testing::HasSubstr;
using testing::Not;

const Vec3 utm(500'000.123, 5'400'000.456, 321.789);

class Georeferenced : public testing::Test {
 protected:
  Georeferenced() { io::write_mesh(in_, moved(blob(3, 1), utm)); }

  /// The largest distance between a file and a mesh, as `measure` has it.
  double distance_to(const std::string& path, const std::string& reference) const {
    const Outcome measured = whittle({"measure", reference, path, "--samples", "20000", "--json", "-"});
    EXPECT_EQ(measured.exit_code, 0) << measured;
    const auto report = parse_json(measured.out);
    EXPECT_EQ(report["closed"], true) << measured;
    return report["max"];
  }

  TemporaryFolder folder_;
  std::string in_ = folder_ / "in.obj";
};

TEST_F(Georeferenced, KeepsItsShapeInGltf) {
  const std::vector<std::vector<std::string>> runs{{"convert", in_},
                                                   {"simplify", in_, "--faces", "300", "-o"},
                                                   {"simplify", in_, "--faces", "300", "--effort", "best", "-o"},
                                                   {"simplify", in_, "--max-error", ".01", "-o"},
                                                   {"lod", in_, "--faces", "300", "-o"}};
  for (std::vector<std::string> run : runs) {
    const bool has_levels = run.front() == "lod";
    const std::string exact = folder_ / (has_levels ? "0.ply" : "out.ply");
    const std::string out = folder_ / (has_levels ? "0.glb" : "out.glb");
    run.push_back(has_levels ? folder_ / "{i}.glb" : out);
    const Outcome as_gltf = whittle(run);
    ASSERT_EQ(as_gltf.exit_code, 0) << as_gltf;
    EXPECT_THAT(as_gltf.err, Not(HasSubstr("rounded")));
    run.back() = has_levels ? folder_ / "{i}.ply" : exact;
    ASSERT_EQ(whittle(run).exit_code, 0);
    EXPECT_LT(distance_to(out, exact), 2e-6) << as_gltf;
    const gltf::Asset asset = gltf::Asset::read(out);
    EXPECT_LT(asset.triangles(0).positions.front().cwiseAbs().maxCoeff(), 3) << "beside the node";
  }
}

TEST_F(Georeferenced, IsPrintedWithTheDigitsItNeeds) {
  const Outcome info = whittle({"info", in_});
  EXPECT_THAT(info.out, testing::ContainsRegex("box: 49999[0-9][.][0-9]+ 539999[0-9][.][0-9]+ 32[0-9][.][0-9]+ to "));
  EXPECT_THAT(info.out, Not(HasSubstr("e+0")));
  const Outcome proven = whittle({"simplify", in_, "-o", folder_ / "out.ply", "--max-error", "1%", "-v"});
  EXPECT_THAT(proven.err, testing::ContainsRegex("at (49999[0-9]|50000[0-9])[.][0-9]+ 5[34][09]+[0-9][.][0-9]+ "));
  EXPECT_THAT(proven.err, Not(HasSubstr("e+0")));
}

TEST_F(Georeferenced, IsProvenInGltf) {
  const std::string out = folder_ / "out.glb";
  const Outcome run = whittle({"simplify", in_, "-o", out, "--max-error", "1e-3", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const double proven = parse_json(run.out)["max_error"]["proven"];
  EXPECT_LE(proven, 1e-3);
  EXPECT_LE(distance_to(out, in_), proven);
}

TEST_F(Georeferenced, IsPolishedIntoGltf) {
  const std::string coarse = folder_ / "coarse.ply";
  ASSERT_EQ(whittle({"simplify", in_, "--faces", "300", "--effort", "fast", "-o", coarse}).exit_code, 0);
  ASSERT_EQ(whittle({"polish", in_, coarse, "-o", folder_ / "polished.glb"}).exit_code, 0);
  ASSERT_EQ(whittle({"polish", in_, coarse, "-o", folder_ / "polished.ply"}).exit_code, 0);
  EXPECT_LT(distance_to(folder_ / "polished.glb", folder_ / "polished.ply"), 2e-6);
}

TEST_F(Georeferenced, SaysWhatBinaryStlLoses) {
  const std::string stl = folder_ / "out.stl";
  const Outcome converted = whittle({"convert", in_, stl});
  EXPECT_THAT(converted.err, HasSubstr("positions are rounded by up to 0.2"));
  const Outcome simplified = whittle({"simplify", in_, "-o", stl, "--faces", "300"});
  EXPECT_THAT(simplified.err, HasSubstr("positions are rounded by up to 0.2"));
  const std::string recording = folder_ / "in.rec";
  ASSERT_EQ(whittle({"simplify", in_, "-o", folder_ / "out.ply", "--faces", "300", "--record", recording}).exit_code,
            0);
  const Outcome replayed = whittle({"replay", recording, "--faces", "400", "-o", stl});
  EXPECT_THAT(replayed.err, HasSubstr("positions are rounded by up to 0.2"));
  const Outcome as_gltf = whittle({"replay", recording, "--faces", "400", "-o", folder_ / "level.glb"});
  ASSERT_EQ(as_gltf.exit_code, 0) << as_gltf;
  EXPECT_LT(distance_to(folder_ / "level.glb", in_), 0.2);
}

/// The input has no more digits, so nothing is lost.
TEST_F(Georeferenced, MayHave32BitsAlready) {
  const std::string stl = folder_ / "in.stl";
  const std::string ply = folder_ / "in.ply";
  ASSERT_EQ(whittle({"convert", in_, stl}).exit_code, 0);
  ASSERT_EQ(whittle({"convert", stl, ply}).exit_code, 0);
  for (const std::string& in : {stl, ply}) {
    const Outcome converted = whittle({"convert", in, folder_ / "out.stl"});
    EXPECT_THAT(converted.err, Not(HasSubstr("rounded"))) << converted;
    const Outcome run = whittle({"simplify", in, "-o", folder_ / "out.stl", "--faces", "300"});
    EXPECT_THAT(run.err, Not(HasSubstr("rounded"))) << run;
  }
}

TEST(GeoreferencedGltf, StaysClosedAsOneMesh) {
  const TemporaryFolder folder;
  const std::string in = folder / "in.glb";
  write_gltf_scene(in, {blob(3, 1)}, {{{"mesh", 0}, {"translation", {4'075'539.5, 931'735.25, 4'801'629.125}}}}, {0});
  for (const char* const attributes : {"keep", "position-only"}) {
    const std::string out = folder / "out.glb";
    const Outcome run = whittle({"simplify", in, "-o", out, "--faces", "300", "--attributes", attributes});
    ASSERT_EQ(run.exit_code, 0) << run;
    const Outcome info = whittle({"info", out, "--json", "-"});
    EXPECT_EQ(parse_json(info.out)["closed"], true) << attributes << info;
    EXPECT_EQ(parse_json(info.out)["faces"], 300) << attributes << info;
  }
  const Outcome stl = whittle({"convert", in, folder / "out.stl"});
  EXPECT_THAT(stl.err, HasSubstr("positions are rounded by up to 0."));
}

}  // namespace
}  // namespace whittle::test
