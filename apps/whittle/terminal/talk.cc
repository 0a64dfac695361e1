#include "terminal/talk.hh"
#include "system/system.hh"

#include <iostream>
#include <string>

namespace whittle::app {
namespace {

/// Each line is one write, so that the lines of several programs on one terminal don't mix.
/// \param prefix text before the line; may have colours
void write_line(std::string prefix, std::string_view line) {
  // Keep it one line, even if a file name or an argument has control characters.
  for (const char c : line) prefix += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  prefix += '\n';
  std::cerr << prefix;
}

}  // namespace

void Talk::error(std::string_view line) const {
  write_line(colored_ ? in_bold_color(Color::red, "whittle:") + ' ' : "whittle: ", line);
}

void Talk::warning(std::string_view line) const {
  if (volume_ == Volume::quiet) return;
  write_line("whittle: " + (colored_ ? in_bold_color(Color::yellow, "warning:") : "warning:") + ' ', line);
}

void Talk::say(std::string_view line) const {
  if (volume_ != Volume::quiet) write_line("whittle: ", line);
}

void Talk::detail(std::string_view line) const {
  if (volume_ == Volume::verbose) write_line("whittle: ", line);
}

bool Talk::shows_progress() const { return volume_ != Volume::quiet && is_at_terminal(); }

}  // namespace whittle::app
