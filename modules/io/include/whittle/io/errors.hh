#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace whittle::io {

/// A file that can't be opened, isn't supported or isn't valid. `what()` is one line without a line break:
/// "file:line: problem" for text, "file: byte 1234: problem" for binary data, "file: problem" otherwise.
class ReadError : public std::runtime_error {
 public:
  /// Where in the file the problem lies: a line (from 1) of text, or a byte (from 0) of binary data, or neither.
  struct Place {
    std::optional<std::uint64_t> line{};
    std::optional<std::uint64_t> byte{};
  };

  /// \param file name shown to the user. \param problem what is wrong and what to do, no full stop.
  ReadError(std::string file, Place place, const std::string& problem);
  ReadError(std::string file, const std::string& problem) : ReadError(std::move(file), Place{}, problem) {}

  const std::string& file() const { return file_; }
  std::optional<std::uint64_t> line() const { return place_.line; }
  std::optional<std::uint64_t> byte_offset() const { return place_.byte; }

 private:
  std::string file_;
  Place place_;
};

/// A file that can't be written: no permission, no such folder, disk full. `what()` is one line, "file: problem".
class WriteError : public std::runtime_error {
 public:
  WriteError(std::string file, const std::string& problem);

  const std::string& file() const { return file_; }

 private:
  std::string file_;
};

}  // namespace whittle::io
