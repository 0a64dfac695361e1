#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bytes/words.hh"

namespace whittle::io {

/// The names of textures in a material library (MTL), as they stand there, but without options (`-o 0 0 0`, `-bm 1`…).
/// Each comes once.
std::vector<std::string> mtl_textures(std::string_view text);

/// The lines of a material library, without the blanks around them.
template <class Visitor>
void for_each_mtl_line(std::string_view text, const Visitor& visit) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    visit(trimmed(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// The name of the texture that follows a keyword such as `map_Kd`, without options. \param text after the keyword
std::string_view texture_name(std::string_view text);

/// The path of a name that has "\\" or "/" between folders: "materials\\images\\a.png" is "materials/images/a.png".
std::filesystem::path path_of_reference(std::string_view name);

}  // namespace whittle::io
