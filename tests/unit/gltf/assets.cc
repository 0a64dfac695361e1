#include "assets.hh"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "codec/draco.hh"
#include "codec/meshopt.hh"
#include "document/glb.hh"
#include "document/uri.hh"

namespace whittle::gltf::test {
namespace {

/// The environment may name another folder than the build.
std::filesystem::path folder_of_assets() {
  const char* const folder = std::getenv("WHITTLE_TEST_ASSETS");
  return folder != nullptr ? folder : WHITTLE_TEST_ASSETS;
}

const std::filesystem::path assets = folder_of_assets();

Document make_document(std::string_view json, std::string_view chunk, const std::filesystem::path& folder) {
  Document document{Json::parse(json), {}};
  if (!document.json.contains("buffers")) return document;
  for (const Json& buffer : document.json["buffers"]) {
    std::string bytes(document.buffers.empty() ? chunk : std::string_view{});
    if (buffer.contains("uri")) {
      const auto uri = buffer["uri"].get<std::string>();
      bytes = is_data_uri(uri) ? decode_data_uri(uri).value() : bytes_of_file(folder / *file_of_uri(uri));
    }
    document.buffers.push_back(std::move(bytes));
  }
  return document;
}

/// What an accessor says and the bytes that it refers to, instead of its number.
void resolve_accessor(Json& number, const Document& document) {
  if (!number.is_number()) return;
  Json accessor = document.accessor(number.get<std::size_t>());
  if (accessor.contains("bufferView")) {
    accessor["bufferView"] = Json::binary({});
    const std::string bytes = document.view(document.accessor(number.get<std::size_t>())["bufferView"]);
    accessor["bufferView"] = std::hash<std::string>()(bytes);
  }
  number = std::move(accessor);
}

void strip_primitive(Json& primitive) {
  const auto names_of = [](Json& attributes) {
    for (auto& [name, number] : attributes.items()) number = nullptr;
  };
  if (primitive.value("mode", 4) < 4 || !primitive.contains("attributes")) return;
  names_of(primitive["attributes"]);
  if (primitive.contains("targets")) {
    for (Json& target : primitive["targets"]) names_of(target);
  }
  primitive.erase("indices");
  primitive.erase("mode");
  if (!primitive.contains("extensions")) return;
  primitive["extensions"].erase("KHR_draco_mesh_compression");
  if (primitive["extensions"].empty()) primitive.erase("extensions");
}

void strip_names(Json& document, const char* list) {
  if (!document.contains(list)) return;
  Json kept = Json::array();
  for (const Json& name : document[list]) {
    if (name != "KHR_draco_mesh_compression" && name != "EXT_meshopt_compression" && name != "KHR_mesh_quantization") {
      kept.push_back(name);
    }
  }
  document[list] = std::move(kept);
  if (document[list].empty()) document.erase(list);
}

void resolve_numbers(Json& json, const Document& document) {
  for (Json& image : json.contains("images") ? json["images"] : json["none"]) {
    if (!image.contains("bufferView")) continue;
    const std::string bytes = document.view(image["bufferView"]);
    image["bufferView"] = std::hash<std::string>()(bytes);
  }
  for (Json& animation : json.contains("animations") ? json["animations"] : json["none"]) {
    for (Json& sampler : animation["samplers"]) {
      resolve_accessor(sampler["input"], document);
      resolve_accessor(sampler["output"], document);
    }
  }
  for (Json& skin : json.contains("skins") ? json["skins"] : json["none"]) {
    if (skin.contains("inverseBindMatrices")) resolve_accessor(skin["inverseBindMatrices"], document);
  }
  for (Json& node : json.contains("nodes") ? json["nodes"] : json["none"]) {
    const Json::json_pointer attributes("/extensions/EXT_mesh_gpu_instancing/attributes");
    if (!node.contains(attributes)) continue;
    for (auto& [name, number] : node[attributes].items()) resolve_accessor(number, document);
  }
  json.erase("none");
}

bool can_read(const std::filesystem::path& file) {
  if (has_draco() && has_meshopt()) return true;
  const std::string bytes = bytes_of_file(file);
  return (has_draco() || bytes.find("KHR_draco_mesh_compression") == std::string::npos) &&
         (has_meshopt() || bytes.find("EXT_meshopt_compression") == std::string::npos);
}

}  // namespace

std::vector<std::filesystem::path> asset_files(const std::vector<std::string>& folders,
                                               const std::vector<std::string>& extensions) {
  std::vector<std::filesystem::path> files;
  for (const std::string& folder : folders) {
    if (!std::filesystem::is_directory(assets / folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(assets / folder)) {
      const std::string extension = entry.path().extension().string();
      const bool is_asked = std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
      if (is_asked && can_read(entry.path())) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string asset_name(const std::filesystem::path& file) { return file.lexically_relative(assets).generic_string(); }

std::filesystem::path asset_file(const std::string& name) { return assets / name; }

std::string bytes_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string Document::view(std::size_t number) const {
  const Json* range = &json.at("bufferViews").at(number);
  const Json::json_pointer compression("/extensions/EXT_meshopt_compression");
  if (range->contains(compression)) range = &(*range)[compression];
  return buffers.at((*range)["buffer"]).substr(range->value("byteOffset", std::size_t{0}), (*range)["byteLength"]);
}

Document load_document(const std::filesystem::path& file) {
  const std::string bytes = bytes_of_file(file);
  if (!bytes.starts_with(glb_magic)) return make_document(bytes, {}, file.parent_path());
  const GlbParts parts = split_glb(bytes, file.string());
  return make_document(parts.json, parts.buffer.value_or(""), file.parent_path());
}

Document load_glb(const std::string& bytes) {
  const GlbParts parts = split_glb(bytes, "output");
  return make_document(parts.json, parts.buffer.value_or(""), {});
}

Json without_geometry(const Document& document) {
  Json json = document.json;
  resolve_numbers(json, document);
  if (json.contains("meshes")) {
    for (Json& mesh : json["meshes"]) {
      if (!mesh.contains("primitives")) continue;
      for (Json& primitive : mesh["primitives"]) strip_primitive(primitive);
    }
  }
  for (const char* const name : {"accessors", "bufferViews", "buffers"}) json.erase(name);
  strip_names(json, "extensionsUsed");
  strip_names(json, "extensionsRequired");
  return json;
}

}  // namespace whittle::gltf::test
