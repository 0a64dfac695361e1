#pragma once

#include <string_view>

namespace whittle::io {

/// The texture that a line of a PLY header names: the text after "TextureFile", otherwise a last word with the
/// extension of a picture. Empty if it names none. \param line with its keyword, "comment" or "obj_info"
std::string_view texture_of_line(std::string_view line);

}  // namespace whittle::io
