// Files that are no valid glTF: refused in one line, or read where that does no harm.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "assets.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Reads all triangles and writes them again.
void read_and_write(const std::string& bytes, const std::filesystem::path& folder = {}) {
  Asset asset = Asset::read(bytes, "input", folder);
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) asset.set_triangles(m, asset.triangles(m));
  asset.write_glb();
}

/// What the message says; empty if it is read.
std::string problem_in(const std::string& bytes, const std::filesystem::path& folder = {}) {
  try {
    read_and_write(bytes, folder);
  } catch (const io::ReadError& error) {
    return error.what();
  }
  return {};
}

TEST(GltfReject, SaysInOneLineWhatIsWrong) {
  const auto files = asset_files({"gltf-reject"});
  WHITTLE_NEEDS_ASSETS(files);
  // Those that may be read: all others are refused.
  const std::set<std::string> may_be_read = {"gltf-reject/ass_texcoord_crash.gltf",
                                             "gltf-reject/gagn_Mesh_NoPosition_01/Mesh_NoPosition_01.gltf",
                                             "gltf-reject/gagn_Mesh_PrimitiveRestart_08/Mesh_PrimitiveRestart_08.gltf"};
  for (const auto& file : files) {
    const std::string problem = problem_in(bytes_of_file(file), file.parent_path());
    EXPECT_EQ(problem.empty(), may_be_read.contains(asset_name(file))) << asset_name(file) << ": " << problem;
    EXPECT_THAT(problem, Not(HasSubstr("\n")));
  }
}

TEST(GltfReject, SaysWhatIsNoGltfAtAll) {
  for (const std::string bytes : {"glTX is no GLB", "\xEF\xBB\xBF [1]", "  ", "\x01"}) {
    EXPECT_THAT(problem_in(bytes), HasSubstr("is no glTF: it begins neither with \"glTF\"")) << bytes;
  }
  EXPECT_THAT(problem_in("\xEF\xBB\xBF {}"), HasSubstr("no \"asset\""));
  EXPECT_THAT(problem_in(R"({"asset": {"version": 1}})"), HasSubstr("glTF version 1; only 2.0"));
  EXPECT_THAT(problem_in(R"({"asset": {"version": "1.0"}})"), HasSubstr("glTF version 1.0; only 2.0"));
}

TEST(GltfReject, SaysWhereItIs) {
  const auto files = asset_files({"gltf-reject"});
  WHITTLE_NEEDS_ASSETS(files);
  const std::map<std::string, std::string> messages = {
      {"ass_IndexOutOfRange/IndexOutOfRange.gltf", "mesh 0 primitive 0: index "},
      {"gag_Compatibility_04/Compatibility_04.gltf", "needs glTF 2.1"},
      {"gag_Compatibility_05/Compatibility_05.gltf", "FAKE_materials_quantumRendering"},
      {"generated/accessor_past_bufferview.gltf", "accessor 1: its 81 values end after the 972 bytes of buffer view 1"},
      {"generated/huge_accessor_count.gltf", "accessor 0: its 2147483647 values"},
      {"generated/nan_inf_positions.gltf", "the position of vertex"},
      {"generated/unknown_required_extension.gltf", "ACME_secret_geometry"},
      {"val_empty_file.glb", "the file is empty"},
      {"val_length_mismatch.glb", "truncated"},
      {"val_truncated_chunk_data.glb", "truncated"},
      {"val_node_loop.gltf", "is its own descendant"}};
  for (const auto& [name, message] : messages) {
    const auto file = asset_file("gltf-reject/" + name);
    EXPECT_THAT(problem_in(bytes_of_file(file), file.parent_path()), HasSubstr(message)) << name;
  }
}

/// A document with a member more.
std::string with(const std::string& members) { return R"({"asset":{"version":"2.0"},)" + members + "}"; }

TEST(GltfReject, RefusesWhatWouldTakeTooMuchMemoryOrTime) {
  const std::string deep = with("\"extras\":" + std::string(100'000, '[') + std::string(100'000, ']'));
  EXPECT_THAT(problem_in(deep), HasSubstr("nested too deeply"));
  std::string names = "\"extras\":{";
  for (int i = 0; i < 100'000; ++i) names += '"' + std::to_string(i) + "\":0,";
  EXPECT_THAT(problem_in(with(names + "\"last\":0}")), HasSubstr("too many names"));
  const std::string zeros = R"("accessors":[{"componentType":5126,"count":1000000000000,"type":"VEC3"}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";
  EXPECT_THAT(problem_in(with(zeros)), HasSubstr("more values than the file has bytes"));
  const std::string indices = R"("accessors":[{"componentType":5126,"count":3,"type":"VEC3"},
      {"componentType":5125,"count":4000000000,"type":"SCALAR"}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])";
  EXPECT_THAT(problem_in(with(indices)), HasSubstr("more indices than the file has bytes"));
}

TEST(GltfReject, ReadsNoFilesFromElsewhere) {
  for (const std::string uri : {"http://localhost/a.bin", "file:///etc/passwd", "/etc/passwd"}) {
    EXPECT_THAT(problem_in(with(R"("buffers":[{"byteLength":4,"uri":")" + uri + "\"}]"), "/"),
                HasSubstr("not a file beside the asset"));
  }
  EXPECT_THAT(problem_in(with(R"("buffers":[{"byteLength":4,"uri":"a.bin"}])")), HasSubstr("\"a.bin\" is not there"));
}

TEST(GltfReject, TakesNoTrianglesThatDoNotFit) {
  const auto file = asset_file("gltf-tiny/generated/triangles_lines_points_mixed.gltf");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the test assets are not there";
  Asset asset = Asset::read(file);
  const IndexedMesh mesh = asset.triangles(0);
  IndexedMesh changed = mesh;
  changed.face_groups.back() = 1;  // lines
  EXPECT_THROW(asset.set_triangles(0, changed), std::invalid_argument);
  changed = mesh;
  changed.faces.back()[0] = 1'000'000;
  EXPECT_THROW(asset.set_triangles(0, changed), std::invalid_argument);
  changed = mesh;
  changed.normals.pop_back();
  EXPECT_THROW(asset.set_triangles(0, changed), std::invalid_argument);
  EXPECT_THROW(asset.set_triangles(1, mesh), std::out_of_range);
}

}  // namespace
}  // namespace whittle::gltf::test
