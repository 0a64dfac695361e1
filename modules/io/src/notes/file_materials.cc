// Statements of MTL are "KEYWORD ARGUMENT...", one a line ("MTL material format", Lightscape, 1995).
#include <fast_float/fast_float.h>

#include <algorithm>
#include <string_view>

#include "bytes/words.hh"
#include "notes/material_libraries.hh"
#include "notes/mtl_textures.hh"
#include "notes/texture_lines.hh"
#include "whittle/io/materials.hh"

namespace whittle::io {
namespace {

namespace fs = std::filesystem;

/// In [0, 1]; `otherwise` where there is no number.
double take_share(std::string_view& text, double otherwise) {
  const std::string_view word = take_word(text);
  double value = 0;
  const auto [end, error] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && value >= 0 ? std::min(value, 1.0) : otherwise;
}

void read_statement(std::string_view line, const MaterialLibrary& library, std::vector<FileMaterial>& materials) {
  std::string_view rest = line;
  const std::string_view keyword = take_word(rest);
  if (is_same_word(keyword, "newmtl")) materials.emplace_back().name = rest;
  if (materials.empty()) return;
  FileMaterial& material = materials.back();
  if (is_same_word(keyword, "kd")) {
    material.diffuse[0] = take_share(rest, 1);
    for (const std::size_t d : {1U, 2U}) material.diffuse[d] = take_share(rest, material.diffuse[0]);
  }
  if (is_same_word(keyword, "d")) material.opacity = take_share(rest, 1);
  if (is_same_word(keyword, "map_kd")) {
    const std::string_view name = name_of_texture(line);
    if (!name.empty()) material.texture = library.texture(name);
  }
}

void read_library(const MaterialLibrary& library, std::vector<FileMaterial>& all) {
  std::vector<FileMaterial> materials;
  std::string_view text = library.text;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    read_statement(trimmed(text.substr(0, end)), library, materials);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  for (FileMaterial& material : materials) {
    const bool is_black = *std::max_element(material.diffuse.begin(), material.diffuse.end()) == 0;
    if (is_black && !material.texture.empty()) material.diffuse = {1, 1, 1};
    all.push_back(std::move(material));
  }
}

}  // namespace

std::vector<FileMaterial> file_materials(const FileNotes& notes, const fs::path& folder) {
  std::vector<FileMaterial> materials;
  for (const MaterialLibrary& library : material_libraries(notes, folder)) read_library(library, materials);
  if (!materials.empty()) return materials;
  for (const std::string& line : notes.header_lines) {
    const std::string_view name = texture_of_line(line);
    if (name.empty()) continue;
    materials.emplace_back().texture = fs::path(with_slashes(name)).lexically_normal();
    break;
  }
  return materials;
}

}  // namespace whittle::io
