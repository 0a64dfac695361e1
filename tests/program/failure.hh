#pragma once

#include <string>
#include <vector>

#include "program/program.hh"

namespace whittle::test {

/// Expects a run that failed: nothing on standard output, and one line on standard error that begins with "whittle: "
/// and says all of this.
void expect_failure(const Outcome& outcome, int exit_code, const std::vector<std::string>& said);

/// The same of a command line that is wrong: exit status 2.
inline void expect_usage_error(const Outcome& outcome, const std::vector<std::string>& said) {
  expect_failure(outcome, 2, said);
}

}  // namespace whittle::test
