#include "whittle/io/whole_file.hh"

#include <cerrno>
#include <cstring>
#include <iterator>
#include <system_error>

#include "whittle/io/errors.hh"

namespace whittle::io {

std::ifstream open_file(const std::filesystem::path& path, const std::string& what) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status)) throw ReadError(what, "is a folder, not a file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReadError(what, std::string("cannot be opened: ") + std::strerror(errno));
  return file;
}

std::string read_file(const std::filesystem::path& path, const std::string& what) {
  std::ifstream file = open_file(path, what);
  std::string bytes;
  std::error_code error;
  if (const auto size = std::filesystem::file_size(path, error); !error && size > 0) {
    bytes.resize(size);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
  } else {
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  if (file.bad()) throw ReadError(what, "cannot be read");
  return bytes;
}

std::optional<std::string> content_of(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  try {
    return read_file(path, path.string());
  } catch (const ReadError&) {
    return std::nullopt;
  }
}

}  // namespace whittle::io
