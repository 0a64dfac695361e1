// The subcommand `polish`.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program/program.hh"
#include "whittle/io/read.hh"
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

TEST_F(PolishCommand, WritesNothingWhereSomethingIsWrong) {
  EXPECT_EQ(whittle({"polish", knot_, small_}).exit_code, 2);
  EXPECT_EQ(whittle({"polish", knot_, small_, "-o", small_}).exit_code, 2) << "without --force";
  EXPECT_EQ(whittle({"polish", knot_, folder_ / "missing.ply", "-o", better_}).exit_code, 4);
  EXPECT_EQ(whittle({"polish", knot_, small_, "-o", better_, "--passes", "-1"}).exit_code, 2);
  EXPECT_EQ(folder_.files(), std::vector<std::string>{"small.ply"});
}

}  // namespace
}  // namespace whittle::test
