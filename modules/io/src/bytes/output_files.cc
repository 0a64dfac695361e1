#include "whittle/io/output_files.hh"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <system_error>

#include "bytes/system_file.hh"
#include "whittle/io/path_of.hh"

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
  const std::filesystem::path file = path_of(path);
  if (std::string number = file_number(file); !number.empty()) return number;
  std::error_code error;
  const std::filesystem::path target = std::filesystem::absolute(OutputFile::target_of(file), error);
  return std::filesystem::weakly_canonical(target, error).string();
}

void OutputFiles::protect(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) protected_.insert(file_identity(file.string()));
}

bool OutputFiles::is_protected(const std::string& path) const { return protected_.contains(file_identity(path)); }

void OutputFiles::write(const std::string& path, const std::function<void(std::ostream&)>& fill) {
  if (is_protected(path)) throw WriteError(path, "an input needs this file");
  if (!written_.insert(file_identity(path)).second) {
    throw OutputConflict(path, "the run would write two files of this name; choose another name for one of them");
  }
  files_.push_back(std::make_unique<OutputFile>(path_of(path)));
  fill_checked(files_.back()->stream(), path, fill);
}

void OutputFiles::commit() {
  for (const auto& file : files_) file->commit();
  files_.clear();
  new_folders_.clear();
}

void OutputFiles::discard() {
  files_.clear();
  std::error_code ignored;
  for (const std::filesystem::path& folder : new_folders_) std::filesystem::remove(folder, ignored);
  new_folders_.clear();
}

void OutputFiles::make_folders(const std::filesystem::path& folder) {
  std::error_code error;  // that of writing says more
  std::vector<std::filesystem::path> missing;
  for (std::filesystem::path at = folder; !at.empty() && !std::filesystem::exists(at, error); at = at.parent_path()) {
    missing.push_back(at);
  }
  std::filesystem::create_directories(folder, error);
  new_folders_.insert(new_folders_.begin(), missing.begin(), missing.end());
}

bool OutputFiles::write_with_folders(const std::string& path, const std::string& bytes) {
  const std::string identity = file_identity(path);
  const std::size_t hash = std::hash<std::string>{}(bytes);
  const auto earlier = shared_.find(identity);
  if (earlier != shared_.end() && earlier->second == hash) return false;
  make_folders(path_of(path).parent_path());
  write(path, [&](std::ostream& out) { out << bytes; });
  shared_.emplace(identity, hash);
  return true;
}

}  // namespace whittle::io
