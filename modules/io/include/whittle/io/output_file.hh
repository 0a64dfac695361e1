#pragma once

#include <filesystem>
#include <fstream>

#include "whittle/io/errors.hh"

namespace whittle::io {

/// A file that appears complete or not at all: written beside its place under a temporary name, renamed by `commit`.
/// Not committed (an exception, a cancelled run), it leaves nothing behind. A symbolic link is followed; what exists
/// and isn't a regular file (a device, a pipe) is written directly.
class OutputFile {
 public:
  /// \throw WriteError if the temporary file can't be made.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream() { return stream_; }
  /// Flushes, closes and renames. \throw WriteError if anything since opening failed (a full disk shows here at last).
  void commit();

 private:
  std::filesystem::path path_;       // as given, for messages
  std::filesystem::path target_;     // with links followed
  std::filesystem::path temporary_;  // empty when written directly or committed
  std::ofstream stream_;
};

}  // namespace whittle::io
