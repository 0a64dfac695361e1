// What is proven of glTF files.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "program/gltf_scene.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;

/// The largest distance that is found between two scenes as they are shown.
double measured_distance(const std::string& input, const std::string& output) {
  const Outcome measured = whittle({"measure", input, output, "--samples", "1000", "--exact", "1e-3", "--json", "-"});
  EXPECT_EQ(measured.exit_code, 0) << measured;
  const Json exact = parse_json(measured.out)["exact"];
  return std::max(exact["forward"]["at_least"].get<double>(), exact["backward"]["at_least"].get<double>());
}

TEST(GltfError, IsLimitedWhereAMeshIsDrawnOut) {
  const TemporaryFolder folder;
  const std::string in = folder / "in.glb";
  const std::string out = folder / "out.glb";
  write_gltf_scene(in, {knot(100, 12)},
                   {{{"mesh", 0}}, {{"mesh", 0}, {"scale", {0.1, 0.1, 4}}, {"translation", {9, 0, 0}}}}, {0, 1});
  const Outcome run = whittle({"simplify", in, "-o", out, "--max-error", "0.05", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const double found = measured_distance(in, out);
  EXPECT_LE(found, 0.05);
  EXPECT_LE(found, parse_json(run.out)["max_error"]["proven"]);
  const Outcome certified = whittle({"simplify", in, "-o", out, "--faces", "500", "--certify", "--json", "-"});
  ASSERT_EQ(certified.exit_code, 0) << certified;
  EXPECT_LE(measured_distance(in, out), parse_json(certified.out)["max_error"]["proven"]);
  const std::string level = folder / "level_{i}.glb";
  const Outcome levels = whittle({"lod", in, "-o", level, "--errors", "0.05"});
  ASSERT_EQ(levels.exit_code, 0) << levels;
  EXPECT_LE(measured_distance(in, folder / "level_0.glb"), 0.05);
}

}  // namespace
}  // namespace whittle::test
