#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands/simplify/simplify_options.hh"
#include "terminal/exit_code.hh"

// One call of `whittle simplify` for several inputs: each is a run of its own, with the same options.

namespace whittle::app {

/// Placeholder for the input's name, without folder and extensions, in OUT and in files such as --map's.
inline constexpr std::string_view stem_word = "{stem}";

/// \throw UsageError where an input looks like the value of -v: older programs have -v N, a number of vertices.
void refuse_count_of_verbose(const SimplifyCommand& command);

/// Whether OUT has `{stem}`.
bool is_named_by_stem(const SimplifyCommand& command);

/// A run for each input. \throw UsageError if there are several and OUT or --map lacks `{stem}`, if an input has no
/// name to put there, or if two would be written to one file.
std::vector<SimplifyCommand> runs_of(const SimplifyCommand& command);

/// Does a run. \param report becomes its report; null if none is wanted
using SimplifyRun = std::function<ExitCode(const SimplifyCommand& run, nlohmann::ordered_json* report)>;

/// Does all runs, one after another. A failure is printed, and the next run begins. Writes one report for --json:
/// `runs` has the report of each, or its failure.
/// \return the exit status of the first run that failed
/// \throw Interrupted; files of earlier runs stay
ExitCode run_each(const SimplifyCommand& command, const std::vector<SimplifyCommand>& runs,
                  const SimplifyRun& simplify);

}  // namespace whittle::app
