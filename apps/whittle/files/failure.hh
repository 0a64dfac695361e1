#pragma once

#include <string>

#include "terminal/exit_code.hh"

namespace whittle::app {

/// Why a run ended, for the exit status and a line on stderr.
struct Failure {
  ExitCode code;
  std::string problem;  ///< names the file, if one is to blame
};

/// The failure of the exception being handled.
/// \pre called in a catch block
/// \throw Interrupted again: it is no failure, but ends the program.
Failure current_failure();

}  // namespace whittle::app
