#pragma once

#include <string>

#include "terminal/exit_code.hh"

namespace whittle::app {

/// Why a run ended, for the exit status and a line on stderr.
struct Failure {
  ExitCode code;
  std::string problem;  ///< names the file, if one is to blame
};

/// What the exception that is being handled means. \pre called in a catch block
/// \throw Interrupted again: that is no failure, it ends the program.
Failure current_failure();

}  // namespace whittle::app
