#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

nlohmann::json measured(const std::string& reference, const std::string& test, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"measure", reference, test, "--json", "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = whittle(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  return parse_json(outcome.out);
}

TEST(Measure, NamesNoShareOfADiagonalOfZero) {
  const TemporaryFolder folder;
  write_text(folder / "point.obj", "v 0 0 0\nv 1e-200 0 0\nv 0 1e-200 0\nf 1 2 3\n");
  const Outcome outcome = whittle({"measure", folder / "point.obj", data_file("cubes.obj")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_NE(outcome.out.find("\nlargest distance"), std::string::npos) << outcome;
  EXPECT_EQ(outcome.out.find("inf %"), std::string::npos) << outcome;
  EXPECT_EQ(outcome.out.find("nan %"), std::string::npos) << outcome;
}

TEST(Measure, HasEveryKeyOfItsSchema) {
  const auto json = measured(data_file("blob.obj"), data_file("blob.obj"), {"--samples", "1000"});
  for (const char* key : {"schema",
                          "program",
                          "reference",
                          "test",
                          "diagonal",
                          "mean",
                          "mean_rel",
                          "rms",
                          "rms_rel",
                          "max",
                          "max_rel",
                          "garland_heckbert",
                          "garland_heckbert_rel",
                          "forward",
                          "backward",
                          "normal_deviation_deg",
                          "flipped_percent",
                          "exact",
                          "border",
                          "features",
                          "radius_ratio",
                          "min_angle_deg",
                          "valence",
                          "edge_length_cv",
                          "folds",
                          "self_intersections",
                          "degenerate_faces",
                          "manifold",
                          "closed",
                          "components"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  for (const char* way : {"forward", "backward"}) {
    for (const char* key :
         {"mean", "mean_rel", "rms", "rms_rel", "max", "max_rel", "normal_deviation_deg", "flipped_percent"}) {
      EXPECT_TRUE(json[way].contains(key)) << way << ' ' << key;
    }
  }
  for (const char* key : {"mean", "min"}) {
    EXPECT_TRUE(json["radius_ratio"].contains(key)) << key;
    EXPECT_TRUE(json["min_angle_deg"].contains(key)) << key;
  }
  for (const char* key : {"min", "share_5_to_7", "histogram"}) EXPECT_TRUE(json["valence"].contains(key)) << key;
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["closed"], true);
  EXPECT_EQ(json["components"], 1);
}

TEST(Measure, FindsNothingBetweenAMeshAndItself) {
  const auto json = measured(data_file("blob.obj"), data_file("blob.obj"));
  for (const char* key : {"mean", "rms", "max", "garland_heckbert", "normal_deviation_deg", "flipped_percent"}) {
    EXPECT_EQ(json[key], 0.0) << key;
  }
}

TEST(Measure, GivesTheDistanceOfParallelPlanes) {
  const TemporaryFolder folder;
  io::write_mesh(folder / "moved.off", moved(grid(24, 24), Vec3(0, 0, 0.5)));
  const auto json = measured(data_file("flat.off"), folder / "moved.off");
  const double diagonal = std::hypot(24.0, 24.0);
  EXPECT_DOUBLE_EQ(json["diagonal"].get<double>(), diagonal);
  for (const char* key : {"mean", "rms", "max"}) {
    EXPECT_NEAR(json[key].get<double>(), 0.5, 1e-12) << key;
    EXPECT_NEAR(json["forward"][key].get<double>(), 0.5, 1e-12) << key;
    EXPECT_NEAR(json[std::string(key) + "_rel"].get<double>(), 0.5 / diagonal, 1e-12) << key;
  }
  EXPECT_NEAR(json["garland_heckbert"].get<double>(), 0.25, 1e-12);
  EXPECT_NEAR(json["garland_heckbert_rel"].get<double>(), 0.25 / diagonal / diagonal, 1e-12);
}

TEST(Measure, PrintsATableAndWritesTheReportBesideIt) {
  const TemporaryFolder folder;
  const Outcome outcome =
      whittle({"measure", data_file("blob.obj"), data_file("blob.obj"), "--json", folder / "report.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.err, "") << outcome;
  for (const char* said : {"REF: ", "TEST: ", "mean distance", "rms distance", "largest distance", "Garland-Heckbert",
                           "radius ratio", "valence", "self-intersections", "manifold"}) {
    EXPECT_NE(outcome.out.find(said), std::string::npos) << "not said: " << said << '\n' << outcome;
  }
  EXPECT_EQ(parse_json(read_text(folder / "report.json")), measured(data_file("blob.obj"), data_file("blob.obj")));
}

TEST(Measure, GivesTheSameNumbersForTheSameSeedAndAnyThreads) {
  const TemporaryFolder folder;
  const std::string small = folder / "small.ply";
  ASSERT_EQ(whittle({"simplify", data_file("knot.ply"), "-o", small, "-r", "10%"}).exit_code, 0);
  const auto first = measured(data_file("knot.ply"), small, {"--samples", "20000", "--threads", "1"});
  EXPECT_EQ(measured(data_file("knot.ply"), small, {"--samples", "20000", "--threads", "3"}), first);
  const auto other = measured(data_file("knot.ply"), small, {"--samples", "20000", "--seed", "2"});
  EXPECT_NE(other["mean"], first["mean"]);
  EXPECT_NEAR(other["mean"].get<double>(), first["mean"].get<double>(), 0.05 * first["mean"].get<double>());
}

TEST(Measure, ReadsOneMeshFromStandardInput) {
  RunOptions options;
  options.input = read_text(data_file("cubes.obj"));
  const Outcome outcome = whittle({"measure", data_file("cubes.obj"), "-", "--format", "obj", "--json", "-"}, options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(parse_json(outcome.out)["max"], 0.0);
}

TEST(Measure, WeldsUnlessToldNotTo) {
  EXPECT_EQ(measured(data_file("bracket.stl"), data_file("bracket.stl"))["components"], 1);
  EXPECT_EQ(measured(data_file("bracket.stl"), data_file("bracket.stl"), {"--no-weld"})["components"], 1476);
}

IndexedMesh box_of(double side, int n) { return scaled(tessellated_cube(n), 0.5 * side); }

void expect_lines(const nlohmann::json& lines, double expected, double diagonal) {
  for (const nlohmann::json& direction : {lines, lines["forward"], lines["backward"]}) {
    for (const std::string key : {"mean", "max"}) {
      EXPECT_NEAR(direction[key].get<double>(), expected, 1e-12) << key << '\n' << lines;
      EXPECT_NEAR(direction[key + "_rel"].get<double>(), expected / diagonal, 1e-12) << key << '\n' << lines;
    }
  }
}

TEST(Measure, TellsHowFarBordersAreApart) {
  const TemporaryFolder folder;
  io::write_mesh(folder / "grid.off", grid(6, 4));
  io::write_mesh(folder / "moved.off", moved(grid(6, 4), Vec3(0.0, 0.0, 0.5)));
  const auto json = measured(folder / "grid.off", folder / "moved.off");
  expect_lines(json["border"], 0.5, std::hypot(6.0, 4.0));
  EXPECT_TRUE(json["features"].is_null());
  const Outcome outcome = whittle({"measure", folder / "grid.off", folder / "moved.off"});
  for (const char* said : {"borders, mean", "borders, largest"}) {
    EXPECT_NE(outcome.out.find(said), std::string::npos) << "not said: " << said << '\n' << outcome;
  }
  EXPECT_EQ(outcome.out.find("feature"), std::string::npos) << outcome;
}

TEST(Measure, FindsTheLargestDistanceOfAllPoints) {
  const TemporaryFolder folder;
  const std::string box = folder / "box.off", larger = folder / "larger.off";
  io::write_mesh(box, box_of(2.0, 3));
  io::write_mesh(larger, box_of(2.2, 2));
  EXPECT_TRUE(measured(box, larger)["exact"].is_null());
  const nlohmann::json exact = measured(box, larger, {"--exact", "1e-4"})["exact"];
  EXPECT_EQ(exact["accuracy"], 1e-4);
  EXPECT_NEAR(exact["forward"]["at_least"].get<double>(), 0.1, 1e-5);
  EXPECT_NEAR(exact["forward"]["at_most"].get<double>(), 0.1, 2e-5);
  EXPECT_NEAR(exact["backward"]["at_least"].get<double>(), 0.1 * std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(exact["backward"]["at_most_rel"].get<double>(), 0.05, 1e-5);
  for (const double x : exact["backward"]["point"]) EXPECT_NEAR(std::abs(x), 1.1, 1e-9) << "a corner of the larger box";
  EXPECT_LT(exact["backward"]["face"], 48);
  const Outcome outcome = whittle({"measure", box, larger, "--exact", "1e-4"});
  for (const char* said : {"of all points, at least", "of all points, at most", "farthest: ", " of TEST"}) {
    EXPECT_NE(outcome.out.find(said), std::string::npos) << "not said: " << said << '\n' << outcome;
  }
  for (const char* accuracy : {"0", "1e-7", "2", "x"}) {
    EXPECT_EQ(whittle({"measure", box, larger, "--exact", accuracy}).exit_code, 2) << accuracy;
  }
}

TEST(Measure, TellsHowFarFeatureLinesAreApart) {
  const TemporaryFolder folder;
  const std::string box = folder / "box.off", larger = folder / "larger.off";
  io::write_mesh(box, box_of(2.0, 3));
  io::write_mesh(larger, box_of(2.2, 2));
  const auto json = measured(box, larger, {"--feature-angle", "40"});
  const nlohmann::json features = json["features"];
  EXPECT_EQ(features["angle_deg"], 40.0);
  // The distance is 0.1 at edges in two directions, at corners in three.
  EXPECT_NEAR(features["forward"]["mean"].get<double>(), 0.1 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(features["forward"]["max"].get<double>(), 0.1 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(features["backward"]["max"].get<double>(), 0.1 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(features["max"].get<double>(), 0.1 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(features["max_rel"].get<double>(), 0.05, 1e-12);
  EXPECT_TRUE(json["border"].is_null());
  EXPECT_TRUE(measured(box, larger, {"--feature-angle", "91"})["features"].is_null());

  const Outcome outcome = whittle({"measure", box, larger, "--feature-angle", "40"});
  for (const char* said : {"feature lines, mean", "feature lines, largest"}) {
    EXPECT_NE(outcome.out.find(said), std::string::npos) << "not said: " << said << '\n' << outcome;
  }
  EXPECT_EQ(outcome.out.find("borders"), std::string::npos) << outcome;
}

TEST(Measure, SaysWhichMeshHasNoLines) {
  const TemporaryFolder folder;
  const std::string box = folder / "box.off", flat = folder / "flat.off";
  io::write_mesh(box, box_of(2.0, 1));
  io::write_mesh(flat, grid(3, 3));
  const auto json = measured(box, flat, {"--feature-angle", "40"});
  EXPECT_TRUE(json["border"].is_null());
  EXPECT_TRUE(json["features"].is_null());
  const auto expect_said = [](const Outcome& outcome, const std::string& line) {
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_NE(outcome.out.find(line + '\n'), std::string::npos) << "not said: " << line << '\n' << outcome;
  };
  const Outcome outcome = whittle({"measure", box, flat, "--feature-angle", "40"});
  expect_said(outcome, "no distance between borders: REF has none");
  expect_said(outcome, "no distance between feature lines: TEST has none");
  expect_said(whittle({"measure", flat, flat, "--feature-angle", "40"}),
              "no distance between feature lines: neither mesh has any");
}

}  // namespace
}  // namespace whittle::test
