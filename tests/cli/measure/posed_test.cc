// `measure --posed`: the scenes of two glTF files in poses.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_sheet.hh"
#include "program/program.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;

class Posed : public ::testing::Test {
 protected:
  std::string sheet(const std::string& name, const GltfSheet& sheet) const {
    write_gltf_sheet(folder_ / name, sheet);
    return folder_ / name;
  }

  static Json measured(const std::string& reference, const std::string& test, const std::string& n_poses) {
    const Outcome outcome =
        whittle({"measure", reference, test, "--samples", "2000", "--posed", n_poses, "--json", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    return parse_json(outcome.out)["posed"];
  }

  const TemporaryFolder folder_;
};

TEST_F(Posed, FindsNothingBetweenAnAssetAndItself) {
  for (const bool is_animated : {true, false}) {
    const std::string file = sheet("a.glb", {.height = 1, .has_target = true, .is_animated = is_animated});
    const Json posed = measured(file, file, "5");
    EXPECT_EQ(posed["poses"], 5);
    EXPECT_EQ(posed["animated"], is_animated);
    for (const char* which : {"rest", "average", "worst"}) EXPECT_EQ(posed[which]["mean"], 0.0) << which;
    EXPECT_TRUE(posed["ratio"].is_null());
    EXPECT_EQ(posed["worst"]["pose"], 1);
  }
}

TEST_F(Posed, TakesPosesFromAnimations) {
  const std::string low = sheet("low.glb", {}), high = sheet("high.glb", {.height = 0.5});
  const Json posed = measured(low, high, "2");
  EXPECT_EQ(posed["animated"], true);
  EXPECT_NEAR(posed["diagonal"].get<double>(), 4 * std::sqrt(2.0), 1e-12);
  // The joint is one and a half times, and two and a half times as large.
  EXPECT_NEAR(posed["rest"]["mean"].get<double>(), 0.5, 1e-9);
  EXPECT_NEAR(posed["average"]["mean"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(posed["average"]["forward"]["mean"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(posed["worst"]["backward"]["mean"].get<double>(), 1.25, 1e-9);
  EXPECT_NEAR(posed["worst"]["mean_rel"].get<double>(), 1.25 / (4 * std::sqrt(2.0)), 1e-9);
  EXPECT_NEAR(posed["ratio"].get<double>(), 2, 1e-9);
  EXPECT_EQ(posed["worst"]["pose"], 2);
  EXPECT_EQ(posed["worst"]["animation"], "grow");
  EXPECT_EQ(posed["worst"]["seconds"], 0.75);
}

TEST_F(Posed, MakesUpPosesWithoutAnimations) {
  const GltfSheet low{.has_target = true, .is_animated = false};
  GltfSheet high = low;
  high.height = 0.5;
  const Json posed = measured(sheet("low.glb", low), sheet("high.glb", high), "16");
  EXPECT_EQ(posed["animated"], false);
  EXPECT_NEAR(posed["ratio"].get<double>(), 1.5, 0.1) << "the target is blended from 0 to 1; turning changes nothing";
  EXPECT_TRUE(posed["worst"]["animation"].is_null());
  EXPECT_LE(posed["worst"]["mean"].get<double>(), 1);
}

TEST_F(Posed, PrintsATable) {
  const Outcome outcome =
      whittle({"measure", sheet("low.glb", {}), sheet("high.gltf", {.height = 0.5}), "--posed", "2"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  for (const char* said : {"scene, mean distance", "at rest", "mean of 2 poses", "worst pose", "poses / rest",
                           "REF's scene at rest, which is 5.657\n", "worst pose: 2 of 2, grow at 0.75 s\n"}) {
    EXPECT_NE(outcome.out.find(said), std::string::npos) << "not said: " << said << '\n' << outcome;
  }
}

TEST_F(Posed, MeasuresWhatSimplifyWrites) {
  const std::string file = folder_ / "fine.glb", small = folder_ / "small.glb";
  write_gltf_sheet(file, {.height = 1}, 12);
  ASSERT_EQ(whittle({"simplify", file, "-o", small, "--faces", "20"}).exit_code, 0);
  const Json posed = measured(file, small, "3");
  EXPECT_LT(posed["worst"]["mean_rel"].get<double>(), 1e-6) << "a flat sheet stays one";
}

TEST_F(Posed, GivesTheSameNumbersForAnyThreads) {
  const GltfSheet bent{.has_target = true, .is_animated = false};
  GltfSheet high = bent;
  high.height = 0.25;
  const std::string a = sheet("a.glb", bent), b = sheet("b.glb", high);
  const auto report = [&](const char* threads) {
    return whittle({"measure", a, b, "--samples", "5000", "--posed", "3", "--threads", threads, "--json", "-"}).out;
  };
  EXPECT_EQ(report("1"), report("3"));
}

TEST_F(Posed, RefusesWhatItCantPose) {
  const std::string bent = sheet("bent.glb", {});
  const std::string stiff = sheet("stiff.glb", {.has_skin = false});
  const std::string obj = data_file("cubes.obj");
  for (const char* n : {"0", "10001", "x", "1.5"}) {
    EXPECT_EQ(whittle({"measure", bent, bent, "--posed", n}).exit_code, 2) << n;
  }
  expect_usage_error(whittle({"measure", bent, obj, "--posed", "2"}), {"--posed is for glTF files", "cubes.obj"});
  expect_usage_error(whittle({"measure", obj, bent, "--posed", "2"}), {"--posed is for glTF files", "cubes.obj"});
  expect_failure(whittle({"measure", bent, stiff, "--posed", "2"}), 4,
                 {"stiff.glb: it has neither a skin nor a morph target"});
  expect_failure(whittle({"measure", stiff, bent, "--posed", "2"}), 4,
                 {"stiff.glb: it has neither a skin nor a morph target"});
  expect_failure(whittle({"measure", bent, sheet("still.glb", {.is_animated = false}), "--posed", "2"}), 4,
                 {"still.glb: --posed needs the animations of REF, which has 1; here are 0"});
}

}  // namespace
}  // namespace whittle::test
