#include "files/output.hh"

#include <filesystem>
#include <iostream>
#include <map>
#include <set>

#include "files/input.hh"
#include "system/system.hh"
#include "terminal/errors.hh"
#include "terminal/interruption.hh"
#include "whittle/io/path_of.hh"

namespace whittle::app {
namespace {

constexpr char number_word[] = "{i}";

namespace fs = std::filesystem;

std::string identity_of(const std::string& path) { return path == standard_stream ? path : io::file_identity(path); }

void check_folder(const std::string& path) {
  std::error_code error;
  if (path == standard_stream || fs::exists(io::path_of(path), error)) return;
  fs::path folder = io::path_of(path).parent_path();
  if (folder.empty()) folder = ".";
  if (!fs::is_directory(folder, error)) throw io::WriteError(path, "there is no folder " + folder.string());
  if (const std::string why = why_not_writable(folder.string()); !why.empty()) {
    throw io::WriteError(path, "can't write to its folder: " + why);
  }
}

/// Renaming the result would replace such a file all the same.
void refuse_write_protected(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(io::path_of(path), error);
  constexpr auto write = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if (path == standard_stream || !fs::is_regular_file(status) || (status.permissions() & write) != fs::perms::none) {
    return;
  }
  throw io::WriteError(path, "is write-protected; --force lets it be replaced");
}

void refuse_same_places(const std::vector<Output>& outputs) {
  std::map<std::string, const Output*> taken;
  for (const Output& output : outputs) {
    const auto [place, is_new] = taken.try_emplace(identity_of(output.path), &output);
    if (is_new) continue;
    throw UsageError(output.option + ' ' + output.path + " doesn't go with " + place->second->option + ' ' +
                     place->second->path + ": only one can be written there");
  }
}

void refuse_inputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs) {
  std::set<std::string> read;
  for (const std::string& input : inputs) read.insert(identity_of(input));
  for (const Output& output : outputs) {
    if (output.path == standard_stream || !read.contains(identity_of(output.path))) continue;
    throw UsageError(output.option + ": " + output.path + " is an input too; --force lets it be replaced");
  }
}

}  // namespace

std::string replaced(std::string path, const std::string& word, const std::string& text) {
  for (std::size_t at = 0; (at = path.find(word, at)) != std::string::npos; at += text.size()) {
    path.replace(at, word.size(), text);
  }
  return path;
}

void check_number(const std::string& output, const std::string& option, bool is_given) {
  const bool has_number = output.find(number_word) != std::string::npos;
  if (is_given && !has_number) {
    throw UsageError(option + " writes several files: --output needs '{i}' in it, such as 'frame_{i}.ply'");
  }
  if (!is_given && has_number) throw UsageError("'{i}' in --output is for " + option);
}

std::string numbered(const std::string& path, std::size_t i, std::size_t n) {
  const std::size_t width = std::to_string(n - 1).size();
  std::string number = std::to_string(i);
  number.insert(0, width - number.size(), '0');
  return replaced(path, number_word, number);
}

void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs, bool force) {
  refuse_same_places(outputs);
  if (!force) refuse_inputs(outputs, inputs);
  for (const Output& output : outputs) {
    if (!force) refuse_write_protected(output.path);
    check_folder(output.path);
  }
}

void OutputFiles::protect(const std::vector<fs::path>& files) {
  if (!force_) io::OutputFiles::protect(files);
}

void OutputFiles::write(const std::string& path, const std::function<void(std::ostream&)>& fill) {
  if (path == standard_stream) return io::fill_checked(std::cout, standard_output_name, fill);
  if (!force_) refuse_write_protected(path);
  if (is_protected(path)) throw UsageError(path + ": an input needs this file; --force lets it be replaced");
  if (!signals_wait_) signals_wait_.emplace();
  io::OutputFiles::write(path, fill);
}

void OutputFiles::commit() {
  SignalsWait::throw_if_pending();
  io::OutputFiles::commit();
  signals_wait_.reset();
}

void print(const std::string& text) {
  io::fill_checked(std::cout, standard_output_name, [&text](std::ostream& out) { out << text; });
}

}  // namespace whittle::app
