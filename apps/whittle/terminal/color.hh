#pragma once

#include <string>

namespace whittle::app {

/// When standard error is in colour.
enum class ColorMode {
  automatic,  ///< on a terminal that isn't dumb (`TERM`), unless NO_COLOR is set and not empty: https://no-color.org
  always,
  never
};

/// Whether standard error is in colour.
bool is_colored(ColorMode mode);

enum class Color { red = 31, green = 32, yellow = 33 };

/// `text` in that colour, bold or not, on a terminal.
std::string in_color(Color color, const std::string& text);
std::string in_bold_color(Color color, const std::string& text);

}  // namespace whittle::app
