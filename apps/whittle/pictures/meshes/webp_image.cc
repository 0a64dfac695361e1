#include "pictures/meshes/webp_image.hh"

#ifdef WHITTLE_WEBP
#include <webp/decode.h>
#endif

namespace whittle::app {

#ifdef WHITTLE_WEBP

std::optional<render::Pixels> read_webp(const std::string& bytes) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  int width = 0;
  int height = 0;
  if (WebPGetInfo(data, bytes.size(), &width, &height) == 0) return std::nullopt;
  render::Pixels pixels{static_cast<std::size_t>(width), static_cast<std::size_t>(height), {}};
  pixels.rgba.resize(4 * pixels.width * pixels.height);
  if (WebPDecodeRGBAInto(data, bytes.size(), pixels.rgba.data(), pixels.rgba.size(), 4 * width) == nullptr) {
    return std::nullopt;
  }
  return pixels;
}

#else

std::optional<render::Pixels> read_webp(const std::string&) { return std::nullopt; }

#endif

}  // namespace whittle::app
