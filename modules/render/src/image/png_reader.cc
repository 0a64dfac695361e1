#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <stdexcept>
#include <string>
#include <vector>

#include "image/decoders.hh"

namespace whittle::render {

namespace {

/// libpng reports errors by a long jump. The functions that it may leave that way have no objects to destroy; all that
/// lives longer is here.
struct PngReading {
  std::string_view bytes;  ///< not read yet
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string problem;
  Pixels pixels;
  std::vector<png_bytep> rows;

  explicit PngReading(std::string_view all) : bytes(all) {}
  ~PngReading() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReading(const PngReading&) = delete;
  PngReading& operator=(const PngReading&) = delete;
};

[[noreturn]] void note_error(png_structp png, png_const_charp message) {
  static_cast<PngReading*>(png_get_error_ptr(png))->problem = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

void give_bytes(png_structp png, png_bytep to, std::size_t n) {
  std::string_view& bytes = static_cast<PngReading*>(png_get_io_ptr(png))->bytes;
  if (n > bytes.size()) png_error(png, "the file is truncated");
  std::copy_n(bytes.data(), n, reinterpret_cast<char*>(to));
  bytes.remove_prefix(n);
}

/// \return false after an error
bool read_size(PngReading& reading) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) return false;
  png_set_user_limits(reading.png, max_image_size, max_image_size);
  png_set_read_fn(reading.png, &reading, give_bytes);
  png_read_info(reading.png, reading.info);
  png_set_expand(reading.png);  // palettes, fewer than 8 bits, a transparent colour
  png_set_scale_16(reading.png);
  png_set_gray_to_rgb(reading.png);
  png_set_add_alpha(reading.png, 255, PNG_FILLER_AFTER);
  png_set_interlace_handling(reading.png);
  png_read_update_info(reading.png, reading.info);
  reading.pixels.width = png_get_image_width(reading.png, reading.info);
  reading.pixels.height = png_get_image_height(reading.png, reading.info);
  if (png_get_rowbytes(reading.png, reading.info) != 4 * reading.pixels.width) {
    png_error(reading.png, "its pixels have an unknown format");
  }
  return true;
}

bool read_pixels(PngReading& reading) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) return false;
  png_read_image(reading.png, reading.rows.data());
  png_read_end(reading.png, nullptr);
  return true;
}

void make_room(PngReading& reading) {
  Pixels& pixels = reading.pixels;
  pixels.rgba.resize(4 * pixels.width * pixels.height);
  reading.rows.resize(pixels.height);
  for (std::size_t y = 0; y < pixels.height; ++y) reading.rows[y] = pixels.rgba.data() + 4 * pixels.width * y;
}

}  // namespace

Pixels read_png(std::string_view bytes) {
  PngReading reading(bytes);
  reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, note_error, ignore_warning);
  if (reading.png != nullptr) reading.info = png_create_info_struct(reading.png);
  if (reading.info == nullptr) throw std::runtime_error("a PNG image can't be read: libpng doesn't start");
  bool is_read = read_size(reading);
  if (is_read) {
    make_room(reading);
    is_read = read_pixels(reading);
  }
  if (!is_read) throw std::runtime_error("a PNG image can't be read: " + reading.problem);
  return std::move(reading.pixels);
}

}  // namespace whittle::render
