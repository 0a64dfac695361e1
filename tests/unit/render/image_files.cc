#include "unit/render/image_files.hh"

// jpeglib.h uses FILE, and doesn't include what has it.
#include <cstdio>
// (a block of its own: the order matters)
#include <jpeglib.h>
#include <png.h>
#include <zlib.h>

#include <array>
#include <cstdlib>

namespace whittle::render {

namespace {

int png_color_type(PngKind kind) {
  switch (kind) {
    case PngKind::gray:
      return PNG_COLOR_TYPE_GRAY;
    case PngKind::gray_alpha:
      return PNG_COLOR_TYPE_GRAY_ALPHA;
    case PngKind::rgba:
      return PNG_COLOR_TYPE_RGB_ALPHA;
    case PngKind::palette:
      return PNG_COLOR_TYPE_PALETTE;
    case PngKind::rgb:
      break;
  }
  return PNG_COLOR_TYPE_RGB;
}

void append(png_structp png, png_bytep bytes, std::size_t n) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), n);
}

}  // namespace

std::string png_file(const PngSettings& settings, std::vector<std::uint8_t> bytes) {
  std::string file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &file, append, nullptr);
  png_set_IHDR(png, info, settings.width, settings.height, settings.bits, png_color_type(settings.kind),
               settings.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  const std::array<png_color, 2> palette = {{{1, 2, 3}, {7, 8, 9}}};
  if (settings.kind == PngKind::palette) png_set_PLTE(png, info, palette.data(), 2);
  if (settings.gamma) png_set_gAMA(png, info, *settings.gamma);
  png_write_info(png, info);
  std::vector<png_bytep> rows;
  for (unsigned y = 0; y < settings.height; ++y) rows.push_back(bytes.data() + y * (bytes.size() / settings.height));
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return file;
}

std::string with_png_width(std::string file, std::uint32_t width) {
  const auto put = [&](std::size_t place, std::uint32_t number) {
    for (std::size_t i = 0; i < 4; ++i) file[place + i] = static_cast<char>(number >> (24 - 8 * i));
  };
  put(16, width);
  put(29, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(file.data() + 12), 17)));
  return file;
}

std::string jpeg_file(unsigned width, int n_channels, bool is_progressive, std::vector<std::uint8_t> pixels) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long n_bytes = 0;
  jpeg_mem_dest(&jpeg, &bytes, &n_bytes);
  jpeg.image_width = width;
  jpeg.image_height = width;
  jpeg.input_components = n_channels;
  jpeg.in_color_space = n_channels == 1 ? JCS_GRAYSCALE : n_channels == 3 ? JCS_RGB : JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 95, TRUE);
  if (is_progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  for (unsigned y = 0; y < width; ++y) {
    JSAMPROW row = pixels.data() + y * width * static_cast<unsigned>(n_channels);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string file(reinterpret_cast<const char*>(bytes), n_bytes);
  std::free(bytes);
  return file;
}

}  // namespace whittle::render
