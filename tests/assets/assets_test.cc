// Files of many programs: nothing but geometry changes, the target is met or a warning says why not, and the validator
// finds no error that the input doesn't have.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "program/program.hh"
#include "support/temporary_folder.hh"
#include "unit/gltf/assets.hh"
#include "unit/gltf/validator.hh"

namespace whittle::gltf::test {
namespace {

namespace fs = std::filesystem;
using whittle::test::Outcome;
using whittle::test::TemporaryFolder;
using whittle::test::whittle;

constexpr std::array<const char*, 3> shares{"50%", "10%", "2%"};

/// Small files, or all of them if the environment says so.
std::vector<fs::path> files_of(const std::vector<std::string>& folders, const std::vector<std::string>& extensions) {
  std::vector<fs::path> files = asset_files(folders, extensions);
  constexpr std::uintmax_t small = 100'000;  // bytes
  if (std::getenv("WHITTLE_ALL_ASSETS") == nullptr) {
    std::erase_if(files, [](const fs::path& file) { return fs::file_size(file) > small; });
  }
  return files;
}

/// A file that is damaged.
bool is_refused(const fs::path& file) { return file.filename() == "issue-140-zero-face-idx.obj"; }

/// A glTF file of points, or of triangles that are none. It is written as it was.
bool has_no_faces(const fs::path& file) {
  const std::vector<std::string> names{"mesh-custom-attributes.gltf", "Mesh_PrimitiveMode_00.gltf",
                                       "index_buffer_degenerate_triangle.gltf"};
  return std::find(names.begin(), names.end(), file.filename()) != names.end();
}

void expect_refusal(const Outcome& outcome, const fs::path& file) {
  EXPECT_EQ(outcome.exit_code, 4) << file << outcome;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << file << outcome;
}

/// Simplifies a file. \return whether it is one that can be
bool simplify(const fs::path& file, const std::string& out, const char* share) {
  const Outcome outcome = whittle({"simplify", file.string(), "-o", out, "--face-ratio", share, "--json", "-"});
  if (is_refused(file)) {
    expect_refusal(outcome, file);
    return false;
  }
  EXPECT_EQ(outcome.exit_code, 0) << file << outcome;
  if (outcome.exit_code != 0) return false;
  const auto report = whittle::test::parse_json(outcome.out);
  const std::vector<std::string> warnings = report["warnings"];
  if (report["target"]["met"] == false) {
    EXPECT_THAT(warnings, testing::Contains(testing::HasSubstr("target not met"))) << file;
  }
  const auto is_passed_through = testing::Contains(testing::HasSubstr("nothing to simplify"));
  if (has_no_faces(file)) {
    EXPECT_THAT(warnings, is_passed_through) << file;
    EXPECT_EQ(report["target"]["met"], true) << file;
  } else {
    EXPECT_THAT(warnings, testing::Not(is_passed_through)) << file;
  }
  return true;
}

/// A primitive that loses all its faces goes, so they are compared by `has_no_new_primitives`.
Json without_primitives(const Document& document) {
  Json json = without_geometry(document);
  for (Json& mesh : json.contains("meshes") ? json["meshes"] : json["none"]) mesh.erase("primitives");
  json.erase("none");
  return json;
}

/// Whether each mesh has some of the primitives that it had, in their order.
bool has_no_new_primitives(const Json& after, const Json& before) {
  if (!before.contains("meshes")) return !after.contains("meshes");
  for (std::size_t m = 0; m < before["meshes"].size(); ++m) {
    const Json& old = before["meshes"][m]["primitives"];
    std::size_t next = 0;
    for (const Json& primitive : after["meshes"][m]["primitives"]) {
      while (next < old.size() && old[next] != primitive) ++next;
      if (next++ == old.size()) return false;
    }
  }
  return true;
}

TEST(Assets, OfGltfKeepAllButTheirGeometry) {
  const std::vector<fs::path> files = files_of({"gltf-realistic", "gltf-tiny", "gltf-quirky"}, {".gltf", ".glb"});
  WHITTLE_NEEDS_ASSETS(files);
  const TemporaryFolder folder;
  Pairs pairs;
  for (const fs::path& file : files) {
    const Document before = load_document(file);
    for (const char* share : shares) {
      const fs::path out = pairs.add(file, file.extension().string());
      if (!simplify(file, out.string(), share)) {
        pairs.drop_last();
        break;
      }
      const Document after = load_document(out);
      EXPECT_EQ(without_primitives(after), without_primitives(before)) << file << ' ' << share;
      EXPECT_TRUE(has_no_new_primitives(without_geometry(after), without_geometry(before))) << file << ' ' << share;
    }
  }
  if (!has_validator()) GTEST_SKIP() << "there is no Node.js, or no gltf-validator in " WHITTLE_NODE_MODULES;
  EXPECT_TRUE(pairs.have_no_new_errors());
}

TEST(Assets, OfOtherFormatsAreSimplified) {
  const std::vector<fs::path> files = files_of({"obj", "ply"}, {".obj", ".ply"});
  WHITTLE_NEEDS_ASSETS(files);
  for (const fs::path& file : files) {
    const TemporaryFolder folder;
    for (const char* share : shares) {
      simplify(file, folder / ("out" + file.extension().string()), share);
      simplify(file, folder / "out.glb", share);
    }
  }
}

TEST(Assets, ThatAreDamagedAreRefusedInALine) {
  const std::vector<fs::path> files = files_of({"gltf-reject"}, {".gltf", ".glb"});
  WHITTLE_NEEDS_ASSETS(files);
  const TemporaryFolder folder;
  const std::vector<std::string> readable{"ass_texcoord_crash.gltf", "Mesh_NoPosition_01.gltf",
                                          "Mesh_PrimitiveRestart_08.gltf"};
  for (const fs::path& file : files) {
    const Outcome outcome = whittle({"simplify", file.string(), "-o", folder / "out.glb", "--face-ratio", "50%"});
    if (std::find(readable.begin(), readable.end(), file.filename()) == readable.end()) expect_refusal(outcome, file);
  }
}

}  // namespace
}  // namespace whittle::gltf::test
