// The subcommand `convert`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
#include "program/gltf_sheet.hh"
#include "program/program.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(Convert, ReadsAndWritesEveryPairOfFormats) {
  const TemporaryFolder folder;
  const IndexedMesh mesh = io::read_mesh(data_file("blob.obj")).mesh;
  for (const io::Format from : io::all_formats) {
    const std::string in = folder / ("in." + std::string(io::name_of(from)));
    io::write_mesh(in, mesh);
    const IndexedMesh expected = io::read_mesh(in).mesh;
    for (const io::Format to : io::all_formats) {
      const std::string out = folder / ("out." + std::string(io::name_of(to)));
      const Outcome outcome = whittle({"convert", in, out});
      ASSERT_EQ(outcome.exit_code, 0) << outcome;
      const IndexedMesh converted = io::read_mesh(out).mesh;
      EXPECT_EQ(converted.faces.size(), mesh.faces.size());
      EXPECT_EQ(converted.positions.size(), mesh.positions.size());
      if (to == io::Format::stl) continue;  // it stores no shared vertices, so their order is another
      EXPECT_EQ(converted.positions, expected.positions) << in << ' ' << out;
    }
  }
}

TEST(Convert, SaysWhatItRepairsAndWhatItDoesNotCarry) {
  const TemporaryFolder folder;
  write_text(folder / "in.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 5 5\nvt 0 0\nvn 0 0 1\n"
             "f 1/1/1 2/1/1 3/1/1 4/1/1\n");
  const Outcome outcome = whittle({"convert", folder / "in.obj", folder / "out.stl", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  for (const char* said :
       {"in.obj: triangulated 1 polygon, dropped 1 isolated vertex", "out.stl: STL can't hold the vertex attribute vt",
        "out.stl: STL has no vertex normals", "out.stl: 2 faces, 4 vertices in "}) {
    EXPECT_NE(outcome.err.find(said), std::string::npos) << "not said: " << said << '\n' << outcome;
  }
  const auto json = parse_json(outcome.out);
  EXPECT_EQ(json["input"]["format"], "obj");
  EXPECT_EQ(json["input"]["repairs"]["triangulated_polygons"], 1);
  EXPECT_EQ(json["output"]["path"], folder / "out.stl");
  EXPECT_EQ(json["output"]["format"], "stl");
  EXPECT_EQ(json["output"]["faces"], 2);
  EXPECT_EQ(json["warnings"].size(), 2U) << json;
  EXPECT_GE(json["seconds"]["total"], json["seconds"]["write"]);
}

TEST(Convert, KeepsAttributes) {
  const TemporaryFolder folder;
  IndexedMesh mesh = io::read_mesh(data_file("blob.obj")).mesh;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.colors.push_back({static_cast<float>(v % 256) / 255, 0, 1, 1});
    mesh.normals.push_back({0, 0, v % 2 == 0 ? 1.0F : -1.0F});
  }
  io::write_mesh(folder / "in.ply", mesh);
  ASSERT_EQ(whittle({"convert", folder / "in.ply", folder / "out.off"}).exit_code, 0);
  const IndexedMesh converted = io::read_mesh(folder / "out.off").mesh;
  EXPECT_EQ(converted.colors, mesh.colors);
  EXPECT_EQ(converted.normals, mesh.normals);
}

TEST(Convert, KeepsWhatAnObjFileHas) {
  const TemporaryFolder folder;
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const std::string obj = "mtllib my paint.mtl\n" + square +
                          "vt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.5\nvt 0 1\nusemtl red\nf 1/1 2/2 3/3\nusemtl blue\n"
                          "f 1/4 3/3 4/5\n";
  std::ofstream(folder / "in.obj") << obj;
  ASSERT_EQ(whittle({"convert", folder / "in.obj", folder / "out.obj"}).exit_code, 0);
  std::ifstream file(folder / "out.obj");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), obj);
  const Outcome to_stl = whittle({"convert", folder / "in.obj", folder / "out.stl"});
  EXPECT_THAT(to_stl.err, testing::HasSubstr("STL can't hold the vertex attribute vt: it is left out"));
  ASSERT_EQ(whittle({"convert", folder / "in.obj", folder / "out.ply"}).exit_code, 0);
  ASSERT_EQ(whittle({"convert", folder / "out.ply", folder / "again.obj"}).exit_code, 0);
  EXPECT_EQ(io::read_mesh(folder / "again.obj").mesh.group_names, (std::vector<std::string>{"red", "blue"}));
}

