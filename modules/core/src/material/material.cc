#include "whittle/core/material/material.hh"

namespace whittle {

std::string_view media_type(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1A\n")) return "image/png";
  if (bytes.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
  return bytes.starts_with("RIFF") && bytes.size() >= 12 && bytes.substr(8).starts_with("WEBP") ? "image/webp" : "";
}

std::array<double, 4> base_color_factor(const Material& material) {
  const bool is_hidden = material.base_color_texture && !material.base_color_texture->is_tinted;
  return is_hidden ? std::array<double, 4>{1, 1, 1, material.base_color[3]} : material.base_color;
}

}  // namespace whittle
