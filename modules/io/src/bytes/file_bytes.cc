#include "bytes/file_bytes.hh"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "whittle/io/read.hh"

namespace whittle::io {

namespace {

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail_reading(std::string_view name) {
  throw ReadError(std::string(name), std::string("cannot be read: ") + std::strerror(errno));
}

// Reads until `size` bytes are there or the file ends. Returns the number of bytes read.
std::size_t read_up_to(int descriptor, char* to, std::size_t size, std::string_view name) {
  constexpr std::size_t largest_read = std::size_t{1} << 30;  // Linux reads at most 2 GiB at once
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = ::read(descriptor, to + done, std::min(size - done, largest_read));
    if (got < 0 && errno == EINTR) continue;
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

FileBytes::FileBytes(const std::filesystem::path& path) {
  const std::string name = path.string();
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) throw ReadError(name, std::string("cannot be opened: ") + std::strerror(errno));
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) fail_reading(name);
  if (S_ISDIR(status.st_mode)) throw ReadError(name, "is a folder, not a mesh file");
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    const auto size = static_cast<std::size_t>(status.st_size);
    data_ = std::make_unique_for_overwrite<char[]>(size);
    size_ = read_up_to(file.number(), data_.get(), size, name);
    return;
  }
  // A pipe, or a file that doesn't know its size, such as those in /proc.
  const std::vector<char> bytes = read_all(file.number(), name);
  data_ = std::make_unique_for_overwrite<char[]>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), data_.get());
  size_ = bytes.size();
}

}  // namespace whittle::io
