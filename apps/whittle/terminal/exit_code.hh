#pragma once

namespace whittle::app {

/// The exit status. These numbers are documented and don't change. An interrupted run ends with 128 + the signal's
/// number, which is 130 for Ctrl-C.
enum class ExitCode {
  done = 0,
  failure = 1,         ///< disk full, out of memory, a bug of the program
  usage = 2,           ///< the command line is wrong
  target_not_met = 3,  ///< under --strict
  unreadable = 4       ///< the input is missing, unsupported or invalid
};

}  // namespace whittle::app
