#include "whittle/io/errors.hh"

#include <utility>

namespace whittle::io {

namespace {

// One line even if a file name or a quoted token holds line breaks or control characters.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

std::string locate(const std::string& file, const ReadError::Place& place) {
  if (place.line) return file + ":" + std::to_string(*place.line) + ": ";
  if (place.byte) return file + ": byte " + std::to_string(*place.byte) + ": ";
  return file + ": ";
}

}  // namespace

ReadError::ReadError(std::string file, Place place, const std::string& problem)
    : std::runtime_error(one_line(locate(file, place) + problem)), file_(std::move(file)), place_(place) {}

WriteError::WriteError(std::string file, const std::string& problem)
    : std::runtime_error(one_line(file + ": " + problem)), file_(std::move(file)) {}

}  // namespace whittle::io
