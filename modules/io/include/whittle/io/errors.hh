#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace whittle::io {

/// A file can't be opened, isn't supported or isn't valid. `what()` is one line: "file:line: problem" for text,
/// "file: byte 1234: problem" for binary data, "file: problem" otherwise.
class ReadError : public std::runtime_error {
 public:
  /// Place of the problem in the file. Empty for the whole file.
  struct Location {
    std::optional<std::uint64_t> line{};  ///< In text, from 1.
    std::optional<std::uint64_t> byte{};  ///< In binary data, from 0.
  };

  /// \param file name for the user. \param problem the problem and its remedy, without a full stop.
  ReadError(std::string file, Location location, const std::string& problem);
  ReadError(std::string file, const std::string& problem) : ReadError(std::move(file), Location{}, problem) {}

  const std::string& file() const { return file_; }
  std::optional<std::uint64_t> line() const { return location_.line; }
  std::optional<std::uint64_t> byte_offset() const { return location_.byte; }

 private:
  std::string file_;
  Location location_;
};

/// A file can't be written: no permission, no such folder, disk full. `what()` is one line, "file: problem".
class WriteError : public std::runtime_error {
 public:
  WriteError(std::string file, const std::string& problem);

  const std::string& file() const { return file_; }

 private:
  std::string file_;
};

/// Two outputs of a run would be the same file.
class OutputConflict : public WriteError {
 public:
  using WriteError::WriteError;
};

}  // namespace whittle::io
