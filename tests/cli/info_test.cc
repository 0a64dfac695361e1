#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "support/shapes/two_sided.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

nlohmann::json info(const std::string& mesh) {
  const Outcome outcome = whittle({"info", mesh, "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  return parse_json(outcome.out);
}

TEST(Info, CountsWhatIsInEveryMeshOfData) {
  struct Expected {
    const char* name;
    std::size_t faces;
    bool closed;
    bool manifold;
    std::size_t components;
    nlohmann::json genus;
  };
  const std::vector<Expected> cases{
      {"knot.ply", 51200, true, true, 1, 1},          {"blob.obj", 5120, true, true, 1, 0},
      {"terrain.ply", 4608, false, true, 1, nullptr}, {"cylinder.off", 2304, false, true, 1, nullptr},
      {"bracket.stl", 1476, true, true, 1, 1},        {"cubes.obj", 300, true, true, 25, 0},
      {"flat.off", 1152, false, true, 1, nullptr},    {"nonmanifold.obj", 875, false, false, 3, nullptr}};
  for (const Expected& expected : cases) {
    SCOPED_TRACE(expected.name);
    const auto json = info(data_file(expected.name));
    EXPECT_EQ(json["faces"], expected.faces);
    EXPECT_EQ(json["closed"], expected.closed);
    EXPECT_EQ(json["manifold"], expected.manifold);
    EXPECT_EQ(json["components"], expected.components);
    EXPECT_EQ(json["genus"], expected.genus);
    EXPECT_EQ(json["format"], std::string(expected.name).substr(std::string(expected.name).size() - 3));
  }
}

TEST(Info, SaysWhatSuitsTheKindOfMesh) {
  using Words = std::vector<std::string>;
  struct Expected {
    const char* name;
    Words kind;
    Words options;
  };
  const std::vector<Expected> cases{
      {"knot.ply", {"closed"}, {}},
      {"blob.obj", {"closed"}, {}},
      {"terrain.ply", {"open", "tile"}, {"--boundary locked"}},
      {"flat.off", {"open", "CAD", "tile"}, {"--boundary locked"}},  // with no sharp edge to keep
      {"bracket.stl", {"closed", "CAD"}, {"--feature-angle 40"}},
      {"cubes.obj", {"closed", "parts"}, {"--threshold auto", "--self-intersections refuse"}}};
  for (const Expected& expected : cases) {
    SCOPED_TRACE(expected.name);
    const auto json = info(data_file(expected.name));
    EXPECT_EQ(json["kind"], expected.kind);
    Words options;
    for (const auto& suggestion : json["suggestions"]) options.push_back(suggestion["option"]);
    EXPECT_EQ(options, expected.options);
    const Outcome text = whittle({"info", data_file(expected.name)});
    for (const std::string& option : expected.options) {
      EXPECT_NE(text.out.find("  " + option + ": "), std::string::npos) << text;
    }
  }
}

/// Its edges have four faces, but that hinders nothing.
TEST(Info, SaysOfATwoSidedSheetWhatSuitsASide) {
  const TemporaryFolder folder;
  io::write_mesh(folder / "sheet.ply", with_backs(noisy_grid(8, 8, 0.2, 1)));
  const auto json = info(folder / "sheet.ply");
  EXPECT_EQ(json["kind"], (std::vector<std::string>{"open", "tile", "two-sided"}));
  ASSERT_EQ(json["suggestions"].size(), 1U);
  EXPECT_EQ(json["suggestions"][0]["option"], "--boundary locked");
}

TEST(Info, ShowsTheFileBesideWhatBecomesOfIt) {
  const auto json = info(data_file("bracket.stl"));
  EXPECT_EQ(json["file"], (nlohmann::json{{"vertices", 4428}, {"faces", 1476}}));
  EXPECT_EQ(json["vertices"], 738);
  EXPECT_EQ(json["repairs"]["welded_vertices"], 3690);
  EXPECT_EQ(json["unwelded"]["components"], 1476);
  EXPECT_EQ(json["unwelded"]["closed"], false);
  EXPECT_EQ(json["closed"], true);
  EXPECT_EQ(info(data_file("blob.obj"))["unwelded"], nullptr);

  const Outcome text = whittle({"info", data_file("bracket.stl")});
  EXPECT_EQ(text.exit_code, 0) << text;
  EXPECT_EQ(text.err, "") << text;
  for (const char* said : {"STL, 4428 vertices, 1476 faces in the file", "welded 3690 vertices", "unwelded  welded",
                           "diagonal 3.614", "attributes: none"}) {
    EXPECT_NE(text.out.find(said), std::string::npos) << "not said: " << said << '\n' << text;
  }
}

TEST(Info, NamesDefectsAndAttributes) {
  const TemporaryFolder folder;
  // A quadrilateral, a triangle twice, one with two equal corners, one turned over, one vertex alone.
  write_text(folder / "in.obj",
             "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\nv 2 0 0 0 1 0\nv 5 5 5 0 1 0\n"
             "f 1 2 3 4\nf 2 5 3\nf 2 5 3\nf 2 2 3\n");
  const auto json = info(folder / "in.obj");
  EXPECT_EQ(json["file"], (nlohmann::json{{"vertices", 6}, {"faces", 4}}));
  EXPECT_EQ(json["repairs"], (nlohmann::json{{"welded_vertices", 0},
                                             {"triangulated_polygons", 1},
                                             {"degenerate_faces", 1},
                                             {"duplicate_faces", 1},
                                             {"isolated_vertices", 1}}));
  EXPECT_EQ(json["faces"], 3);
  EXPECT_EQ(json["attributes"], nlohmann::json{"vertex colours"});
  EXPECT_EQ(json["bounds"]["max"], (nlohmann::json{2.0, 1.0, 0.0})) << "vertices without a face don't count";
  EXPECT_EQ(json["boundary_loops"], 1);
  EXPECT_EQ(json["oriented"], true);
  const Outcome text = whittle({"info", folder / "in.obj"});
  EXPECT_NE(text.out.find("repairs: triangulated 1 polygon, dropped 1 degenerate face, 1 duplicate face, "
                          "1 isolated vertex"),
            std::string::npos)
      << text;
  EXPECT_NE(text.out.find("attributes: vertex colours"), std::string::npos) << text;
}

TEST(Info, FindsFacesTurnedTheOtherWay) {
  const TemporaryFolder folder;
  write_text(folder / "in.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n");
  const auto json = info(folder / "in.obj");
  EXPECT_EQ(json["misoriented_edges"], 1);
  EXPECT_EQ(json["oriented"], false);
  EXPECT_EQ(json["orientable"], true);
  EXPECT_NE(whittle({"info", folder / "in.obj"}).out.find("no, but can be"), std::string::npos);
}

TEST(Info, ReadsStandardInput) {
  RunOptions options;
  options.input = read_text(data_file("bracket.stl"));
  const Outcome outcome = whittle({"info", "-", "--format", "stl"}, options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.out.rfind("standard input: STL, 4428 vertices", 0), 0U) << outcome;
  EXPECT_NE(outcome.out.find("unwelded  welded"), std::string::npos) << "it is looked at twice but read once";
}

}  // namespace
}  // namespace whittle::test
