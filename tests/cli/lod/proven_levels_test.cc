// Levels by error and by the distance of a camera: proven as they are written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
#include "program/gltf_scene.hh"
#include "program/gltf_sheet.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "support/temporary_folder.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

Arguments with_more(Arguments all, const Arguments& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The largest distance that is found between two files; of glTF as they are shown.
double largest_found(const std::string& a, const std::string& b) {
  const Outcome measured = whittle({"measure", a, b, "--samples", "1000", "--exact", "1e-3", "--json", "-"});
  EXPECT_EQ(measured.exit_code, 0) << measured;
  const Json exact = parse_json(measured.out)["exact"];
  return std::max(exact["forward"]["at_least"].get<double>(), exact["backward"]["at_least"].get<double>());
}

class ProvenLevels : public testing::Test {
 protected:
  /// Levels of a file, each within its error. \param output a template
  Json expect_within(const std::string& input, const std::string& output, const Arguments& options) {
    const Outcome run = whittle(with_more({"lod", input, "-o", folder_ / output, "--json", "-"}, options));
    EXPECT_EQ(run.exit_code, 0) << run;
    if (run.exit_code != 0) return Json::object();
    Json report = parse_json(run.out);
    for (const Json& level : report["levels"]) {
      EXPECT_LE(largest_found(input, level["path"]), level["max_error"]) << testing::PrintToString(options) << level;
      EXPECT_LT(level["faces"], report["input"]["faces"]) << level;
    }
    return report;
  }

  /// glTF files: of a mesh at several places, one of which draws it out; with a skin; with textures.
  std::vector<std::string> gltf_files() {
    const std::string knots = folder_ / "knots.glb";
    write_gltf_scene(knots, {knot(100, 12), sphere(3)},
                     {{{"mesh", 0}, {"translation", {9, 0, 0}}},
                      {{"mesh", 0}, {"scale", {0.2, 0.2, 3}}, {"translation", {0, 9, 0}}},
                      {{"mesh", 1}, {"scale", {100, 100, 100}}}},
                     {0, 1, 2});
    write_gltf_cube(folder_ / "cube.glb", 8);
    write_gltf_sheet(folder_ / "sheet.glb", {.height = 1}, 12);
    return {knots, folder_ / "cube.glb", folder_ / "sheet.glb"};
  }

  TemporaryFolder folder_;
};

TEST_F(ProvenLevels, CountWhatCompressionRounds) {
  for (const std::string& in : gltf_files()) {
    for (const std::string output : {"{i}.glb", "{i}.gltf"}) {
      expect_within(in, output, {"--errors", "0.01%,0.1%,2%", "--compress"});
    }
  }
  io::write_mesh(folder_ / "torus.ply", torus(60, 30));
  expect_within(folder_ / "torus.ply", "{i}.glb", {"--errors", "0.02%,1%", "--compress"});
  // Rounding takes what is this near before it over the error.
  expect_within(data_file("blob.obj"), "{i}.glb", {"--errors", "0.02%,0.0555%", "--compress"});
}

TEST_F(ProvenLevels, HoldAtTheDistanceOfACamera) {
  std::vector<std::string> files = gltf_files();
  for (const std::string name : {"terrain.ply", "blob.obj", "bracket.stl"}) files.push_back(data_file(name));
  for (const std::string& in : files) {
    const std::string output = in.substr(in.rfind('.')) == ".glb" ? "{i}.glb" : "{faces}_{i}.ply";
    const Json report = expect_within(
        in, output, {"--distances", "1000%,100%", "--target-pixels", "3", "--view-height", "720", "--fov", "40"});
    ASSERT_EQ(report["levels"].size(), 2U);
    const double diagonal = report["input"]["diagonal"];
    double expected = diagonal;
    for (const Json& level : report["levels"]) {
      const double distance = level["distance"];
      EXPECT_NEAR(distance, expected, 1e-12 * expected);
      expected *= 10;
      const double pixels =
          level["max_error"].get<double>() * 720 / (2 * distance * std::tan(20 * std::numbers::pi / 180));
      EXPECT_NEAR(pixels, 3, 1e-9);
    }
  }
}

TEST_F(ProvenLevels, AreThoseOfTheErrorThatIsAPixel) {
  const std::string in = data_file("terrain.ply");
  const Json seen = expect_within(in, "seen_{i}.ply", {"--distances", "5,20", "--threads", "1"});
  std::string errors;
  for (const Json& level : seen["levels"]) errors += (errors.empty() ? "" : ",") + level["max_error"].dump();
  const Json near = expect_within(in, "near_{i}.ply", {"--errors", errors});
  for (const std::string number : {"0", "1"}) {
    EXPECT_EQ(read_text(folder_ / ("seen_" + number + ".ply")), read_text(folder_ / ("near_" + number + ".ply")));
  }
  EXPECT_EQ(near["levels"][0]["distance"], nullptr);
}

TEST_F(ProvenLevels, SayWhatTheyAreAndWhatCantBe) {
  const std::string in = data_file("terrain.ply");
  const std::string out = folder_ / "{i}.ply";
  const Outcome run = whittle({"lod", in, "-o", out, "--distances", "10", "--target-pixels", "1.5"});
  EXPECT_THAT(run.err, testing::HasSubstr("which is 1.5 pixels at 10 ("));
  const auto lod = [&](const Arguments& more) { return whittle(with_more({"lod", in}, more)); };
  expect_usage_error(lod({"-o", out, "--distances", "0"}), {"--distances", "above 0"});
  expect_usage_error(lod({"-o", out, "--distances", "1", "--faces", "9"}), {"--distances", "only one"});
  expect_usage_error(lod({"-o", out, "--distances", "1", "--fov", "180"}), {"--fov"});
  expect_usage_error(lod({"-o", out, "--distances", "1", "--target-pixels", "0"}), {"--target-pixels"});
  expect_usage_error(lod({"-o", out, "--faces", "9", "--target-pixels", "2"}), {"--target-pixels", "--distances"});
  expect_usage_error(lod({"-o", folder_ / "a.glb", "--faces", "9", "--fov", "50"}), {"--fov", "--distances"});
  expect_usage_error(lod({"-o", out, "--errors", "1%", "--compress"}), {"--compress", "glTF"});
  EXPECT_EQ(lod({"-o", folder_ / "n.stl", "--distances", "1e-12"}).exit_code, 2);
  const Outcome near = lod({"-o", folder_ / "n{i}.stl", "--distances", "1e-12"});
  EXPECT_EQ(near.exit_code, 1) << near;
  EXPECT_THAT(near.err, testing::HasSubstr("not even all faces of the input"));
}

}  // namespace
}  // namespace whittle::test
