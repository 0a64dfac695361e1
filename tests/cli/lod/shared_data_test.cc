// Levels in .gltf files: what they have in common is written once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
#include "program/gltf_sheet.hh"
#include "program/program.hh"
#include "support/temporary_folder.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr char leaf_uri[] = "data:image/png;base64,iVBORw0KGgo=";
constexpr char leaf_bytes[] = "\x89PNG\r\n\x1a\n";

Json shared_document(const std::string& path) { return Json::parse(gltf::Asset::read(path).document()); }

/// The bytes of each buffer view of a GLB, or of a text with files beside it.
std::vector<std::string> bytes_of_views(const std::string& path) {
  const Json document = shared_document(path);
  std::vector<std::string> buffers;
  for (const Json& buffer : document["buffers"]) {
    const std::size_t length = buffer["byteLength"];
    if (buffer.contains("uri")) {
      buffers.push_back(read_text(fs::path(path).parent_path() / buffer["uri"].get<std::string>()));
      EXPECT_EQ(buffers.back().size(), length);
    } else {
      const std::string bytes = read_text(path);
      buffers.push_back(bytes.substr(bytes.size() - (length + 3) / 4 * 4, length));
    }
  }
  std::vector<std::string> views;
  for (const Json& view : document["bufferViews"]) {
    const std::string& buffer = buffers.at(view["buffer"].get<std::size_t>());
    const std::size_t offset = view.value("byteOffset", std::size_t{0});
    EXPECT_LE(offset + view["byteLength"].get<std::size_t>(), buffer.size());
    views.push_back(buffer.substr(offset, view["byteLength"]));
  }
  return views;
}

class SharedData : public testing::Test {
 protected:
  /// A sheet with a skin and an animation, and a picture in the text.
  SharedData() {
    fs::create_directory(folder_ / "out");
    write_gltf_sheet(folder_ / "made.glb", {.has_target = true}, 12);
    EXPECT_EQ(whittle({"convert", folder_ / "made.glb", in_}).exit_code, 0);
    Json document = Json::parse(read_text(in_));
    document["images"] = {{{"uri", leaf_uri}, {"name", "leaf"}}};
    write_text(in_, document.dump());
  }

  Outcome lod(const std::string& output) const { return whittle({"lod", in_, "--faces", "200,60", "-o", out(output)}); }

  std::string out(const std::string& name) const { return folder_ / ("out/" + name); }

  TemporaryFolder folder_;
  std::string in_ = folder_ / "in.gltf";
};

TEST_F(SharedData, IsWrittenOnce) {
  ASSERT_EQ(lod("a_{i}.gltf").exit_code, 0);
  ASSERT_EQ(lod("a_{i}.glb").exit_code, 0);
  for (const std::string level : {"a_0", "a_1"}) {
    const Json text = shared_document(out(level + ".gltf"));
    const Json whole = shared_document(out(level + ".glb"));
    ASSERT_EQ(text["buffers"].size(), 2U);
    EXPECT_EQ(text["buffers"][0]["uri"], level + ".bin");
    EXPECT_EQ(text["buffers"][1]["uri"], "a_shared.bin");
    for (const auto& [key, value] : whole.items()) {
      if (key != "buffers" && key != "bufferViews" && key != "images") {
        EXPECT_EQ(text[key], value) << key;
      }
    }
    std::vector<std::string> views = bytes_of_views(out(level + ".gltf"));
    EXPECT_EQ(text["images"], (Json{{{"bufferView", views.size() - 1}, {"mimeType", "image/png"}, {"name", "leaf"}}}));
    EXPECT_EQ(views.back(), leaf_bytes);
    views.pop_back();
    EXPECT_EQ(views, bytes_of_views(out(level + ".glb")));
  }
}

TEST_F(SharedData, IsNothingOfAMeshWithoutMore) {
  write_gltf_cube(in_, 8);
  Json document = Json::parse(read_text(in_));
  document.erase("animations");
  write_text(in_, document.dump());
  ASSERT_EQ(whittle({"lod", in_, "--faces", "300,60", "--compress", "-o", out("{faces}.gltf")}).exit_code, 0);
  for (const fs::directory_entry& file : fs::directory_iterator(folder_ / "out")) {
    if (file.path().extension() == ".gltf") {
      EXPECT_GT(gltf::Asset::read(file.path()).n_triangles(0), 0U);
    }
  }
}

TEST_F(SharedData, TakesNoFileOfTheInput) {
  fs::rename(in_, out("shared.gltf"));
  const std::string bytes = read_text(folder_ / "in.bin");
  fs::rename(folder_ / "in.bin", out("shared.bin"));
  in_ = out("shared.gltf");
  Json document = Json::parse(read_text(in_));
  document["buffers"][0]["uri"] = "shared.bin";
  write_text(in_, document.dump());
  const Outcome run = lod("{i}.gltf");
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(read_text(out("shared.bin")), bytes);
  EXPECT_EQ(shared_document(out("0.gltf"))["buffers"][1]["uri"], "shared_simplified.bin");
}

TEST_F(SharedData, LeavesNothingBehindIfItCantBeWritten) {
  fs::create_directory(out("a_shared.bin"));
  const Outcome run = lod("a_{i}.gltf");
  EXPECT_EQ(run.exit_code, 1) << run;
  EXPECT_THAT(run.err, testing::HasSubstr("a_shared.bin"));
  EXPECT_FALSE(fs::exists(out("a_0.gltf")));
  EXPECT_FALSE(fs::exists(out("a_0.bin")));
  const std::string before = read_text(in_);
  write_text(in_, before.substr(0, before.size() / 2));
  expect_failure(lod("b_{i}.gltf"), 4, {"in.gltf"});
  EXPECT_FALSE(fs::exists(out("b_shared.bin")));
}

TEST_F(SharedData, AreFilesOfPicturesBesideTheInput) {
  Json document = Json::parse(read_text(in_));
  document["images"][0]["uri"] = "leaf.png";
  write_text(in_, document.dump());
  write_text(folder_ / "leaf.png", leaf_bytes);
  ASSERT_EQ(lod("{i}.gltf").exit_code, 0);
  EXPECT_EQ(read_text(out("leaf.png")), leaf_bytes);
  for (const std::string level : {"0.gltf", "1.gltf"}) {
    EXPECT_EQ(shared_document(out(level))["images"], document["images"]);
  }
}

}  // namespace
}  // namespace whittle::test
