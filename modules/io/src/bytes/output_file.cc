#include "whittle/io/output_file.hh"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "bytes/system_file.hh"

namespace whittle::io {

namespace {

namespace fs = std::filesystem;

std::string system_message() { return std::strerror(errno); }

// Whether the name stands for something that is open already: /dev/stdout, /dev/fd/63, /proc/self/fd/1. Then even a
// regular file is not to be replaced by another.
bool is_open_already(const fs::path& path) {
  const std::string name = path.lexically_normal().string();
  return name.starts_with("/dev/") || name.starts_with("/proc/");
}

// Unlike std::filesystem::canonical, this also follows a link to a file that doesn't exist yet.
fs::path follow_links(fs::path path) {
  constexpr int most_links = 40;  // As on Linux. Links may form a circle.
  std::error_code ignored;
  for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(path, ignored)); ++i) {
    const fs::path to = fs::read_symlink(path, ignored);
    if (ignored) break;
    path = to.is_absolute() ? to : path.parent_path() / to;
  }
  return path;
}

}  // namespace

fs::path OutputFile::target_of(const fs::path& path) { return is_open_already(path) ? path : follow_links(path); }

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), target_(target_of(path_)) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target_, ignored);
  if (fs::is_directory(status)) throw WriteError(path_.string(), "is a folder");
  const bool direct = is_open_already(target_) || (fs::exists(status) && !fs::is_regular_file(status));
  fs::path opened = target_;
  if (!direct) {
    const std::string unique = '.' + std::to_string(process_number()) + ".tmp";
    opened = target_.parent_path() / ('.' + target_.filename().string() + unique);
  }
  errno = 0;
  stream_.open(opened, std::ios::binary | (direct ? std::ios::app : std::ios::trunc));
  if (!stream_) throw WriteError(path_.string(), "cannot be written: " + system_message());
  if (direct) return;
  temporary_ = opened;
  // A replaced file keeps its permissions. If that fails, the file is written all the same.
  if (fs::exists(status)) fs::permissions(temporary_, status.permissions(), ignored);
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
  errno = 0;
  stream_.close();
  if (!stream_) throw WriteError(path_.string(), "writing failed: " + (errno != 0 ? system_message() : "disk full?"));
  if (temporary_.empty()) return;
  std::error_code problem;
  fs::rename(temporary_, target_, problem);
  if (problem) throw WriteError(path_.string(), "cannot be replaced: " + problem.message());
  temporary_.clear();
}

}  // namespace whittle::io
