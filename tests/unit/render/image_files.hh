#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// Image files for tests of the readers, by libpng and libjpeg.

namespace whittle::render {

enum class PngKind { gray, gray_alpha, rgb, rgba, palette };

struct PngSettings {
  PngKind kind = PngKind::rgb;
  int bits = 8;  ///< a channel
  unsigned width = 2;
  unsigned height = 1;
  bool is_interlaced = false;
  std::optional<double> gamma{};
};

/// The palette is (1, 2, 3), (7, 8, 9).
std::string png_file(const PngSettings& settings, std::vector<std::uint8_t> bytes);

/// The same file, with another width in its header.
std::string with_png_width(std::string file, std::uint32_t width);

/// A square. Four channels are CMYK, inverted as Adobe does.
std::string jpeg_file(unsigned width, int n_channels, bool is_progressive, std::vector<std::uint8_t> pixels);

}  // namespace whittle::render
