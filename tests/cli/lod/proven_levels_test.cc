// Levels by error: proven as they are written.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
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

TEST_F(ProvenLevels, RefuseCompressionOfOtherFormats) {
  expect_usage_error(
      whittle({"lod", data_file("terrain.ply"), "-o", folder_ / "{i}.ply", "--errors", "1%", "--compress"}),
      {"--compress", "glTF"});
}

}  // namespace
}  // namespace whittle::test
