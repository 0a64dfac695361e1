#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace whittle::io {

/// The name of a texture in a statement. \param text what follows the keyword: options and the name
std::string_view texture_of_statement(std::string_view text);

/// The names of textures in a material library (MTL), as they stand there, but without options (`-o 0 0 0`, `-bm 1`…).
/// Each comes once.
std::vector<std::string> mtl_textures(std::string_view text);

/// A name with "/" between folders, whatever it has: "materials\\images\\a.png" becomes "materials/images/a.png".
std::string with_slashes(std::string_view name);

}  // namespace whittle::io
