#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace whittle {

/// An image file, as it is encoded.
struct Image {
  std::string name{};            ///< For messages: "image 3", "texture wall.png".
  std::filesystem::path file{};  ///< Relative to the folder of the file that names it. Empty: it is part of that file.
  std::string bytes{};           ///< Of the whole file, in whatever format. Empty: it wasn't read.
  std::string problem{};         ///< Why it can't be read, one line. Empty: it can, or nobody tried.
};

/// "image/png", "image/jpeg" or "image/webp", by the first bytes, as glTF 2.0 (section 3.8.3) and EXT_texture_webp tell
/// them. Empty for all else.
std::string_view media_type(std::string_view bytes);

}  // namespace whittle
