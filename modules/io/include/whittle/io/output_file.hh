#pragma once

#include <filesystem>
#include <fstream>

#include "whittle/io/errors.hh"

namespace whittle::io {

/// A file that appears complete or not at all. It is written under a temporary name in the same folder; `commit`
/// renames it. Without `commit` (an exception, a cancelled run) nothing is left behind. A symbolic link is followed.
/// Existing files that aren't regular (devices, pipes) are written directly, and so are files below /dev and /proc
/// (/dev/stdout), where writing begins at the end.
class OutputFile {
 public:
  /// \throw WriteError if the temporary file can't be made.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// The file that a path stands for, with links followed even where nothing is there yet.
  static std::filesystem::path target_of(const std::filesystem::path& path);

  std::ostream& stream() { return stream_; }
  /// Flushes, closes and renames.
  /// \throw WriteError if anything failed since opening; a full disk is detected here at the latest.
  void commit();

 private:
  std::filesystem::path path_;       // As given, for messages.
  std::filesystem::path target_;     // With links followed.
  std::filesystem::path temporary_;  // Empty when written directly or committed.
  std::ofstream stream_;
};

}  // namespace whittle::io
