#include "cli/report_keys/option_runs.hh"

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "program/gltf_cube.hh"
#include "whittle/pipeline/request.hh"

namespace whittle::test {
namespace {

using Arguments = std::vector<std::string>;

OptionValue value_of(const OptionRow& row) { return row.reported ? row.reported() : row.access.get(); }

/// Whether an option of a request takes a value and makes another of it than the default.
bool takes_as_new(const std::string& name, const std::string& value) {
  Request request;
  const OptionRows rows = option_rows(request);
  const OptionRow& row = *find_row(rows, name);
  const OptionValue before = value_of(row);
  try {
    row.access.set(value);
  } catch (const std::invalid_argument&) {
    return false;
  }
  return value_of(row) != before;
}

/// Values to try: the words that the help shows, and some of each kind.
std::vector<std::string> candidates_for(const OptionRow& row) {
  if (row.access.meta.empty()) return {""};
  std::vector<std::string> values;
  std::istringstream words(row.access.meta);
  for (std::string word; std::getline(words, word, '|');) values.push_back(word);
  for (const char* value : {"1", "0.5", "10%", "uv=2"}) values.emplace_back(value);
  std::erase_if(values, [&](const std::string& value) { return !takes_as_new(long_name(row), value); });
  return values;
}

/// The first of a few simple runs that takes the option; nothing if none does.
std::optional<OptionRun> run_with(const OptionRow& row, const TemporaryFolder& folder) {
  const std::string cubes = data_file("cubes.obj");
  const std::string cube = folder / "cube.glb";
  for (const std::string& value : candidates_for(row)) {
    for (const Arguments& more : {Arguments{cubes}, {cubes, "--cost", "quadric"}, {cube}}) {
      OptionRun run{long_name(row), value, more};
      run.arguments.insert(run.arguments.end(), {"-o", folder / "one.glb", run.name});
      if (!value.empty()) run.arguments.push_back(value);
      if (run.name != "--faces") run.arguments.insert(run.arguments.end(), {"--faces", "100"});
      Arguments call = run.arguments;
      call.insert(call.begin(), "simplify");
      if (whittle(call).exit_code == 0) return run;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<OptionRun> runs_with_options(const TemporaryFolder& folder) {
  write_gltf_cube(folder / "cube.glb", 4);
  std::vector<OptionRun> runs;
  Request request;
  for (const OptionRow& row : option_rows(request)) {
    if (row.names.empty()) continue;
    if (std::optional<OptionRun> run = run_with(row, folder)) runs.push_back(*std::move(run));
  }
  return runs;
}

}  // namespace whittle::test
