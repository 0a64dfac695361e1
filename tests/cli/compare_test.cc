#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program/program.hh"

namespace whittle::test {
namespace {

nlohmann::json compared(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"compare", "--json", "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = whittle(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  return parse_json(outcome.out);
}

TEST(Compare, BringsBothToTheSameTarget) {
  for (const std::vector<std::string>& target :
       std::vector<std::vector<std::string>>{{"--faces", "512"}, {"--vertices", "258"}, {"--ratio", "0.1008"}}) {
    std::vector<std::string> arguments{data_file("blob.obj")};
    arguments.insert(arguments.end(), target.begin(), target.end());
    const auto json = compared(arguments);
    EXPECT_EQ(json["whittle"]["faces"], 512) << target[0];
    EXPECT_EQ(json["openmesh"]["faces"], 512) << target[0];
    EXPECT_EQ(json["whittle"]["vertices"], 258) << target[0];
    EXPECT_EQ(json["openmesh"]["vertices"], 258) << target[0];
  }
  const auto limited = compared({data_file("blob.obj"), "--max-cost", "1e-6"});
  EXPECT_LT(limited["whittle"]["faces"], 5120);
  EXPECT_LT(limited["openmesh"]["faces"], 5120);
  EXPECT_EQ(limited["target"], (nlohmann::json{{"max_cost", 1e-6}}));
}

TEST(Compare, IsCloserToTheInputThanModQuadric) {
  const auto json = compared({data_file("knot.ply"), "--ratio", "10%", "--effort", "fast"});
  const auto& ours = json["whittle"];
  const auto& stock = json["openmesh"];
  EXPECT_LT(ours["mean"].get<double>(), 0.8 * stock["mean"].get<double>());
  EXPECT_LT(ours["garland_heckbert"].get<double>(), 0.6 * stock["garland_heckbert"].get<double>());
}

TEST(Compare, IsWhatSimplifyDoesWithTheSameEffort) {
  const std::string blob = data_file("blob.obj");
  const TemporaryFolder folder;
  for (const std::string effort : {"", "fast", "normal", "best"}) {
    SCOPED_TRACE("--effort " + effort);
    std::vector<std::string> given;
    if (!effort.empty()) given = {"--effort", effort};
    std::vector<std::string> compare{blob, "--faces", "512"};
    compare.insert(compare.end(), given.begin(), given.end());
    const auto side_by_side = compared(compare);
    std::vector<std::string> simplify{"simplify", blob, "-o", folder / "out.ply", "--faces", "512", "--json", "-"};
    simplify.insert(simplify.end(), given.begin(), given.end());
    const auto simplified = parse_json(whittle(simplify).out);
    const auto measured = parse_json(whittle({"measure", blob, folder / "out.ply", "--json", "-"}).out);
    for (const char* key : {"effort", "cost", "polish"}) {
      EXPECT_EQ(side_by_side["options"][key], simplified["options"][key]) << key;
    }
    // The file has coordinates of single precision.
    EXPECT_NEAR(side_by_side["whittle"]["mean"].get<double>(), measured["mean"].get<double>(),
                1e-5 * measured["mean"].get<double>());
  }
}

TEST(Compare, SaysWhatRan) {
  const auto said = [](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"compare", data_file("blob.obj"), "--samples", "1000"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return whittle(arguments).out;
  };
  const std::string normal = said({"--faces", "512"});
  EXPECT_NE(normal.find("\nwhittle: --effort normal (--cost memoryless --polish 1); OpenMesh: ModQuadric"),
            std::string::npos)
      << normal;
  EXPECT_NE(normal.find("\nwhittle --effort normal: "), std::string::npos) << normal;
  EXPECT_NE(normal.find("time to polish"), std::string::npos) << normal;
  const std::string fast = said({"--faces", "512", "--effort", "fast"});
  EXPECT_NE(fast.find("--effort fast (--cost quadric --polish 0)"), std::string::npos) << fast;
  EXPECT_EQ(fast.find("time to polish"), std::string::npos) << fast;
  const std::string best = said({"--faces", "512", "--effort", "best"});
  EXPECT_NE(best.find("--effort best (--cost memoryless --polish 2, edges flipped)"), std::string::npos) << best;
}

TEST(Compare, HasPlainQuadricsWithACostLimit) {
  const auto json = compared({data_file("blob.obj"), "--max-cost", "1e-6"});
  EXPECT_EQ(json["options"]["effort"], "fast");
  EXPECT_EQ(json["options"]["cost"], "quadric");
}

TEST(Compare, ReportsBothSides) {
  const auto json = compared({data_file("blob.obj"), "--faces", "512"});
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["input"]["faces"], 5120);
  for (const char* side : {"whittle", "openmesh"}) {
    for (const char* key : {"name", "vertices", "faces", "seconds", "mean", "mean_rel", "rms", "rms_rel", "max",
                            "max_rel", "garland_heckbert", "flipped_percent"}) {
      EXPECT_TRUE(json[side].contains(key)) << side << ' ' << key;
    }
    EXPECT_GT(json[side]["seconds"]["decimate"].get<double>(), 0) << side;
  }
  EXPECT_GT(json["whittle"]["seconds"]["polish"].get<double>(), 0);
  EXPECT_GT(json["openmesh"]["seconds"]["build"].get<double>(), 0);
  EXPECT_EQ(json["openmesh"]["lost_faces"], 0);
}

TEST(Compare, PrintsATable) {
  const Outcome outcome = whittle({"compare", data_file("blob.obj"), "--faces", "512"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.err, "") << outcome;
  for (const char* said : {"5120 faces, 2562 vertices; target: 512 faces", "whittle  ", "OpenMesh", "faces", "vertices",
                           "time to decimate", "time to build its mesh", "mean error", "rms error", "largest error",
                           "Garland-Heckbert 1997", "faces turned over", "times as fast"}) {
    EXPECT_NE(outcome.out.find(said), std::string::npos) << "not said: " << said << '\n' << outcome;
  }
}

TEST(Compare, SaysThatATargetIsMissed) {
  const Outcome outcome = whittle({"compare", data_file("bracket.stl"), "--faces", "4", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  const auto json = parse_json(outcome.out);
  for (const auto& [side, name] : {std::pair("whittle", "whittle"), {"openmesh", "OpenMesh"}}) {
    EXPECT_EQ(json[side]["met"], false) << side;
    const std::string said = std::string(name) + " did not meet the target: 4 faces asked, " +
                             std::to_string(json[side]["faces"].get<std::size_t>()) + " faces and ";
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome;
  }
  EXPECT_EQ(compared({data_file("cubes.obj"), "--faces", "150"})["whittle"]["met"], true);
}

TEST(Compare, CountsTheFacesOpenMeshCannotHold) {
  const Outcome outcome = whittle({"compare", data_file("nonmanifold.obj"), "--ratio", "0.5", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  const auto lost = parse_json(outcome.out)["openmesh"]["lost_faces"].get<std::size_t>();
  EXPECT_GT(lost, 0U);
  EXPECT_NE(outcome.err.find("OpenMesh's mesh can't hold " + std::to_string(lost) + " of the 875 faces"),
            std::string::npos)
      << outcome;
  EXPECT_EQ(outcome.err.find("complex"), std::string::npos) << "OpenMesh's own messages are kept away\n" << outcome;
}

}  // namespace
}  // namespace whittle::test
