// A statement of a texture is "KEYWORD [OPTION ARGUMENT...]... NAME", on one line. Names may have blanks ("MTL material
// format", Lightscape, 1995).
#include "notes/mtl_textures.hh"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "bytes/words.hh"
#include "whittle/io/path_of.hh"

namespace whittle::io {
namespace {

bool is_texture_keyword(std::string_view word) {
  constexpr std::string_view others[] = {"bump", "disp", "decal", "refl", "norm"};
  if (word.size() > 4 && is_same_word(word.substr(0, 4), "map_")) return !is_same_word(word, "map_aat");
  return std::any_of(std::begin(others), std::end(others), [&](auto other) { return is_same_word(word, other); });
}

bool is_number(std::string_view word) {
  double value = 0;
  const auto [end, error] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size();
}

/// Removes numbers, up to `most`.
void skip_numbers(std::string_view& text, int most) {
  for (int i = 0; i < most; ++i) {
    std::string_view rest = text;
    if (!is_number(take_word(rest)) || rest.empty()) return;
    text = rest;
  }
}

/// Removes the options before a name.
void skip_options(std::string_view& text) {
  struct Option {
    std::string_view name;
    int most_numbers;
    int words;
  };
  constexpr Option options[] = {{"-o", 3, 0},      {"-s", 3, 0},         {"-t", 3, 0},      {"-mm", 2, 0},
                                {"-bm", 1, 0},     {"-boost", 1, 0},     {"-texres", 1, 0}, {"-blendu", 0, 1},
                                {"-blendv", 0, 1}, {"-clamp", 0, 1},     {"-cc", 0, 1},     {"-imfchan", 0, 1},
                                {"-type", 0, 1},   {"-colorspace", 0, 1}};
  while (text.starts_with('-')) {
    std::string_view rest = text;
    const std::string_view word = take_word(rest);
    const auto* const option = std::find_if(std::begin(options), std::end(options),
                                            [&](const Option& o) { return is_same_word(word, o.name); });
    if (option == std::end(options)) return;
    text = rest;
    skip_numbers(text, option->most_numbers);
    for (int i = 0; i < option->words; ++i) take_word(text);
  }
}

}  // namespace

std::vector<std::string> mtl_textures(std::string_view text) {
  std::vector<std::string> names;
  for_each_mtl_line(text, [&](std::string_view line) {
    if (!is_texture_keyword(take_word(line))) return;
    const std::string_view name = texture_name(line);
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
  });
  return names;
}

std::string_view texture_name(std::string_view text) {
  skip_options(text);
  return text;
}

std::filesystem::path path_of_reference(std::string_view name) {
  std::string path;
  for (const char c : name) {
    const bool is_separator = c == '\\' || c == '/';
    if (!is_separator) path += c;
    if (is_separator && !(path.size() > 1 && path.back() == '/')) path += '/';
  }
  return path_of(path);
}

}  // namespace whittle::io
