#include "formats.hh"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "whittle/io/path_of.hh"

namespace whittle {
namespace {

constexpr std::size_t n_mesh_formats = io::all_formats.size();

std::array<SceneFormat, n_mesh_formats> mesh_formats() {
  std::array<SceneFormat, n_mesh_formats> formats{};
  std::transform(io::all_formats.begin(), io::all_formats.end(), formats.begin(), format_with_one_mesh);
  return formats;
}

}  // namespace

std::span<const SceneFormat* const> scene_formats() {
  static const auto with_one_mesh = mesh_formats();
  static const auto all = [] {
    std::array<const SceneFormat*, n_mesh_formats + 1> rows{};
    std::transform(with_one_mesh.begin(), with_one_mesh.end(), rows.begin(), [](const auto& row) { return &row; });
    rows.back() = &gltf_format;
    return rows;
  }();
  return all;
}

const SceneFormat* format_by_extension(std::string_view extension) {
  std::string lower(extension);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const SceneFormat* format : scene_formats()) {
    const auto known = format->extensions;
    if (std::find(known.begin(), known.end(), lower) != known.end()) return format;
  }
  return nullptr;
}

const SceneFormat* format_by_name(const std::string& path) {
  const std::filesystem::path name = io::path_of(path);
  const bool is_packed = io::has_gzip_extension(name);
  const std::string extension = (is_packed ? name.stem() : name).extension().string();
  const SceneFormat* const format = extension.empty() ? nullptr : format_by_extension(extension.substr(1));
  return is_packed && format != nullptr && format->is_document ? nullptr : format;
}

const SceneFormat& format_of(io::Format format) { return *scene_formats()[static_cast<std::size_t>(format)]; }

}  // namespace whittle
