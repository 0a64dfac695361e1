#include "notes/texture_lines.hh"

#include <algorithm>
#include <iterator>

#include "bytes/words.hh"

namespace whittle::io {
namespace {

bool is_picture(std::string_view word) {
  constexpr std::string_view extensions[] = {"png", "jpg",  "jpeg", "tga", "bmp", "tif", "tiff",
                                             "gif", "webp", "dds",  "exr", "hdr", "ktx2"};
  const std::size_t dot = word.rfind('.');
  if (dot == word.npos || dot == 0) return false;
  return std::any_of(std::begin(extensions), std::end(extensions),
                     [&](std::string_view extension) { return is_same_word(word.substr(dot + 1), extension); });
}

}  // namespace

std::string_view texture_of_line(std::string_view line) {
  take_word(line);
  const std::string_view text = line;
  std::string_view rest = text;
  const std::string_view first = take_word(rest);
  if (is_same_word(first, "texturefile") || is_same_word(first, "texturefile:")) return rest;
  const std::string_view last = text.substr(std::min(text.find_last_of(blanks) + 1, text.size()));
  return is_picture(last) ? last : std::string_view{};
}

}  // namespace whittle::io
