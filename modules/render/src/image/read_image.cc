#include <stdexcept>

#include "image/decoders.hh"
#include "whittle/core/material/image.hh"

namespace whittle::render {

Pixels read_image(std::string_view bytes) {
  const std::string_view type = media_type(bytes);
  if (type == "image/png") return read_png(bytes);
  if (type == "image/jpeg") return read_jpeg(bytes);
  throw std::runtime_error("an image is neither PNG nor JPEG");
}

}  // namespace whittle::render
