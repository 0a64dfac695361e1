#pragma once

#include <string>
#include <vector>

#include "program/program.hh"

namespace whittle::test {

/// A run of `simplify` that an option was given to, with another value than its default.
struct OptionRun {
  std::string name;
  std::string value;                   ///< empty for a flag
  std::vector<std::string> arguments;  ///< after the subcommand's name
};

/// A simple run for each option of a request, where there is one.
std::vector<OptionRun> runs_with_options(const TemporaryFolder& folder);

}  // namespace whittle::test
