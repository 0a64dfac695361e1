#include "notes/mtl_materials.hh"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cstddef>
#include <optional>

#include "bytes/words.hh"
#include "notes/mtl_textures.hh"

namespace whittle::io {
namespace {

/// A number in [0, 1].
std::optional<float> take_share(std::string_view& text) {
  const std::string_view word = take_word(text);
  float value = 0;
  const auto [end, error] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !(value == value)) return std::nullopt;
  return std::clamp(value, 0.0F, 1.0F);
}

/// Three numbers, or one that stands for all.
void read_color(std::string_view text, Color& color) {
  const std::optional<float> red = take_share(text);
  if (!red) return;
  const std::optional<float> green = take_share(text);
  const std::optional<float> blue = take_share(text);
  color[0] = *red;
  color[1] = green.value_or(*red);
  color[2] = blue.value_or(*red);
}

void read_statement(std::string_view keyword, std::string_view text, MtlMaterial& material) {
  if (is_same_word(keyword, "kd")) read_color(text, material.color);
  if (is_same_word(keyword, "map_kd")) material.texture = texture_of_statement(text);
  if (is_same_word(keyword, "d")) material.color[3] = take_share(text).value_or(material.color[3]);
  if (is_same_word(keyword, "tr")) material.color[3] = 1 - take_share(text).value_or(1 - material.color[3]);
}

}  // namespace

std::vector<MtlMaterial> mtl_materials(std::string_view text) {
  std::vector<MtlMaterial> materials;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string_view keyword = take_word(line);
    if (is_same_word(keyword, "newmtl")) {
      materials.push_back({.name = std::string(line)});
    } else if (!materials.empty()) {
      read_statement(keyword, line, materials.back());
    }
  }
  return materials;
}

}  // namespace whittle::io
