#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace whittle::bench {

/// What a whole process took, as the system reports it.
struct ProcessRun {
  double wall_s = 0;
  double cpu_s = 0;     ///< user and system
  std::string failure;  ///< how it ended; empty for status 0
};

/// Runs a program and waits for it.
/// \param command the program, looked up in PATH, and its arguments
/// \param log takes its output
/// \param limit_s seconds after which it is ended
ProcessRun run_process(const std::vector<std::string>& command, const std::filesystem::path& log, double limit_s);

}  // namespace whittle::bench
