#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "whittle/core/detail/large_array.hh"

namespace whittle::io {

/// \throw ReadError for a folder, and where there is nothing
void refuse_what_is_no_file(const std::filesystem::path& path);

/// A whole file in memory. It is read, not mapped: if another program shortened a mapped file, access to it would end
/// the process.
class FileBytes {
 public:
  /// \throw ReadError if the file can't be opened or read.
  explicit FileBytes(const std::filesystem::path& path);

  std::string_view view() const { return {bytes_.data(), bytes_.size()}; }

 private:
  LargeArray<char> bytes_;
};

}  // namespace whittle::io
