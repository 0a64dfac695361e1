// Several inputs in one call of `simplify`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "program/program.hh"
#include "whittle/io/read.hh"

namespace whittle::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

class SeveralInputs : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder_ / "out");
    fs::create_directory(folder_ / "in");
    for (const char* name : {"cubes.obj", "blob.obj", "bracket.stl"}) fs::copy_file(data_file(name), folder_ / name);
    options_.folder = folder_.path();
  }
  Outcome simplify(const Arguments& inputs, const Arguments& more = {"-o", "out/{stem}.ply", "--face-ratio", "60%"}) {
    Arguments arguments{"simplify"};
    arguments.insert(arguments.end(), inputs.begin(), inputs.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return whittle(arguments, options_);
  }
  std::vector<std::string> written() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "out")) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  void expect_refused(const Outcome& outcome, const std::string& said) const {
    EXPECT_EQ(outcome.exit_code, 2) << outcome;
    EXPECT_NE(outcome.err.find(said), std::string::npos) << "not said: " << said << '\n' << outcome;
    EXPECT_TRUE(written().empty()) << outcome;
  }

  TemporaryFolder folder_;
  RunOptions options_;
};

TEST_F(SeveralInputs, AreRunsOfTheirOwn) {
  const Outcome outcome = simplify({"cubes.obj", "blob.obj", "bracket.stl"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(written(), (Arguments{"blob.ply", "bracket.ply", "cubes.ply"}));
  for (const std::string name : {"cubes.obj", "blob.obj", "bracket.stl"}) {
    const std::string stem = name.substr(0, name.find('.'));
    ASSERT_EQ(simplify({name}, {"-o", "alone.ply", "--face-ratio", "60%"}).exit_code, 0);
    EXPECT_EQ(read_text(folder_ / ("out/" + stem + ".ply")), read_text(folder_ / "alone.ply")) << name;
  }
}

TEST_F(SeveralInputs, BecomeOneMesh) {
  const Arguments inputs{"cubes.obj", "blob.obj", "bracket.stl"};
  const Outcome outcome =
      simplify(inputs, {"--join", "-o", "all.obj", "--face-ratio", "60%", "--json", "-", "--map", "map"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  std::size_t n_faces = 0;
  std::size_t n_file_vertices = 0;
  for (const std::string& name : inputs) {
    const io::ReadResult one = io::read_mesh(folder_ / name);
    n_faces += one.mesh.faces.size();
    n_file_vertices += one.file_vertices;
  }
  const auto json = parse_json(outcome.out);
  EXPECT_EQ(json["input"]["faces"], n_faces);
  EXPECT_EQ(json["input"]["joined"], inputs);
  EXPECT_EQ(json["options"]["join"], true);
  EXPECT_EQ(json["output"]["components"], 25 + 1 + 1);
  const std::string written = read_text(folder_ / "all.obj");
  for (const char* stem : {"o cubes", "o blob\n", "o bracket\n"}) {
    EXPECT_NE(written.find(stem), std::string::npos) << stem;
  }
  const std::string map = read_text(folder_ / "map");
  EXPECT_EQ(static_cast<std::size_t>(std::count(map.begin(), map.end(), '\n')), n_file_vertices);
}

TEST_F(SeveralInputs, JoinedStayAsTheyAreWithoutATarget) {
  const Outcome outcome =
      simplify({"bracket.stl", "blob.obj"}, {"--join", "-o", "all.ply", "--face-ratio", "99.99%", "--polish", "0"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const IndexedMesh bracket = io::read_mesh(folder_ / "bracket.stl").mesh;
  const IndexedMesh blob = io::read_mesh(folder_ / "blob.obj").mesh;
  const IndexedMesh all = io::read_mesh(folder_ / "all.ply").mesh;
  ASSERT_GE(all.positions.size() + 2, bracket.positions.size() + blob.positions.size());
  EXPECT_EQ(all.positions.back(), blob.positions.back());
}

TEST_F(SeveralInputs, JoinedKeepWhatAllHave) {
  const auto triangle = [&](const char* name, const std::string& header, const std::string& faces) {
    write_text(folder_ / name, header + "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvt 0 0\nvt 1 0\nvt 0 1\n" + faces);
  };
  const std::string faces = "f 1/1 2/2 3/3\nf 2/2 4/1 3/3\n";
  triangle("a.obj", "mtllib a.mtl\n", "usemtl red\n" + faces);
  triangle("b.obj", "mtllib b.mtl\n", "usemtl blue\n" + faces);
  triangle("c.obj", "mtllib b.mtl\n", "usemtl red\n" + faces);
  const Arguments rest{"--join", "-o", "all.obj", "--faces", "4", "--json", "-"};
  const Outcome both = simplify({"a.obj", "b.obj"}, rest);
  ASSERT_EQ(both.exit_code, 0) << both;
  const io::ReadResult read = io::read_mesh(folder_ / "all.obj");
  EXPECT_EQ(read.mesh.group_names, (Arguments{"red", "blue"}));
  EXPECT_EQ(read.notes.material_libraries, (Arguments{"a.mtl", "b.mtl"}));
  EXPECT_EQ(read.mesh.attributes.size(), 1U);
  EXPECT_EQ(read.notes.face_names.at("o"), (Arguments{"a", "b"}));

  const Outcome mixed = simplify({"a.obj", "cubes.obj"}, rest);
  EXPECT_EQ(mixed.exit_code, 0) << mixed;
  EXPECT_NE(mixed.err.find("left out, as not all files have it: vt"), std::string::npos) << mixed;

  const Outcome conflict = simplify({"a.obj", "c.obj"}, rest);
  EXPECT_EQ(conflict.exit_code, 4) << conflict;
  EXPECT_NE(conflict.err.find("a material 'red' as a file before has, in another library"), std::string::npos)
      << conflict;
}

TEST_F(SeveralInputs, AreNotJoinedIntoSeveralOrOfGltf) {
  expect_refused(simplify({"cubes.obj", "blob.obj"}, {"--join", "-o", "out/{stem}.ply", "--faces", "9"}),
                 "--join makes one mesh of all IN");
  ASSERT_EQ(whittle({"convert", folder_ / "blob.obj", folder_ / "blob.glb"}).exit_code, 0);
  expect_refused(simplify({"cubes.obj", "blob.glb"}, {"--join", "-o", "out/a.ply", "--faces", "9"}),
                 "--join doesn't take glTF");
}

TEST_F(SeveralInputs, MayFollowTheOptions) {
  const Outcome outcome =
      whittle({"simplify", "-o", "out/{stem}.ply", "--faces", "150", "cubes.obj", "blob.obj"}, options_);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(written(), (Arguments{"blob.ply", "cubes.ply"}));
}

TEST_F(SeveralInputs, GoOnAfterAFailureAndEndWithTheFirst) {
  write_text(folder_ / "bad.obj", "v 0 0 0\nf 1 2 9\n");
  const Outcome outcome =
      simplify({"cubes.obj", "bad.obj", "blob.obj"},
               {"-o", "out/{stem}.ply", "--faces", "90", "--topology", "keep", "--strict", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 3) << "the cubes can't have so few\n" << outcome;
  EXPECT_EQ(written(), (Arguments{"blob.ply", "cubes.ply"}));
  EXPECT_NE(outcome.err.find("whittle: bad.obj:2: "), std::string::npos) << outcome;

  const auto json = parse_json(outcome.out);
  EXPECT_EQ(json["schema"], 1);
  ASSERT_EQ(json["runs"].size(), 3U);
  EXPECT_EQ(json["runs"][0]["exit_status"], 3);
  EXPECT_EQ(json["runs"][0]["target"]["met"], false);
  EXPECT_EQ(json["runs"][1]["exit_status"], 4);
  EXPECT_EQ(json["runs"][1]["input"]["path"], "bad.obj");
  EXPECT_NE(json["runs"][1]["error"].get<std::string>().find("bad.obj:2: "), std::string::npos);
  EXPECT_EQ(json["runs"][2]["exit_status"], 0);
  EXPECT_EQ(json["runs"][2]["output"]["path"], "out/blob.ply");

  EXPECT_EQ(simplify({"missing.obj", "cubes.obj"}, {"-o", "out/{stem}.ply", "--faces", "90", "--strict"}).exit_code, 4);
}

TEST_F(SeveralInputs, GoOnWhereOneOutputCannotBeWritten) {
  fs::create_directory(folder_ / "out/cubes.ply");
  const Outcome outcome = simplify({"cubes.obj", "blob.obj"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome;
  EXPECT_EQ(written(), (Arguments{"blob.ply", "cubes.ply"}));
}

TEST_F(SeveralInputs, HaveReportAndMaps) {
  const Outcome outcome = simplify({"cubes.obj", "blob.obj"}, {"-o", "out/{stem}.ply", "--faces", "150", "--map",
                                                               "out/{stem}.map", "--json", "report.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(written(), (Arguments{"blob.map", "blob.ply", "cubes.map", "cubes.ply"}));
  const std::string map = read_text(folder_ / "out/cubes.map");
  EXPECT_EQ(std::count(map.begin(), map.end(), '\n'), 200);
  const auto json = parse_json(read_text(folder_ / "report.json"));
  ASSERT_EQ(json["runs"].size(), 2U);
  const auto alone = parse_json(simplify({"cubes.obj"}, {"-o", "alone.ply", "--faces", "150", "--json", "-"}).out);
  for (const auto& [key, value] : alone.items()) EXPECT_TRUE(json["runs"][0].contains(key)) << key;
}

TEST_F(SeveralInputs, OfOneFileHaveTheSameReport) {
  const auto json = parse_json(simplify({"cubes.obj"}, {"-o", "out/{stem}.ply", "--faces", "150", "--json", "-"}).out);
  EXPECT_EQ(json["runs"].size(), 1U);
  EXPECT_EQ(written(), Arguments{"cubes.ply"});
}

TEST_F(SeveralInputs, LeaveOutFolderAndExtensions) {
  ASSERT_EQ(simplify({"blob.obj"}, {"-o", "in/one.two.PLY.gz", "--faces", "500"}).exit_code, 0);
  ASSERT_EQ(simplify({"in/one.two.PLY.gz", "./cubes.obj"}, {"-o", "out/{stem}-{stem}.obj", "--faces", "150"}).exit_code,
            0);
  EXPECT_EQ(written(), (Arguments{"cubes-cubes.obj", "one.two-one.two.obj"}));
}

TEST_F(SeveralInputs, OfOneNameAreRefusedBeforeAnythingIsWritten) {
  fs::copy_file(data_file("cubes.obj"), folder_ / "in/blob.obj");
  expect_refused(simplify({"cubes.obj", "blob.obj", "in/blob.obj"}),
                 "blob.obj and in/blob.obj would both be written to out/blob.ply");
  expect_refused(simplify({"blob.obj", "blob.obj"}), "blob.obj and blob.obj would both");
}

TEST_F(SeveralInputs, NeedTheirStem) {
  expect_refused(simplify({"cubes.obj", "blob.obj"}, {"-o", "out/a.ply", "--faces", "150"}), "'{stem}' in --output");
  expect_refused(simplify({"cubes.obj", "blob.obj"}, {"-o", "out/{stem}.ply", "--faces", "150", "--map", "out/map"}),
                 "--map: several inputs");
  expect_refused(simplify({"cubes.obj", "-"}, {"-o", "out/{stem}.ply", "--faces", "150", "--input-format", "obj"}),
                 "'-' has no name");
}

// It was part of the file's name where OUT has none.
TEST_F(SeveralInputs, OrOneGiveTheirNamesToFilesBesideOut) {
  expect_refused(
      simplify({"cubes.obj", "blob.obj"}, {"--join", "-o", "out/a.ply", "--faces", "9", "--map", "out/{stem}.map"}),
      "'{stem}' in --map is for several");
  ASSERT_EQ(simplify({"cubes.obj"}, {"-o", "out/a.ply", "--faces", "150", "--record", "out/{stem}_q.rec"}).exit_code,
            0);
  EXPECT_TRUE(fs::exists(folder_ / "out/cubes_q.rec"));
  EXPECT_FALSE(fs::exists(folder_ / "out/{stem}_q.rec"));
}

TEST_F(SeveralInputs, AreReplacedUnderForceOnly) {
  const std::string before = read_text(folder_ / "blob.obj");
  expect_refused(simplify({"cubes.obj", "blob.obj"}, {"-o", "{stem}.obj", "--faces", "150"}), "is an input too");
  EXPECT_EQ(read_text(folder_ / "blob.obj"), before);
  EXPECT_EQ(simplify({"cubes.obj", "blob.obj"}, {"-o", "{stem}.obj", "--faces", "150", "--force"}).exit_code, 0);
  EXPECT_NE(read_text(folder_ / "blob.obj"), before);
}

}  // namespace
}  // namespace whittle::test
