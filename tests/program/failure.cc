#include "program/failure.hh"

#include <gtest/gtest.h>

#include <algorithm>

namespace whittle::test {

void expect_failure(const Outcome& outcome, int exit_code, const std::vector<std::string>& said) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome;
  EXPECT_EQ(outcome.out, "") << outcome;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome;
  EXPECT_EQ(outcome.err.rfind("whittle: ", 0), 0U) << outcome;
  for (const std::string& text : said) {
    EXPECT_NE(outcome.err.find(text), std::string::npos) << "not said: " << text << '\n' << outcome;
  }
}

}  // namespace whittle::test
