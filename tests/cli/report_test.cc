#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
#include "program/program.hh"
#include "program/stand_in_programs.hh"
#include "support/temporary_folder.hh"

namespace whittle::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

nlohmann::json data_of(const std::string& page) {
  const std::string begin = "<script id=\"whittle-data\" type=\"application/json\">";
  const std::size_t at = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
}

/// A result, its recording and the report of its run, in a folder; and whether this program can write pages.
class ReportCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    const Outcome run = whittle({"simplify", mesh, "-o", folder / "small.ply", "--faces", "400", "--record",
                                 folder / "run.rec", "--json", folder / "run.json", "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run;
    if (!has_page(folder)) GTEST_SKIP() << "this program was built without the page";
  }

  const TemporaryFolder folder;
  const std::string mesh = data_file("blob.obj");
};

TEST_F(ReportCommand, WritesAPageOfMeshes) {
  const std::string page = folder / "page.html";
  const Outcome outcome = whittle({"report", mesh, folder / "small.ply", "-o", page, "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["meshes"].size(), 2U);
  EXPECT_EQ(json["meshes"][1]["faces"], 400);
  EXPECT_GT(json["meshes"][1]["max_distance"], 0);
  EXPECT_EQ(json["recording"], nullptr);
  const std::string html = read_text(page);
  EXPECT_EQ(json["bytes"], html.size());
  EXPECT_THAT(html, StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">Mean error <small>% of the diagonal</small></th>"));
  const auto data = data_of(html);
  EXPECT_EQ(data["results"][0]["name"], "small.ply");
  EXPECT_EQ(data["results"][0]["distances"]["max"], json["meshes"][1]["max_distance"]);
}

TEST_F(ReportCommand, TakesRecordingsAsOriginalAndAsResult) {
  for (const std::vector<std::string>& files :
       {std::vector<std::string>{folder / "run.rec"}, {mesh, folder / "run.rec"}}) {
    std::vector<std::string> words{"report", "-o", "-", "--run", folder / "run.json", "--quiet"};
    words.insert(words.begin() + 1, files.begin(), files.end());
    const Outcome outcome = whittle(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    const auto data = data_of(outcome.out);
    EXPECT_GT(data["recording"]["steps"], 1000);
    EXPECT_EQ(data["results"][0]["faces"], 400);
    EXPECT_EQ(data["recording"]["levels"][0]["mean"], 0);
    EXPECT_THAT(outcome.out, HasSubstr("<th scope=\"row\">Ended because</th><td>the target was met</td>"));
    EXPECT_THAT(outcome.out, HasSubstr("&quot;rejections&quot;: {")) << "all figures are in its JSON";
  }
}

/// A column a mesh; the original has no error.
TEST_F(ReportCommand, MarksTheBetterOfTwoResults) {
  const std::string tiny = folder / "tiny.ply";
  ASSERT_EQ(whittle({"simplify", mesh, "-o", tiny, "--faces", "60", "--quiet"}).exit_code, 0);
  for (const bool is_better_first : {true, false}) {
    std::vector<std::string> words{"report", mesh, folder / "small.ply", tiny, "-o", "-", "--quiet"};
    if (!is_better_first) std::swap(words[2], words[3]);
    const Outcome outcome = whittle(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_THAT(outcome.out, HasSubstr("<th scope=\"col\">blob.obj</th><th scope=\"col\">"));
    const std::string row = "Mean error <small>model units</small></th>";
    const std::string cells = outcome.out.substr(outcome.out.find(row) + row.size(), 60);
    EXPECT_THAT(cells, StartsWith(is_better_first ? "<td></td><td class=\"best\">" : "<td></td><td>0."));
    const double mean = data_of(outcome.out)["results"][is_better_first ? 0 : 1]["error"]["mean"];
    EXPECT_GT(double(data_of(outcome.out)["results"][is_better_first ? 1 : 0]["error"]["mean"]), mean);
  }
}

/// The error says what to give.
TEST_F(ReportCommand, TakesTheMeshOfARecordingWithoutIt) {
  const std::string rec = folder / "bare.rec";
  const std::string page = folder / "page.html";
  ASSERT_EQ(whittle({"simplify", mesh, "-o", folder / "small.ply", "--faces", "400", "--record", rec, "--no-embed",
                     "--quiet"})
                .exit_code,
            0);
  const Outcome alone = whittle({"report", rec, "-o", page});
  expect_usage_error(alone, {"give the mesh before it, as in 'whittle report MESH " + rec + " -o PAGE'"});
  EXPECT_EQ(alone.err.find("--input"), std::string::npos) << alone;
  const Outcome both = whittle({"report", mesh, rec, "-o", page, "--quiet"});
  ASSERT_EQ(both.exit_code, 0) << both;
  EXPECT_EQ(data_of(read_text(page))["results"][0]["faces"], 400);
}

TEST_F(ReportCommand, RefusesReportsThatAreNotOfARun) {
  const std::string other = folder / "other.json";
  const std::string page = folder / "page.html";
  const std::vector<std::vector<std::string>> others = {
      {"measure", mesh, folder / "small.ply", "--samples", "10"},
      {"polish", mesh, folder / "small.ply", "-o", folder / "polished.ply"},
      {"lod", mesh, "-o", folder / "lod_{i}.ply", "--faces", "500"},
      {"replay", folder / "run.rec", "--at", "1", "-o", folder / "level.ply"}};
  for (std::vector<std::string> words : others) {
    words.insert(words.end(), {"--json", other, "--quiet"});
    ASSERT_EQ(whittle(words).exit_code, 0) << words.front();
    expect_failure(whittle({"report", mesh, folder / "small.ply", "-o", page, "--run", other}), 4,
                   {"other.json: is no report of a run"});
  }
  write_text(other, R"({"input": [], "output": {"faces": "many"}, "contractions": 1, "runs": [7]})");
  expect_failure(whittle({"report", mesh, "-o", page, "--run", other}), 4, {"is no report of a run"});
  EXPECT_FALSE(std::filesystem::exists(page));
}

TEST_F(ReportCommand, WarnsOfARunOfOtherMeshes) {
  const auto warned = [&](const std::vector<std::string>& files, const std::string& run) {
    std::vector<std::string> words{"report", "-o", folder / "page.html", "--run", run, "--json", folder / "page.json"};
    words.insert(words.begin() + 1, files.begin(), files.end());
    const Outcome outcome = whittle(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    const auto warnings = parse_json(read_text(folder / "page.json"))["warnings"];
    return warnings.empty() ? std::string() : std::string(warnings[0]);
  };
  const std::string run = folder / "run.json";
  const std::string small = folder / "small.ply";
  const std::string terrain = data_file("terrain.ply");
  EXPECT_EQ(warned({mesh, small}, run), "");
  EXPECT_EQ(warned({mesh, mesh, small}, run), "") << "one result is enough";
  EXPECT_EQ(warned({mesh}, run), "");
  EXPECT_THAT(warned({small, mesh}, run), HasSubstr("run.json: may be of other meshes: has no run that read 400 faces "
                                                    "and wrote 5120 faces"));
  EXPECT_THAT(warned({terrain}, run), HasSubstr("has no run that read "));

  const std::string runs = folder / "runs.json";
  ASSERT_EQ(
      whittle({"simplify", mesh, terrain, "-o", folder / "{stem}_500.ply", "--faces", "500", "--json", runs, "--quiet"})
          .exit_code,
      0);
  EXPECT_EQ(warned({terrain, folder / "terrain_500.ply"}, runs), "");
  EXPECT_THAT(warned({mesh, small}, runs), HasSubstr("wrote 400 faces"));

  const std::string speck = folder / "speck.obj";
  write_text(speck, read_text(mesh) + "v 3 3 3\nv 3.01 3 3\nv 3 3.01 3\nf -3 -2 -1\n");
  ASSERT_EQ(
      whittle({"simplify", speck, "-o", small, "--faces", "400", "--prune", "1%", "--json", run, "--quiet"}).exit_code,
      0);
  ASSERT_EQ(parse_json(read_text(run))["output"]["pruned_components"], 1);
  EXPECT_EQ(warned({speck, small}, run), "") << "the run says how many faces are left without the speck";
}

/// The scene has more faces than the meshes of the run, which are counted once.
TEST_F(ReportCommand, DoesNotCompareTheRunOfGltf) {
  write_gltf_cube(folder / "cube.glb", 8);
  ASSERT_EQ(whittle({"simplify", folder / "cube.glb", "-o", folder / "small.glb", "--face-ratio", "20%", "--json",
                     folder / "run.json", "--quiet"})
                .exit_code,
            0);
  const Outcome outcome = whittle({"report", data_file("cubes.obj"), folder / "cube.glb", "-o", folder / "page.html",
                                   "--run", folder / "run.json"});
  EXPECT_THAT(outcome.err, HasSubstr("has no run that read"));
  const Outcome scene = whittle(
      {"report", folder / "cube.glb", folder / "small.glb", "-o", folder / "page.html", "--run", folder / "run.json"});
  EXPECT_EQ(scene.err.find("other meshes"), std::string::npos) << scene;
}

TEST_F(ReportCommand, ShowsACoarserLevelOfALargeMesh) {
  const Outcome outcome =
      whittle({"report", mesh, folder / "small.ply", "-o", folder / "page.html", "--max-faces", "1000", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_LE(json["meshes"][0]["shown_faces"], 1000);
  EXPECT_GT(json["meshes"][0]["faces"], 1000);
  EXPECT_THAT(std::string(data_of(read_text(folder / "page.html"))["original"]["note"]), HasSubstr("coarser"));
}

TEST_F(ReportCommand, ShowsGltfWhereTheSceneHasIt) {
  write_gltf_cube(folder / "cube.glb", 8);
  const Outcome run = whittle({"simplify", folder / "cube.glb", "-o", folder / "small.glb", "--face-ratio", "20%",
                               "--page", folder / "run.html", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const Outcome outcome =
      whittle({"report", folder / "cube.glb", folder / "small.glb", "-o", folder / "page.html", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  for (const char* const name : {"run.html", "page.html"}) {
    const auto data = data_of(read_text(folder / name));
    EXPECT_NEAR(data["origin"][0].get<double>(), -3, 1e-6) << "a node makes the cube 3 times as large";
    for (const auto& look : {data["original"]["look"], data["results"][0]["look"]}) {
      ASSERT_EQ(look["materials"].size(), 4U) << name << ": of two primitives, of the points, and none";
      EXPECT_EQ(look["materials"][1]["alpha"], "blend");
      EXPECT_FALSE(look["normals"].is_null());
      EXPECT_EQ(look["maps"].size(), 2U);
    }
  }
}

/// The recording is of each mesh once, or of the scene as it is shown.
TEST_F(ReportCommand, TakesARecordingOfGltfAsItsResult) {
  write_gltf_cube(folder / "cube.glb", 6);
  for (const auto& [out, attributes] :
       {std::pair("small.glb", "keep"), std::pair("small.ply", "keep"), std::pair("small.ply", "position-only")}) {
    const Outcome run = whittle({"simplify", folder / "cube.glb", "-o", folder / out, "--face-ratio", "20%", "--record",
                                 folder / "cube.rec", "--quiet", "--attributes", attributes});
    ASSERT_EQ(run.exit_code, 0) << run;
    const Outcome outcome =
        whittle({"report", folder / "cube.glb", folder / "cube.rec", "-o", folder / "page.html", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
  }
  write_gltf_cube(folder / "cube.glb", 5);
  const Outcome other = whittle({"report", folder / "cube.glb", folder / "cube.rec", "-o", folder / "page.html"});
  EXPECT_EQ(other.exit_code, 4) << other;
}

TEST_F(ReportCommand, ShowsColoursAndTextures) {
  const std::string image = "\x89PNG\r\n\x1A\n and so on";
  const auto write = [&](const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; };
  write("a.png", image);
  write("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl bricks\nKd 0 0 0\nmap_Kd a.png\n");
  write("a.obj",
        "mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nv 0 0 1 1 0 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
        "usemtl bricks\nf 1/1 2/2 3/3\nusemtl red\nf 1/1 3/2 4/3\n");
  const Outcome outcome = whittle({"report", folder / "a.obj", "-o", folder / "page.html", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const auto data = data_of(read_text(folder / "page.html"));
  const auto& look = data["original"]["look"];
  EXPECT_FALSE(look["colours"].is_null());
  ASSERT_EQ(data["images"].size(), 1U);
  EXPECT_EQ(data["images"][0]["bytes"]["bytes"], image.size());
  EXPECT_EQ(look["materials"][0]["image"], 0);
  EXPECT_EQ(look["materials"][0]["colour"], (nlohmann::json{1, 1, 1, 1})) << "a texture hides Kd";
  EXPECT_EQ(look["materials"][1]["colour"], (nlohmann::json{1, 0, 0, 1}));
  // PLY names the one texture, too, but not for the red material.
  ASSERT_EQ(whittle({"convert", folder / "a.obj", folder / "a.ply"}).exit_code, 0);
  ASSERT_EQ(whittle({"report", folder / "a.ply", "-o", folder / "page.html", "--quiet"}).exit_code, 0);
  EXPECT_EQ(data_of(read_text(folder / "page.html"))["original"]["look"]["materials"], look["materials"]);
}

TEST_F(ReportCommand, WarnsOfWhatIsNoImage) {
  const auto write = [&](const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; };
  write("a.mtl", "newmtl a\nmap_Kd a.mtl\nnewmtl b\nmap_Kd b.png\n");
  write("a.obj",
        "mtllib a.mtl\nmtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
        "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/2 4/3\n");
  const Outcome outcome = whittle({"report", folder / "a.obj", "-o", folder / "page.html"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_THAT(outcome.err, HasSubstr("a.obj: texture a.mtl is not shown: it is neither PNG nor JPEG nor WebP"));
  EXPECT_THAT(outcome.err, HasSubstr("texture b.png is not shown: the file can't be read"));
  EXPECT_THAT(outcome.err, HasSubstr("material library b.mtl can't be read"));
  EXPECT_TRUE(data_of(read_text(folder / "page.html"))["images"].empty());
}

/// Pairs by reason, as the page has them.
TEST_F(ReportCommand, ShowsWhyARunStopped) {
  const std::string page = folder / "why.html";
  const Outcome outcome = whittle({"simplify", data_file("cubes.obj"), "-o", folder / "least.ply", "--faces", "20",
                                   "--topology", "keep", "--page", page, "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const auto refused = nlohmann::json::parse(outcome.out)["refused_at_end"];
  const auto data = data_of(read_text(page));
  ASSERT_EQ(data["results"][0]["refusals"].size(), 1U);
  EXPECT_EQ(data["results"][0]["refusals"][0]["reason"], "by topology");
  EXPECT_EQ(data["results"][0]["refusals"][0]["pairs"]["count"], refused["link"]);
  EXPECT_THAT(std::string(data["advice"]), HasSubstr("'--topology free'"));
  EXPECT_GT(data["recording"]["steps"], 0);
}

TEST_F(ReportCommand, OpensThePage) {
  const StandInPrograms programs(folder);
  const std::string page = folder / "page.html";
  EXPECT_EQ(whittle({"report", mesh, "-o", page, "--open"}).exit_code, 0);
  EXPECT_EQ(read_text(folder / "opened.txt"), page);
}

TEST_F(ReportCommand, SaysThatNoProgramOpensThePage) {
  const StandInPrograms programs(folder);
  std::filesystem::remove_all(folder / "bin");
  const Outcome opened = whittle({"report", mesh, "-o", folder / "page.html", "--open"});
  EXPECT_EQ(opened.exit_code, 0);
  EXPECT_THAT(opened.err, HasSubstr("warning: --open"));
}

TEST_F(ReportCommand, SaysWhatIsWrong) {
  const std::string out = folder / "page.html";
  const auto report = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "report");
    return whittle(words);
  };
  expect_usage_error(report({mesh}), {"--output", "--png"});
  expect_usage_error(report({mesh, folder / "run.rec", folder / "run.rec", "-o", out}), {"two recordings"});
  expect_usage_error(report({mesh, "-o", out, "--png-size", "10x"}), {"--png-size"});
  expect_usage_error(report({folder / "run.rec", "--frames", folder / "f.png"}), {"--frames", "{i}"});
  expect_usage_error(report({folder / "run.rec", "--frames", folder / "f{i}.jpg"}), {"--frames", ".png"});
  expect_usage_error(report({folder / "run.rec", "--animate", folder / "f.gif"}), {"--animate", ".webp"});
  expect_usage_error(report({mesh, "--png", folder / "p.png", "--view", "colour='x'"}), {"--view", "KEY=VALUE"});
  const std::pair<const char*, const char*> wrong_views[] = {{"colour=bogus", "'bogus' is none of none|error|valence"},
                                                             {"color=error", "'color' is none of layout, result"},
                                                             {"level=2", "0 <= level <= 1"},
                                                             {"turn=left", "turn"},
                                                             {"plain=on", "plain takes no value"},
                                                             {"edges", "edges needs a value"}};
  for (const auto& [view, said] : wrong_views) {
    expect_usage_error(report({mesh, "--png", folder / "p.png", "--view", view}), {"--view", said});
  }
  expect_usage_error(report({mesh, "--png", folder / "p.png", "--open"}), {"--open"});
  expect_usage_error(report({mesh, "-o", mesh}), {"--force"});
  EXPECT_EQ(report({data_file("cubes.obj"), folder / "run.rec", "-o", out}).exit_code, 4);
  EXPECT_EQ(report({mesh, "-o", out, "--run", mesh}).exit_code, 4);
  expect_failure(report({mesh, "-o", out, "--run", folder.path().string()}), 4, {"is a folder, not a file"});
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace whittle::test
