#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace whittle {

/// An encoded image file.
struct Image {
  std::string name{};            ///< For messages: "image 3", "texture wall.png".
  std::filesystem::path file{};  ///< Relative to the folder of the file that names it. Empty: embedded in that file.
  std::string bytes{};           ///< Content of the file, in any format. Empty: it wasn't read.
  std::string problem{};         ///< Why reading failed, one line. Empty: it didn't, or the file wasn't read.
};

/// "image/png", "image/jpeg" or "image/webp", by the first bytes (glTF 2.0, section 3.8.3, and EXT_texture_webp). Empty
/// for other formats.
std::string_view media_type(std::string_view bytes);

}  // namespace whittle
