#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

namespace whittle::io {

/// A whole file in memory. It is read, not mapped: if another program shortened a mapped file, access to it would end
/// the process.
class FileBytes {
 public:
  /// \throw ReadError if the file can't be opened or read.
  explicit FileBytes(const std::filesystem::path& path);

  std::string_view view() const { return {data_.get(), size_}; }

 private:
  std::unique_ptr<char[]> data_;
  std::size_t size_ = 0;
};

}  // namespace whittle::io
