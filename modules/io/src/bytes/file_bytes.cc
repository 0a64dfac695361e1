#include "bytes/file_bytes.hh"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "bytes/system_file.hh"
#include "whittle/io/read.hh"

namespace whittle::io {

namespace {

[[noreturn]] void fail_reading(std::string_view name) {
  throw ReadError(std::string(name), std::string("cannot be read: ") + std::strerror(errno));
}

// Reads until `size` bytes are there or the file ends. Returns the number of bytes read.
std::size_t read_up_to(int descriptor, char* to, std::size_t size, std::string_view name) {
  std::size_t done = 0;
  while (done < size) {
    const std::ptrdiff_t got = read_some(descriptor, to + done, size - done);
    if (got < 0) fail_reading(name);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace

std::vector<char> read_all(int descriptor, std::string_view name) {
  std::vector<char> bytes(std::size_t{1} << 20);
  std::size_t done = 0;
  while (true) {
    done += read_up_to(descriptor, bytes.data() + done, bytes.size() - done, name);
    if (done < bytes.size()) break;
    bytes.resize(2 * bytes.size());
  }
  bytes.resize(done);
  return bytes;
}

void refuse_what_is_no_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status)) throw ReadError(path.string(), "is a folder, not a mesh file");
  if (error) throw ReadError(path.string(), "cannot be opened: " + std::string(std::strerror(error.value())));
}

FileBytes::FileBytes(const std::filesystem::path& path) {
  const std::string name = path.string();
  refuse_what_is_no_file(path);
  const InputDescriptor file(path);
  if (!file.is_open()) throw ReadError(name, std::string("cannot be opened: ") + std::strerror(errno));
  if (const std::size_t size = file.size().value_or(0); size > 0) {
    bytes_.resize(size);
    bytes_.resize(read_up_to(file.number(), bytes_.data(), size, name));
    return;
  }
  // A pipe, or a file without a known size, as in /proc.
  const std::vector<char> bytes = read_all(file.number(), name);
  bytes_.assign(bytes.begin(), bytes.end());
}

}  // namespace whittle::io
