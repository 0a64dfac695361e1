#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace whittle::io {

// Formats that Whittle knows by name but doesn't read: other mesh formats, archives, web pages, UTF-16. Naming them
// says more to users than "unknown".

/// The problem with a file of this extension, and its remedy. Empty for an unknown extension.
/// \param extension in lower case, without its dot.
std::optional<std::string> problem_of_foreign_extension(std::string_view extension);

/// The problem with a file of this content, and its remedy. Empty for unknown content.
std::optional<std::string> problem_of_foreign_content(std::string_view bytes);

/// "OBJ, OFF, PLY, STL or glTF": formats to advise. whittle/gltf reads and writes the last one.
std::string mesh_titles();

/// UTF-16 without the mark that files of it should begin with.
bool looks_like_utf16(std::string_view bytes);
inline constexpr std::string_view problem_of_utf16 = "the content is UTF-16 text; save it as UTF-8 or plain ASCII";

}  // namespace whittle::io
