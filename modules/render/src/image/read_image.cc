#include <stdexcept>

#include "image/decoders.hh"

namespace whittle::render {

Texture read_image(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1A\n")) return read_png(bytes);
  if (bytes.starts_with("\xFF\xD8\xFF")) return read_jpeg(bytes);
  throw std::runtime_error("an image is neither PNG nor JPEG");
}

}  // namespace whittle::render
