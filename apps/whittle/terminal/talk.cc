#include "terminal/talk.hh"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace whittle::app {
namespace {

/// Each line is one write, so that the lines of several programs on one terminal don't mix.
void write_line(std::string_view kind, std::string_view line) {
  std::string text = "whittle: ";
  text += kind;
  text += line;
  // Keep it one line, even if a file name or an argument has control characters.
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  text += '\n';
  std::cerr << text;
}

}  // namespace

void Talk::error(std::string_view line) const { write_line("", line); }

void Talk::warning(std::string_view line) const {
  if (volume_ != Volume::quiet) write_line("warning: ", line);
}

void Talk::say(std::string_view line) const {
  if (volume_ != Volume::quiet) write_line("", line);
}

void Talk::detail(std::string_view line) const {
  if (volume_ == Volume::verbose) write_line("", line);
}

bool Talk::shows_progress() const {
  if (volume_ == Volume::quiet || ::isatty(STDERR_FILENO) == 0) return false;
  const char* terminal = std::getenv("TERM");
  return terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace whittle::app
