#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "bench/processes/clock.hh"

// What both benchmarks take on their command lines.

namespace whittle::bench {

/// How often who is timed, and by which clock.
struct Rounds {
  Clock clock = Clock::wall;
  int n = 5;
  double slow_s = 5;     ///< who takes longer is timed once, in the first run
  double limit_s = 300;  ///< who takes longer is stopped
};

/// Where the rows go, and what they say of the sources.
struct RowsFile {
  std::string csv;
  std::string commit = "unknown";
};

/// \param who "peers" or "programs"
void add_options(CLI::App& app, Rounds& rounds, const std::string& who);
void add_options(CLI::App& app, RowsFile& rows);

/// Reads the command line, then calls `run`, whose exit status it returns: 1 after an exception, 2 if the command line
/// is wrong.
int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& run);

}  // namespace whittle::bench
