#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"
#include "support/temporary_folder.hh"
#include "whittle/io/read.hh"

namespace whittle::test {
namespace {

std::string recording_of(const TemporaryFolder& folder, const std::string& mesh, std::vector<std::string> more = {}) {
  std::string rec = folder / "rec";
  more.insert(more.begin(), {"simplify", data_file(mesh), "-o", folder / "last.ply", "--record", rec, "--quiet"});
  const Outcome outcome = whittle(more);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  return rec;
}

TEST(GeomorphCommand, WritesFramesFromOneLevelToTheOther) {
  const TemporaryFolder folder;
  const std::string rec = recording_of(folder, "blob.obj", {"--faces", "300"});
  const Outcome outcome =
      whittle({"geomorph", rec, "--from", "2000", "--frames", "11", "-o", folder / "f_{i}.ply", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["paths"].size(), 11U);
  EXPECT_EQ(json["from_faces"], 2000);
  EXPECT_EQ(json["to_faces"], 300);
  ASSERT_EQ(whittle({"replay", rec, "--faces", "2000", "-o", folder / "fine.ply", "--quiet"}).exit_code, 0);
  const IndexedMesh fine = io::read_mesh(folder / "fine.ply").mesh;
  const IndexedMesh first = io::read_mesh(std::string(json["paths"][0])).mesh;
  EXPECT_EQ(first.positions, fine.positions);
  EXPECT_EQ(first.faces, fine.faces);
  // Faces that were contracted have no area, and reading drops them.
  const io::ReadResult last = io::read_mesh(std::string(json["paths"][10]));
  EXPECT_EQ(last.mesh.faces.size(), 300U);
}

TEST(GeomorphCommand, WritesGltf) {
  const TemporaryFolder folder;
  const std::string rec = recording_of(folder, "terrain.ply", {"--faces", "300"});
  const std::string glb = folder / "morph.glb";
  const Outcome outcome = whittle({"geomorph", rec, "--from", "1000", "-o", glb});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const std::string file = read_text(glb);
  EXPECT_EQ(file.substr(0, 4), "glTF");
  const Outcome printed = whittle({"geomorph", rec, "--from", "1000", "-o", "-", "--quiet"});
  EXPECT_TRUE(printed.out == file);
}

TEST(GeomorphCommand, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string rec = recording_of(folder, "terrain.ply", {"--faces", "300", "--effort", "best"});
  const std::string n_faces = std::to_string(io::read_mesh(folder / "last.ply").mesh.faces.size());
  const auto geomorph = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"geomorph", rec});
    return whittle(more);
  };
  const std::string glb = folder / "out.glb";
  expect_usage_error(geomorph({"-o", folder / "out.ply"}), {".glb", "--frames"});
  expect_usage_error(geomorph({"-o", folder / "out{i}.glb"}), {"{i}", "--frames"});
  expect_usage_error(geomorph({"-o", folder / "out.ply", "--frames", "3"}), {"{i}"});
  expect_usage_error(geomorph({"-o", folder / "out{i}.glb", "--frames", "3"}), {"out0.glb"});
  expect_usage_error(geomorph({"-o", glb, "--frames", "1"}), {"--frames"});
  expect_usage_error(geomorph({"-o", glb, "--from", "500", "--to", "1000"}), {"--to", "more faces"});
  expect_usage_error(geomorph({"-o", rec + ".glb", "--from", "0"}), {"--from"});
  expect_failure(geomorph({"-o", glb, "--to", "10"}), 1, {"more than 10 faces", n_faces + " faces"});
  expect_failure(geomorph({"-o", glb}), 1, {"flips edges", "--effort best"});
  EXPECT_FALSE(std::filesystem::exists(glb));
  EXPECT_EQ(geomorph({"-o", glb, "--to", "600"}).exit_code, 0);
}

}  // namespace
}  // namespace whittle::test
