#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

// The calls of the system that the standard library has no words for, with one meaning on POSIX and on Windows. All set
// `errno` where they fail.

namespace whittle::io {

/// A file that is open for reading, as bytes.
class InputDescriptor {
 public:
  explicit InputDescriptor(const std::filesystem::path& path);
  ~InputDescriptor();
  InputDescriptor(const InputDescriptor&) = delete;
  InputDescriptor& operator=(const InputDescriptor&) = delete;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  /// The size of a regular file; empty for a pipe or a device.
  std::optional<std::size_t> size() const;

 private:
  int number_;
};

/// Reads at most `size` bytes. \return their number; 0 at the end, negative if reading fails
std::ptrdiff_t read_some(int descriptor, char* to, std::size_t size);

/// A text that is equal for two names of one file that exists, links to it among them; empty if it doesn't.
std::string file_number(const std::filesystem::path& path);

/// The number of this process: no other one that runs has it.
int process_number();

}  // namespace whittle::io
