#include "files/output.hh"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>

#include "files/input.hh"
#include "terminal/errors.hh"
#include "terminal/interruption.hh"

namespace whittle::app {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& a, const std::string& b) {
  if (a == standard_stream || b == standard_stream) return a == b;
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  // Files that don't exist yet are compared by name.
  return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

void check_folder(const std::string& path) {
  std::error_code error;
  if (path == standard_stream || fs::exists(fs::status(path, error))) return;
  fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) folder = ".";
  if (!fs::is_directory(folder, error)) throw io::WriteError(path, "there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK) != 0) {
    throw io::WriteError(path, "can't write to its folder: " + std::string(std::strerror(errno)));
  }
}

/// Renaming the result would replace such a file all the same.
void refuse_write_protected(const Output& output) {
  std::error_code error;
  const fs::file_status status = fs::status(output.path, error);
  constexpr auto write = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if (output.path == standard_stream || !fs::is_regular_file(status) ||
      (status.permissions() & write) != fs::perms::none) {
    return;
  }
  throw io::WriteError(output.path, "is write-protected; --force lets it be replaced");
}

void refuse_same_place(const Output& a, const Output& b) {
  if (!is_same_file(a.path, b.path)) return;
  throw UsageError(a.option + ' ' + a.path + " doesn't go with " + b.option + ' ' + b.path +
                   ": only one can be written there");
}

void refuse_input(const Output& output, const std::string& input) {
  if (output.path == standard_stream || !is_same_file(output.path, input)) return;
  throw UsageError(output.option + ": " + output.path + " is an input too; --force lets it be replaced");
}

/// \pre `errno` was 0 before the stream was last used.
io::WriteError write_failure(const std::string& name) {
  return {name, "can't be written: " + std::string(errno != 0 ? std::strerror(errno) : "write error")};
}

/// Has `fill` write to a stream, and flushes it. \throw io::WriteError with the name of the file if either fails
void fill_checked(std::ostream& stream, const std::string& name, const std::function<void(std::ostream&)>& fill) {
  errno = 0;
  try {
    fill(stream);
  } catch (const io::WriteError& error) {
    if (!stream) throw write_failure(name);
    throw io::WriteError(name, std::string(error.what()).substr(error.file().size() + 2));
  }
  if (!stream.flush()) throw write_failure(name);
}

}  // namespace

void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs, bool force) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) refuse_same_place(outputs[i], outputs[j]);
    for (const std::string& input : inputs) {
      if (!force) refuse_input(outputs[i], input);
    }
    if (!force) refuse_write_protected(outputs[i]);
    check_folder(outputs[i].path);
  }
}

void OutputFiles::write(const std::string& path, const std::function<void(std::ostream&)>& fill) {
  if (path == standard_stream) return fill_checked(std::cout, standard_output_name, fill);
  if (!signals_wait_) signals_wait_.emplace();
  files_.push_back(std::make_unique<io::OutputFile>(path));
  fill_checked(files_.back()->stream(), path, fill);
}

void OutputFiles::commit() {
  SignalsWait::throw_if_pending();
  for (const auto& file : files_) file->commit();
  files_.clear();
  signals_wait_.reset();
}

void print(const std::string& text) {
  fill_checked(std::cout, standard_output_name, [&text](std::ostream& out) { out << text; });
}

}  // namespace whittle::app
