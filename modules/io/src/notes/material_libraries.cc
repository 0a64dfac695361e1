#include "notes/material_libraries.hh"

#include <algorithm>
#include <string_view>

#include "bytes/words.hh"
#include "notes/mtl_textures.hh"

namespace whittle::io {
namespace {

bool ends_a_library_name(std::string_view word) {
  constexpr std::string_view extension = ".mtl";
  return word.size() >= extension.size() && is_same_word(word.substr(word.size() - extension.size()), extension);
}

/// The names after `mtllib`. A name with blanks ends with the first word that ends in ".mtl".
std::vector<std::string> library_names(std::string_view text) {
  std::vector<std::string> names;
  std::size_t first = text.find_first_not_of(blanks);
  for (std::size_t at = first; at != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    const std::size_t next = text.find_first_not_of(blanks, end);
    if (next == text.npos || ends_a_library_name(text.substr(at, end - at))) {
      names.emplace_back(text.substr(first, end - first));
      first = next;
    }
    at = next;
  }
  return names;
}

}  // namespace

std::vector<std::filesystem::path> material_libraries(const FileNotes& notes) {
  std::vector<std::filesystem::path> libraries;
  for (const std::string& line : notes.material_libraries) {
    for (const std::string& name : library_names(line)) {
      libraries.push_back(path_of_reference(name).lexically_normal());
    }
  }
  return libraries;
}

}  // namespace whittle::io
