#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "bench/processes/clock.hh"

// The command line options that both benchmarks share.

namespace whittle::bench {

/// How often each program is timed, and by which clock.
struct Rounds {
  Clock clock = Clock::wall;
  int n = 5;
  double slow_s = 5;     ///< a peer that takes longer is timed only once, in the first run
  double limit_s = 300;  ///< a peer that takes longer is stopped
};

/// Where the rows are written, and which source versions they name.
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