TEST(Convert, WeldsUnlessToldNotTo) {
  const TemporaryFolder folder;
  const std::string mesh = data_file("bracket.stl");
  ASSERT_EQ(whittle({"convert", mesh, folder / "out.ply"}).exit_code, 0);
  EXPECT_EQ(io::read_mesh(folder / "out.ply", {.weld = false}).mesh.positions.size(), 738U);
  ASSERT_EQ(whittle({"convert", mesh, folder / "out.ply", "--no-weld"}).exit_code, 0);
  EXPECT_EQ(io::read_mesh(folder / "out.ply", {.weld = false}).mesh.positions.size(), 4428U);
}

TEST(Convert, WritesNothingWhereSomethingIsWrong) {
  const TemporaryFolder folder;
  const std::string mesh = folder / "mesh.obj";
  const std::string cubes = read_text(data_file("cubes.obj"));
  write_text(mesh, cubes);
  const Outcome same = whittle({"convert", mesh, mesh});
  EXPECT_EQ(same.exit_code, 2) << "without --force";
  EXPECT_NE(same.err.find("OUT: "), std::string::npos) << same;
  EXPECT_EQ(whittle({"convert", mesh, folder / "out.fbx"}).exit_code, 2);
  EXPECT_EQ(whittle({"convert", mesh, "-"}).exit_code, 2) << "without a format";
  EXPECT_EQ(whittle({"convert", folder / "missing.ply", folder / "out.ply"}).exit_code, 4);
  EXPECT_EQ(whittle({"convert", mesh, folder / "no/such/out.ply"}).exit_code, 1);
  EXPECT_EQ(whittle({"convert", mesh, folder / "x", "--output-format", "ply", "--json", folder / "x"}).exit_code, 2);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"mesh.obj"});
  EXPECT_EQ(read_text(mesh), cubes);
}

TEST(Convert, ReplacesNoFileThatBelongsToAGltfFile) {
  const TemporaryFolder folder;
  const std::string cubes = data_file("cubes.obj");
  const std::string in = folder / "a.gltf";
  const std::string buffer = folder / "a.bin";
  ASSERT_EQ(whittle({"convert", cubes, in}).exit_code, 0);
  const std::string before = read_text(buffer);
  EXPECT_EQ(whittle({"convert", cubes, in}).exit_code, 0) << "an earlier output is replaced, with its buffer";
  expect_usage_error(whittle({"convert", in, buffer, "--output-format", "stl", "--quiet"}),
                     {"a.bin: an input needs this file"});

  fs::permissions(buffer, fs::perms::owner_read);
  expect_failure(whittle({"convert", cubes, in, "--quiet"}), 1, {"a.bin", "write-protected", "--force"});
  EXPECT_EQ(read_text(buffer), before);
  EXPECT_EQ(whittle({"convert", cubes, in, "--force"}).exit_code, 0);
  EXPECT_EQ(whittle({"convert", in, buffer, "--output-format", "stl", "--force"}).exit_code, 0);
  EXPECT_NE(read_text(buffer), before);
}

TEST(Convert, SaysWhatOfAGltfFileIsNoSurface) {
  const TemporaryFolder folder;
  const auto warnings_of = [&folder](const std::string& in) {
    const Outcome outcome = whittle({"convert", in, folder / "out.ply", "--json", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    return parse_json(outcome.out)["warnings"].dump();
  };
  const std::string in = folder / "in.gltf";
  write_gltf_cube(in, 2);
  EXPECT_THAT(warnings_of(in),
              HasSubstr("left out: the materials, with their colours and images; points, animations, cameras\""));
  write_gltf_sheet(in, {.has_skin = true, .is_animated = true}, 2);
  EXPECT_THAT(warnings_of(in), HasSubstr("out.ply: left out: animations, skins\""));
  ASSERT_EQ(whittle({"convert", data_file("cubes.obj"), folder / "plain.glb"}).exit_code, 0);
  EXPECT_EQ(warnings_of(folder / "plain.glb"), "[]") << "it has no materials of its own";
}

}  // namespace
}  // namespace whittle::test
