#include "whittle/io/output_files.hh"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <system_error>

namespace whittle::io {
namespace {

/// \pre `errno` was 0 before the stream was last used.
WriteError write_failure(const std::string& name) {
  return {name, "can't be written: " + std::string(errno != 0 ? std::strerror(errno) : "write error")};
}

}  // namespace

void fill_checked(std::ostream& stream, const std::string& name, const std::function<void(std::ostream&)>& fill) {
  errno = 0;
  try {
    fill(stream);
  } catch (const WriteError& error) {
    if (!stream) throw write_failure(name);
    throw WriteError(name, std::string(error.what()).substr(error.file().size() + 2));
  }
  if (!stream.flush()) throw write_failure(name);
}

std::string file_identity(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {
    return std::to_string(status.st_dev) + ':' + std::to_string(status.st_ino);
  }
  std::error_code error;
  return std::filesystem::weakly_canonical(path, error).string();
}

void OutputFiles::protect(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) protected_.insert(file_identity(file.string()));
}

bool OutputFiles::is_protected(const std::string& path) const { return protected_.contains(file_identity(path)); }

void OutputFiles::write(const std::string& path, const std::function<void(std::ostream&)>& fill) {
  if (is_protected(path)) throw WriteError(path, "an input needs this file");
  files_.push_back(std::make_unique<OutputFile>(path));
  paths_.insert(path);
  fill_checked(files_.back()->stream(), path, fill);
}

void OutputFiles::commit() {
  for (const auto& file : files_) file->commit();
  files_.clear();
}

void OutputFiles::write_with_folders(const std::string& path, const std::string& bytes) {
  if (has(path)) return;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;  // that of writing says more
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  write(path, [&](std::ostream& out) { out << bytes; });
}

}  // namespace whittle::io
