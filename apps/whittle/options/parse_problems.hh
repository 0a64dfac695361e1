#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace whittle::app {

/// The problem with a command line: names the option, and the option that was probably meant.
/// \param sub the subcommand that was called
std::string problem_of(const CLI::App& sub, const CLI::ParseError& error);

/// "; did you mean 'simplify'?" for the candidate that is likest to `word`, or nothing if none is like it.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace whittle::app
