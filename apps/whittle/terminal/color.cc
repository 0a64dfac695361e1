#include "terminal/color.hh"

#include <cstdlib>

#include "system/system.hh"

namespace whittle::app {
namespace {

/// Text between the escape sequence with these numbers and the one that ends its effect.
std::string between_escapes(const std::string& numbers, const std::string& text) {
  return "\x1b[" + numbers + 'm' + text + "\x1b[0m";
}

bool is_without_color() {
  const char* value = std::getenv("NO_COLOR");
  return value != nullptr && *value != '\0';
}

}  // namespace

bool is_colored(ColorMode mode) {
  if (mode == ColorMode::automatic) return is_at_terminal() && !is_without_color();
  return mode == ColorMode::always;
}

std::string in_color(Color color, const std::string& text) {
  return between_escapes(std::to_string(static_cast<int>(color)), text);
}

std::string in_bold_color(Color color, const std::string& text) {
  return between_escapes("1;" + std::to_string(static_cast<int>(color)), text);
}

}  // namespace whittle::app
