#pragma once

#include <filesystem>
#include <fstream>

#include "whittle/io/errors.hh"

namespace whittle::io {

/// A file that appears complete or not at all. It is written under a temporary name in the same folder; `commit`
/// renames it. Without `commit` (an exception, a cancelled run) nothing is left behind. A symbolic link is followed.
/// What exists and isn't a regular file (a device, a pipe) is written directly, as is all below /dev and /proc
/// (/dev/stdout), where writing begins at the end.
class OutputFile {
 public:
  /// \throw WriteError if the temporary file can't be made.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream() { return stream_; }
  /// Flushes, closes and renames. \throw WriteError if anything since opening failed. A full disk shows here at the
  /// latest.
  void commit();

 private:
  std::filesystem::path path_;       // As given, for messages.
  std::filesystem::path target_;     // With links followed.
  std::filesystem::path temporary_;  // Empty when written directly or committed.
  std::ofstream stream_;
};

}  // namespace whittle::io
