#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
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

/// Runs the program, which must succeed.
Outcome done(const std::vector<std::string>& arguments) {
  Outcome outcome = whittle(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  return outcome;
}

TEST(ReplayCommand, WritesWhatSimplifyWrites) {
  const TemporaryFolder folder;
  const std::string small = folder / "small.ply";
  const std::string level = folder / "level.ply";
  const std::string rec = folder / "rec";
  for (const std::string mesh : {"blob.obj", "bracket.stl", "terrain.ply", "cubes.obj"}) {
    const std::string cost = mesh == "blob.obj" ? "memoryless" : "quadric";
    const std::vector<std::string> exact{"--cost", cost, "--order", "exact", "--polish", "0", "--quiet"};
    const auto simplify = [&](const std::string& faces, std::vector<std::string> more) {
      more.insert(more.begin(), {"simplify", data_file(mesh), "-o", small, "--faces", faces});
      more.insert(more.end(), exact.begin(), exact.end());
      done(more);
    };
    simplify("150", {"--record", rec});
    for (const std::string faces : {"1000", "300", "150"}) {
      simplify(faces, {});
      done({"replay", rec, "--faces", faces, "-o", level, "--quiet"});
      EXPECT_TRUE(read_text(small) == read_text(level)) << mesh << ", " << faces;
    }
  }
}

TEST(ReplayCommand, EndsWithTheResultOfTheRun) {
  const TemporaryFolder folder;
  const std::string small = folder / "small.ply";
  const std::string plain = folder / "plain.ply";
  const std::string level = folder / "level.ply";
  const std::string rec = folder / "rec";
  for (const std::string effort : {"fast", "normal", "best"}) {
    const std::vector<std::string> simplify{"simplify", data_file("terrain.ply"), "--ratio", "10%", "--effort", effort,
                                            "--quiet"};
    std::vector<std::string> recorded = simplify;
    recorded.insert(recorded.end(), {"-o", small, "--record", rec, "--zstd"});
    std::vector<std::string> unrecorded = simplify;
    unrecorded.insert(unrecorded.end(), {"-o", plain});
    done(recorded);
    done(unrecorded);
    done({"replay", rec, "--at", "1", "-o", level, "--quiet"});
    EXPECT_TRUE(read_text(small) == read_text(level)) << effort;
    EXPECT_TRUE(read_text(small) == read_text(plain)) << effort;
    done({"replay", rec, "--at", "0", "-o", level, "--quiet"});
    done({"convert", data_file("terrain.ply"), plain, "--quiet"});
    EXPECT_TRUE(read_text(plain) == read_text(level)) << effort;
  }
}

TEST(ReplayCommand, KeepsAttributes) {
  const TemporaryFolder folder;
  const std::string rec = folder / "rec";
  write_gltf_cube(folder / "cube.glb", 8);
  done({"convert", folder / "cube.glb", folder / "cube.obj", "--quiet"});
  for (const std::string in : {"cube.glb", "cube.obj"}) {
    const std::string extension = in.substr(in.size() - 4);
    const std::string small = folder / ("small" + extension);
    const std::string last = folder / ("last" + extension);
    done({"simplify", folder / in, "-o", small, "--faces", "100", "--record", rec, "--quiet"});
    done({"replay", rec, "--input", folder / in, "--at", "1", "-o", last, "--quiet"});
    EXPECT_TRUE(read_text(small) == read_text(last)) << in;
    done({"replay", rec, "--at", "1", "-o", folder / "embedded.obj", "--quiet"});
    done({"convert", small, folder / "small.obj", "--force", "--quiet"});
    const io::ReadOptions all{.attributes = io::AttributeScope::all};
    const IndexedMesh embedded = io::read_mesh(folder / "embedded.obj", all).mesh;
    const IndexedMesh direct = io::read_mesh(folder / "small.obj", all).mesh;
    ASSERT_EQ(embedded.attributes.size(), 1U);
    EXPECT_EQ(embedded.group_names, direct.group_names);
    EXPECT_EQ(embedded.faces.size(), direct.faces.size());
    double sum = 0;
    for (std::size_t i = 0; i < embedded.attributes[0].values.size(); ++i) {
      sum += embedded.attributes[0].values[i] - direct.attributes[0].values[i];
    }
    EXPECT_NEAR(sum, 0, 1e-3) << "the picture is not upside down";
  }
}

TEST(ReplayCommand, WritesASeries) {
  const TemporaryFolder folder;
  const std::string rec = folder / "rec";
  done({"simplify", data_file("blob.obj"), "-o", folder / "s.obj", "--faces", "100", "--record", rec, "--quiet"});
  const Outcome outcome = done({"replay", rec, "--steps", "1:0:11", "-o", folder / "f_{i}.obj", "--json", "-"});
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["levels"].size(), 11U);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(json["levels"][i]["path"], folder / ("f_" + std::string(i < 10 ? "0" : "") + std::to_string(i) + ".obj"));
    EXPECT_TRUE(std::filesystem::exists(std::string(json["levels"][i]["path"])));
    EXPECT_TRUE(i == 0 || json["levels"][i]["faces"] > json["levels"][i - 1]["faces"]);
  }
  EXPECT_EQ(json["levels"][10]["max_cost"], 0);
}

TEST(ReplayCommand, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string rec = folder / "rec";
  const std::string bare = folder / "bare";
  const std::string out = folder / "out.ply";
  const std::string mesh = data_file("blob.obj");
  done({"simplify", mesh, "-o", folder / "s.obj", "--faces", "100", "--record", rec, "--quiet"});
  done({"simplify", mesh, "-o", folder / "s.obj", "--faces", "100", "--record", bare, "--no-embed", "--quiet"});
  const auto replay = [&](std::vector<std::string> more) {
    more.insert(more.begin(), "replay");
    more.insert(more.end(), {"-o", out});
    return whittle(more);
  };
  expect_usage_error(replay({rec}), {"--faces", "only one"});
  expect_usage_error(replay({rec, "--faces", "200", "--at", "1"}), {"only one"});
  expect_usage_error(replay({rec, "--steps", "0:1:3"}), {"{i}"});
  expect_usage_error(replay({rec, "--steps", "0:1"}), {"--steps", "A:B:N"});
  expect_usage_error(replay({rec, "--steps", "0:2:3"}), {"--steps", "0 <= B <= 1"});
  expect_usage_error(replay({rec, "--at", "1.5"}), {"--at", "0 <= T <= 1"});
  expect_usage_error(replay({bare, "--at", "1"}), {"--input"});
  expect_failure(replay({rec, "--faces", "10"}), 1, {"more than 10 faces", "100 faces"});
  expect_failure(replay({bare, "--at", "1", "--input", data_file("terrain.ply")}), 4, {"is not the mesh of"});
  expect_failure(replay({mesh, "--at", "1"}), 4, {"no recording"});
  expect_failure(replay({folder / "missing", "--at", "1"}), 4, {"cannot be opened"});
  expect_failure(replay({folder.path().string(), "--at", "1"}), 4, {"is a folder, not a file"});
  write_text(folder / "half", read_text(rec).substr(0, 5000));
  expect_failure(replay({folder / "half", "--at", "1"}), 4, {"not complete"});
  std::string damaged = read_text(rec);
  damaged[damaged.size() / 2] ^= 1;
  write_text(folder / "damaged", damaged);
  expect_failure(replay({folder / "damaged", "--at", "1"}), 4, {"damaged"});
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace whittle::test
