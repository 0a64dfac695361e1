#include "whittle/io/errors.hh"

#include <utility>

namespace whittle::io {

namespace {

// File names and quoted tokens may contain line breaks and control characters.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

std::string locate(const std::string& file, const ReadError::Location& location) {
  if (location.line) return file + ":" + std::to_string(*location.line) + ": ";
  if (location.byte) return file + ": byte " + std::to_string(*location.byte) + ": ";
  return file + ": ";
}

}  // namespace

ReadError::ReadError(std::string file, Location location, const std::string& problem)
    : std::runtime_error(one_line(locate(file, location) + problem)), file_(std::move(file)), location_(location) {}

WriteError::WriteError(std::string file, const std::string& problem)
    : std::runtime_error(one_line(file + ": " + problem)), file_(std::move(file)) {}

}  // namespace whittle::io
