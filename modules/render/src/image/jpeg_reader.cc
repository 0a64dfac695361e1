// jpeglib.h uses std::size_t and FILE, and includes neither.
#include <cstddef>
#include <cstdio>
// (a line of its own: the order matters)
#include <jerror.h>
#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <stdexcept>
#include <string>
#include <vector>

#include "image/decoders.hh"

namespace whittle::render {

namespace {

/// libjpeg reports errors by a function that must not return: it jumps. The function that it leaves that way has no
/// objects to destroy; all that lives longer is here.
struct JpegReading {
  jpeg_error_mgr errors{};  // first: libjpeg knows its address
  std::jmp_buf jump{};
  jpeg_decompress_struct jpeg{};
  std::string problem;
  Pixels pixels;
  std::vector<JSAMPLE> row;

  JpegReading() = default;
  ~JpegReading() { jpeg_destroy_decompress(&jpeg); }
  JpegReading(const JpegReading&) = delete;
  JpegReading& operator=(const JpegReading&) = delete;
};

JpegReading& reading_of(j_common_ptr jpeg) { return *static_cast<JpegReading*>(jpeg->client_data); }

[[noreturn]] void leave(JpegReading& reading, const char* problem) {
  reading.problem = problem;
  std::longjmp(reading.jump, 1);
}

[[noreturn]] void leave_with_error(j_common_ptr jpeg) {
  std::array<char, JMSG_LENGTH_MAX> message{};
  jpeg->err->format_message(jpeg, message.data());
  leave(reading_of(jpeg), message.data());
}

/// libjpeg goes on when the file ends early, with grey.
void take_message(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  const int code = jpeg->err->msg_code;
  if (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER) leave(reading_of(jpeg), "the file is truncated or damaged");
}

void start(JpegReading& reading) {
  reading.jpeg.err = jpeg_std_error(&reading.errors);
  reading.errors.error_exit = leave_with_error;
  reading.errors.emit_message = take_message;
  reading.jpeg.client_data = &reading;
}

/// Adobe's CMYK, as all files have it, is inverted: 255 is no ink.
void put_pixel(const JSAMPLE* from, bool is_cmyk, std::uint8_t* to) {
  for (std::size_t i = 0; i < 3; ++i) {
    to[i] = is_cmyk ? static_cast<std::uint8_t>((from[i] * from[3] + 127) / 255) : static_cast<std::uint8_t>(from[i]);
  }
  to[3] = 255;
}

void take_row(JpegReading& reading, std::size_t y) {
  Pixels& pixels = reading.pixels;
  const bool is_cmyk = reading.jpeg.out_color_space == JCS_CMYK;
  const std::size_t n_channels = is_cmyk ? 4 : 3;
  for (std::size_t x = 0; x < pixels.width; ++x) {
    put_pixel(&reading.row[n_channels * x], is_cmyk, &pixels.rgba[4 * (pixels.width * y + x)]);
  }
}

/// \return false after an error
bool begin_decoding(JpegReading& reading, std::string_view bytes) {
  if (setjmp(reading.jump) != 0) return false;
  jpeg_decompress_struct& jpeg = reading.jpeg;
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  if (jpeg.image_width > max_image_size || jpeg.image_height > max_image_size) {
    leave(reading, "it has more than 16384 pixels a side");
  }
  const bool has_four_channels = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
  jpeg.out_color_space = has_four_channels ? JCS_CMYK : JCS_RGB;
  jpeg.dct_method = JDCT_ISLOW;
  jpeg_start_decompress(&jpeg);
  return true;
}

bool decode_row(JpegReading& reading) {
  if (setjmp(reading.jump) != 0) return false;
  JSAMPROW row = reading.row.data();
  jpeg_read_scanlines(&reading.jpeg, &row, 1);
  return true;
}

bool decode_rows(JpegReading& reading) {
  Pixels& pixels = reading.pixels;
  pixels.width = reading.jpeg.output_width;
  pixels.height = reading.jpeg.output_height;
  pixels.rgba.resize(4 * pixels.width * pixels.height);
  reading.row.resize(4 * pixels.width);
  for (std::size_t y = 0; y < pixels.height; ++y) {
    if (!decode_row(reading)) return false;
    take_row(reading, y);
  }
  return true;
}

}  // namespace

Pixels read_jpeg(std::string_view bytes) {
  JpegReading reading;
  start(reading);
  if (!begin_decoding(reading, bytes) || !decode_rows(reading)) {
    throw std::runtime_error("a JPEG image can't be read: " + reading.problem);
  }
  return std::move(reading.pixels);
}

}  // namespace whittle::render
