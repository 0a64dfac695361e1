// What is written, in the eyes of Khronos' validator (npm's package gltf-validator): it finds no error that the input
// doesn't have.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "assets.hh"
#include "validator.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf::test {
namespace {

/// Every third face, with its vertices and a table of wedges.
IndexedMesh thinned(const IndexedMesh& mesh) {
  IndexedMesh few = mesh;
  few.faces.clear();
  few.face_groups.clear();
  for (std::size_t f = 0; f < mesh.faces.size(); f += 3) {
    few.faces.push_back(mesh.faces[f]);
    few.face_groups.push_back(mesh.face_groups[f]);
  }
  return few;
}

void write_pairs(Pairs& pairs, const std::vector<std::string>& folders, const WriteOptions& options,
                 const std::string& extension) {
  for (const auto& file : asset_files(folders)) {
    // Its normals have a wrong type, so that their lengths are looked at only in the output.
    if (file.filename() == "mesh-sparse.gltf") continue;
    try {
      Asset asset = Asset::read(file);
      asset.write(pairs.add(file, extension), options);
      for (std::size_t m = 0; m < asset.n_meshes(); ++m) asset.set_triangles(m, asset.triangles(m));
      asset.write(pairs.add(file, extension), options);
      for (std::size_t m = 0; m < asset.n_meshes(); ++m) asset.set_triangles(m, thinned(asset.triangles(m)));
      asset.write(pairs.add(file, extension), options);
    } catch (const io::ReadError&) {
      continue;  // round_trip_test.cc knows which
    }
  }
}

TEST(GltfValidator, FindsNoNewErrorInBinaryFiles) {
  WHITTLE_NEEDS_ASSETS(asset_files({"gltf-tiny"}));
  if (!has_validator()) GTEST_SKIP() << "there is no Node.js, or no gltf-validator in " WHITTLE_NODE_MODULES;
  Pairs pairs;
  write_pairs(pairs, {"gltf-realistic", "gltf-tiny", "gltf-quirky"}, {}, ".glb");
  EXPECT_TRUE(pairs.have_no_new_errors());
}

TEST(GltfValidator, FindsNoNewErrorInCompressedFiles) {
  WHITTLE_NEEDS_CODECS();
  WHITTLE_NEEDS_ASSETS(asset_files({"gltf-tiny"}));
  if (!has_validator()) GTEST_SKIP() << "there is no Node.js, or no gltf-validator in " WHITTLE_NODE_MODULES;
  Pairs pairs;
  write_pairs(pairs, {"gltf-realistic", "gltf-tiny"}, {.compress = true}, ".glb");
  EXPECT_TRUE(pairs.have_no_new_errors());
}

TEST(GltfValidator, FindsNoNewErrorInQuantizedAndMergedFiles) {
  WHITTLE_NEEDS_CODECS();
  WHITTLE_NEEDS_ASSETS(asset_files({"gltf-tiny"}));
  if (!has_validator()) GTEST_SKIP() << "there is no Node.js, or no gltf-validator in " WHITTLE_NODE_MODULES;
  Pairs pairs;
  write_pairs(pairs, {"gltf-realistic", "gltf-tiny"}, {.quantize = true}, ".glb");
  write_pairs(pairs, {"gltf-tiny"}, {.compress = true, .quantize = true}, ".glb");
  write_pairs(pairs, {"gltf-realistic", "gltf-tiny"}, {.merge = true}, ".glb");
  write_pairs(pairs, {"gltf-tiny"}, {.quantize = true, .merge = true}, ".glb");
  EXPECT_TRUE(pairs.have_no_new_errors());
}

TEST(GltfValidator, FindsNoNewErrorInText) {
  WHITTLE_NEEDS_ASSETS(asset_files({"gltf-tiny"}));
  if (!has_validator()) GTEST_SKIP() << "there is no Node.js, or no gltf-validator in " WHITTLE_NODE_MODULES;
  Pairs pairs;
  write_pairs(pairs, {"gltf-tiny"}, {}, ".gltf");
  EXPECT_TRUE(pairs.have_no_new_errors());
}

}  // namespace
}  // namespace whittle::gltf::test
