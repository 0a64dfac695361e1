#include "commands/simplify/simplify_runs.hh"

#include <filesystem>
#include <map>
#include <utility>

#include "files/failure.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "terminal/errors.hh"
#include "whittle/io/path_of.hh"

namespace whittle::app {
namespace {

bool has_stem(const std::string& path) { return path.find(stem_word) != std::string::npos; }

/// "mesh" of "folder/mesh.ply.gz"
std::string stem_of(const std::string& input) {
  if (input == standard_stream) throw UsageError("'-' has no name to put for '{stem}' in the name of a file");
  const std::filesystem::path name = io::path_of(input).filename();
  return (io::has_gzip_extension(name) ? name.stem() : name).stem().string();
}

/// Puts the name of IN for '{stem}' in OUT and in the files beside it.
void name_by_stem(SimplifyCommand& run) {
  const auto name = [&run](std::string& path) {
    if (has_stem(path)) path = replaced(std::move(path), std::string(stem_word), stem_of(run.input));
  };
  name(run.output);
  for (const SideFile& file : side_files(run)) {
    if (*file.path) name(**file.path);
  }
}

/// \throw UsageError
void refuse_stems_of_joined(SimplifyCommand& command) {
  const auto refuse = [](const std::string& option) {
    throw UsageError("--join makes one mesh of all IN: '{stem}' in " + option + " is for several");
  };
  if (is_named_by_stem(command)) refuse("--output");
  for (const SideFile& file : side_files(command)) {
    if (*file.path && has_stem(**file.path)) refuse(file.option);
  }
}

void check_stems(SimplifyCommand command) {
  if (command.joins) refuse_stems_of_joined(command);
  if (command.inputs.size() == 1 || command.joins) return;
  if (!is_named_by_stem(command)) {
    throw UsageError("one argument too many: '" + command.inputs[1] +
                     "'; several inputs need '{stem}' in --output, such as 'out/{stem}.ply', or --join");
  }
  for (const SideFile& file : side_files(command)) {
    if (!*file.path || has_stem(**file.path)) continue;
    throw UsageError(std::string(file.option) + ": several inputs make several " + file.plural +
                     "; its file needs '{stem}' in its name, too");
  }
}

/// \throw UsageError naming two inputs that would be written to one file
void refuse_same_outputs(const std::vector<SimplifyCommand>& runs) {
  std::map<std::string, std::string> input_of;
  for (const SimplifyCommand& run : runs) {
    const auto [other, is_new] = input_of.try_emplace(run.output, run.input);
    if (!is_new) {
      throw UsageError(other->second + " and " + run.input + " would both be written to " + run.output);
    }
  }
}

/// Does a run, and catches its failure. \param report as `SimplifyRun`; for a failed run it has the reason
ExitCode attempt(const SimplifyCommand& run, const SimplifyRun& simplify, Json* report) {
  try {
    return simplify(run, report);
  } catch (...) {
    const Failure failure = current_failure();
    run.common.talk().error(failure.problem);
    if (report != nullptr) {
      *report = new_report();
      (*report)["input"] = {{"path", run.input}};
      (*report)["error"] = failure.problem;
    }
    return failure.code;
  }
}

[[noreturn]] void refuse_count(const std::string& count) {
  throw UsageError("one argument too many: '" + count + "'; -v takes no value and says more, '--vertices " + count +
                   "' is a number of vertices to keep");
}

}  // namespace

void refuse_count_of_verbose(const SimplifyCommand& command) {
  const bool may_be_file = command.files.format != nullptr || command.files.input_format != nullptr;
  if (!command.common.verbose || may_be_file) return;
  for (const std::string& input : command.inputs) {
    if (!input.empty() && input.find_first_not_of("0123456789") == std::string::npos) refuse_count(input);
  }
}

bool is_named_by_stem(const SimplifyCommand& command) { return has_stem(command.output); }

std::vector<SimplifyCommand> runs_of(const SimplifyCommand& command) {
  check_stems(command);
  std::vector<SimplifyCommand> runs(command.joins ? 1 : command.inputs.size(), command);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    SimplifyCommand& run = runs[i];
    run.input = command.inputs[i];
    name_by_stem(run);
  }
  refuse_same_outputs(runs);
  return runs;
}

ExitCode run_each(const SimplifyCommand& command, const std::vector<SimplifyCommand>& runs,
                  const SimplifyRun& simplify) {
  ExitCode first_failure = ExitCode::done;
  Json json = new_report();
  json["runs"] = Json::array();
  for (const SimplifyCommand& run : runs) {
    Json report;
    const ExitCode code = attempt(run, simplify, command.common.json ? &report : nullptr);
    if (first_failure == ExitCode::done) first_failure = code;
    report["exit_status"] = static_cast<int>(code);
    json["runs"].push_back(std::move(report));
  }
  write_report(command.common, [&json] { return json; });
  return first_failure;
}

}  // namespace whittle::app
