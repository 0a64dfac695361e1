#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"
#include "support/temporary_folder.hh"
#include "whittle/io/read.hh"
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
    EXPECT_EQ(metrics::certify(input, written, level["max_error"]).verdict, metrics::Verdict::proven);
    EXPECT_LT(written.faces.size(), input.faces.size() / 2);
  }
}

TEST(Lod, SaysThatAFileCantHoldALevelSoNear) {
  const TemporaryFolder folder;
  const Outcome outcome = whittle({"lod", data_file("terrain.ply"), "--errors", "1e-12", "-o", folder / "{i}.stl"});
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, testing::HasSubstr("1e-12"));
  EXPECT_FALSE(std::filesystem::exists(folder / "0.stl"));
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
