#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
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

TEST(GeomorphCommand, NamesWhatIsLeftOut) {
  const TemporaryFolder folder;
  const std::string rec = folder / "rec";
  const auto left_out_of = [&](const std::vector<std::string>& simplify, std::vector<std::string> geomorph) {
    std::vector<std::string> words = simplify;
    words.insert(words.begin(), "simplify");
    words.insert(words.end(), {"-o", folder / "last.ply", "--face-ratio", "20%", "--record", rec, "--quiet"});
    EXPECT_EQ(whittle(words).exit_code, 0);
    geomorph.insert(geomorph.begin(), {"geomorph", rec, "--json", folder / "json"});
    const Outcome outcome = whittle(geomorph);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    const auto warnings = parse_json(read_text(folder / "json"))["warnings"];
    EXPECT_LE(warnings.size(), 1U) << outcome;
    return warnings.empty() ? std::string() : std::string(warnings[0]);
  };
  const std::string cube = folder / "cube.glb";
  const std::string out = folder / "out.glb";
  write_gltf_cube(cube, 8);
  const std::string all = "left out: TEXCOORD_0, materials, all but one normal and colour of a vertex";
  EXPECT_EQ(left_out_of({cube}, {"-o", out}), out + ": " + all);
  const std::string frames = folder / "f{i}.obj";
  EXPECT_EQ(left_out_of({cube}, {"-o", frames, "--frames", "3"}), frames + ": " + all);
  EXPECT_EQ(left_out_of({cube, "--attributes", "position-only"}, {"-o", out}), "");
  EXPECT_EQ(left_out_of({data_file("blob.obj")}, {"-o", out}), "");
}

TEST(GeomorphCommand, TakesTheGltfThatWasSimplified) {
  const TemporaryFolder folder;
  const std::string cube = folder / "cube.glb";
  write_gltf_cube(cube, 8);
  const std::string rec = folder / "rec";
  const Outcome run =
      whittle({"simplify", cube, "-o", folder / "last.glb", "--face-ratio", "20%", "--record", rec, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const auto morph = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"geomorph", rec, "-o", folder / "out.glb", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = whittle(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    return read_text(folder / "out.glb");
  };
  const std::string embedded = morph({});
  EXPECT_TRUE(morph({"--input", cube}) == embedded);
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

// Faces that have become one keep the corners that they had when polish began.
TEST(GeomorphCommand, GoesAcrossPausesWhereFacesHaveBecomeOne) {
  const TemporaryFolder folder;
  const std::string rec = recording_of(folder, "cubes.obj", {"--faces", "60", "--threshold", "auto"});
  const Outcome outcome = whittle({"geomorph", rec, "--frames", "2", "-o", folder / "f_{i}.ply"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const auto measured = whittle({"measure", folder / "last.ply", folder / "f_1.ply", "--json", "-"});
  EXPECT_LT(nlohmann::json::parse(measured.out)["forward"]["max_rel"], 1e-6) << measured;
}

}  // namespace
}  // namespace whittle::test
