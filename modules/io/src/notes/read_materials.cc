#include <fast_float/fast_float.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "bytes/words.hh"
#include "notes/material_libraries.hh"
#include "notes/mtl_textures.hh"
#include "notes/texture_lines.hh"
#include "whittle/io/materials.hh"
#include "whittle/io/whole_file.hh"

namespace whittle::io {
namespace {

namespace fs = std::filesystem;

/// A share, in [0, 1].
std::optional<double> take_share(std::string_view& text) {
  const std::string_view word = take_word(text);
  double value = 0;
  const auto [end, error] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !(value >= 0)) return std::nullopt;
  return std::min(value, 1.0);
}

/// `Kd r g b`. A grey may have one number.
void read_diffuse(std::string_view text, SurfaceMaterial& material) {
  const std::optional<double> red = take_share(text);
  if (!red) return;
  const std::optional<double> green = take_share(text);
  const std::optional<double> blue = take_share(text);
  material.diffuse = {*red, green.value_or(*red), blue.value_or(green.value_or(*red))};
}

void read_library(std::string_view text, const fs::path& folder, std::vector<SurfaceMaterial>& materials) {
  std::optional<SurfaceMaterial> current;
  const auto finish = [&] {
    if (!current) return;
    const auto has_its_name = [&](const SurfaceMaterial& other) { return other.name == current->name; };
    if (std::none_of(materials.begin(), materials.end(), has_its_name)) materials.push_back(*current);
  };
  for_each_mtl_line(text, [&](std::string_view line) {
    const std::string_view keyword = take_word(line);
    if (is_same_word(keyword, "newmtl")) {
      finish();
      current = SurfaceMaterial{.name = std::string(line), .texture = {}};
    }
    if (!current) return;
    if (is_same_word(keyword, "kd")) read_diffuse(line, *current);
    if (is_same_word(keyword, "d")) current->opacity = take_share(line).value_or(current->opacity);
    if (is_same_word(keyword, "map_kd")) {
      current->texture = (folder / with_slashes(texture_name(line))).lexically_normal();
    }
  });
  finish();
}

}  // namespace

SurfaceMaterials read_materials(const FileNotes& notes, const fs::path& folder) {
  SurfaceMaterials all;
  for (const std::string& line : notes.header_lines) {
    const std::string_view name = texture_of_line(line);
    if (!name.empty()) all.textures.push_back(fs::path(with_slashes(name)).lexically_normal());
  }
  for (const fs::path& library : material_libraries(notes)) {
    const std::optional<std::string> text = content_of(folder / library);
    if (text) {
      read_library(*text, library.parent_path(), all.materials);
    } else {
      all.missing.push_back(library);
    }
  }
  return all;
}

}  // namespace whittle::io
