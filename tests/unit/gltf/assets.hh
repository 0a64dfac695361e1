#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "codec/draco.hh"
#include "codec/meshopt.hh"
#include "document/json.hh"

namespace whittle::gltf::test {

/// All files with some extensions in folders of the test assets, such as "gltf-tiny", but for those that this build
/// can't decompress. Empty where there are no assets.
std::vector<std::filesystem::path> asset_files(const std::vector<std::string>& folders,
                                               const std::vector<std::string>& extensions = {".gltf", ".glb"});

/// Of a file, relative to the assets.
std::string asset_name(const std::filesystem::path& file);

std::filesystem::path asset_file(const std::string& name);

std::string bytes_of_file(const std::filesystem::path& file);

/// A document and the bytes of its buffers. Compressed data stay as they are.
struct Document {
  Json json;
  std::vector<std::string> buffers;

  /// The bytes of a view; of a compressed one, the compressed ones.
  std::string view(std::size_t number) const;
  const Json& accessor(std::size_t number) const { return json.at("accessors").at(number); }
};

Document load_document(const std::filesystem::path& file);
Document load_glb(const std::string& bytes);

/// The document without accessors, views, buffers, and what replacing triangles changes in primitives. What images,
/// skins, animations and instances refer to is in it as bytes.
Json without_geometry(const Document& document);

/// Tests that need the assets say so, and are skipped, where these are absent.
#define WHITTLE_NEEDS_ASSETS(files) \
  if ((files).empty()) GTEST_SKIP() << "the test assets are not there: " << WHITTLE_TEST_ASSETS

/// Likewise tests that compress or decompress.
#define WHITTLE_NEEDS_CODECS() \
  if (!has_draco() || !has_meshopt()) GTEST_SKIP() << "this build has no Draco, or no meshoptimizer"

}  // namespace whittle::gltf::test
