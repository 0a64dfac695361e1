#include <png.h>

#include <algorithm>
#include <stdexcept>

#include "whittle/render/picture.hh"
#include "whittle/render/srgb.hh"

namespace whittle::render {

namespace {

std::vector<std::uint8_t> bytes_of(const Picture& picture) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * picture.pixels.size());
  for (const Rgb& pixel : picture.pixels) {
    for (const float value : pixel) bytes.push_back(to_8_bits(value));
  }
  return bytes;
}

}  // namespace

Picture side_by_side(const std::vector<Picture>& pictures) {
  Picture row;
  for (const Picture& picture : pictures) {
    if (picture.height != pictures.front().height) throw std::invalid_argument("pictures differ in height");
    row.height = picture.height;
    row.width += picture.width;
  }
  row.pixels.reserve(row.width * row.height);
  for (std::size_t y = 0; y < row.height; ++y) {
    for (const Picture& picture : pictures) {
      const auto begin = picture.pixels.begin() + static_cast<std::ptrdiff_t>(y * picture.width);
      row.pixels.insert(row.pixels.end(), begin, begin + static_cast<std::ptrdiff_t>(picture.width));
    }
  }
  return row;
}

std::string write_png(const Picture& picture) {
  if (picture.pixels.empty() || picture.pixels.size() != picture.width * picture.height) {
    throw std::invalid_argument("a picture to write has no pixels, or fewer than its size says");
  }
  const std::vector<std::uint8_t> bytes = bytes_of(picture);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(size, '\0');
  if (png_image_write_to_memory(&image, file.data(), &size, 0, bytes.data(), 0, nullptr) == 0) {
    const std::string problem = image.message;
    png_image_free(&image);
    throw std::runtime_error("a picture can't be stored as PNG: " + problem);
  }
  file.resize(size);
  return file;
}

}  // namespace whittle::render
