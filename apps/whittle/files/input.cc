#include "files/input.hh"

#include <unistd.h>

#include <algorithm>
#include <utility>

#include "terminal/stopwatch.hh"

namespace whittle::app {
namespace {

std::string needs_format() { return "'-' needs --format: one of " + io::format_names(); }

}  // namespace

std::optional<io::Format> format_by_name(const std::string& path) {
  try {
    return io::format_of(path);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

io::Format format_for_output(const std::string& path, std::optional<io::Format> given) {
  if (const std::optional<io::Format> by_name = format_by_name(path)) return *by_name;
  if (given) return *given;
  if (path == standard_stream) throw UsageError(needs_format());
  try {
    return io::format_of(path);
  } catch (const std::invalid_argument& error) {
    throw UsageError(path + ": " + error.what());
  }
}

void check_inputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                  std::optional<io::Format> given) {
  const auto n_standard = std::count(inputs.begin(), inputs.end(), standard_stream);
  if (n_standard > 1) throw UsageError("only one of the inputs can be standard input ('-')");
  if (n_standard == 1 && !given) throw UsageError(needs_format());
  const auto is_told = [](const std::string& path) { return format_by_name(path).has_value(); };
  if (given && std::all_of(inputs.begin(), inputs.end(), is_told) &&
      std::all_of(outputs.begin(), outputs.end(), is_told)) {
    throw UsageError("--format is for '-' and for names that don't tell the format; here every name does");
  }
}

MeshFile::MeshFile(std::string path, std::optional<io::Format> given) : path_(std::move(path)) {
  if (!format_by_name(path_)) format_ = given;
  if (path_ == standard_stream) standard_input_ = io::read_all(STDIN_FILENO, standard_input_name);
}

io::ReadResult MeshFile::read(bool weld) const {
  const io::ReadOptions options{.weld = weld, .format = format_};
  if (path_ == standard_stream) return io::read_mesh(standard_input_, standard_input_name, options);
  return io::read_mesh(path_, options);
}

std::string about(const std::string& name, const std::string& text) { return name + ": " + text; }

Input read_input(const std::string& path, const InputOptions& options, const Talk& talk) {
  const Stopwatch watch;
  const MeshFile file(path, options.format);
  const std::string name = file.name();
  Input input{path, name, file.read(options.weld), {}};
  input.seconds = watch.seconds();
  if (input.read.repairs.any()) talk.say(name + ": " + io::to_string(input.read.repairs));
  for (const std::string& warning : input.read.warnings) {
    input.warnings.push_back(about(name, warning));
    talk.warning(input.warnings.back());
  }
  talk.detail(name + ": read " + std::to_string(input.read.mesh.positions.size()) + " vertices, " +
              std::to_string(input.read.mesh.faces.size()) + " faces");
  return input;
}

}  // namespace whittle::app
