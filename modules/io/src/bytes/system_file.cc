#include "bytes/system_file.hh"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX  // MinGW's headers of C++ define it, too
#define NOMINMAX
#endif
#include <windows.h>
// After windows.h, which they need.
#include <io.h>
#include <process.h>
#else
#include <unistd.h>
#endif

namespace whittle::io {

namespace {

constexpr std::size_t largest_read = std::size_t{1} << 30;  // Linux and Windows read at most 2 GiB at once

}  // namespace

#ifdef _WIN32

InputDescriptor::InputDescriptor(const std::filesystem::path& path)
    : number_(::_wopen(path.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT)) {}

InputDescriptor::~InputDescriptor() {
  if (is_open()) ::_close(number_);
}

std::optional<std::size_t> InputDescriptor::size() const {
  struct _stat64 status {};
  if (::_fstat64(number_, &status) != 0 || (status.st_mode & _S_IFMT) != _S_IFREG) return std::nullopt;
  return static_cast<std::size_t>(status.st_size);
}

std::ptrdiff_t read_some(int descriptor, char* to, std::size_t size) {
  return ::_read(descriptor, to, static_cast<unsigned>(std::min(size, largest_read)));
}

std::string file_number(const std::filesystem::path& path) {
  const HANDLE file = ::CreateFileW(path.c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                                    OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);  // the flag is for folders
  if (file == INVALID_HANDLE_VALUE) return {};
  BY_HANDLE_FILE_INFORMATION of_file = {};
  const bool is_known = ::GetFileInformationByHandle(file, &of_file) != 0;
  ::CloseHandle(file);
  if (!is_known) return {};
  return std::to_string(of_file.dwVolumeSerialNumber) + ':' + std::to_string(of_file.nFileIndexHigh) + ':' +
         std::to_string(of_file.nFileIndexLow);
}

int process_number() { return ::_getpid(); }

#else

InputDescriptor::InputDescriptor(const std::filesystem::path& path)
    : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}

InputDescriptor::~InputDescriptor() {
  if (is_open()) ::close(number_);
}

std::optional<std::size_t> InputDescriptor::size() const {
  struct stat status {};
  if (::fstat(number_, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return static_cast<std::size_t>(status.st_size);
}

std::ptrdiff_t read_some(int descriptor, char* to, std::size_t size) {
  while (true) {
    const ssize_t got = ::read(descriptor, to, std::min(size, largest_read));
    if (got >= 0 || errno != EINTR) return got;
  }
}

std::string file_number(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return std::to_string(status.st_dev) + ':' + std::to_string(status.st_ino);
}

int process_number() { return ::getpid(); }

#endif

}  // namespace whittle::io
