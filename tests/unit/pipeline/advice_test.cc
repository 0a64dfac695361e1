#include <gtest/gtest.h>

#include "whittle/pipeline/run.hh"

namespace whittle::test {
namespace {

/// Warnings leave out what advice names. What it doesn't name they may not leave out.
TEST(Advice, NamesWhatItsTextNames) {
  const std::vector<std::string> options{"--weld auto", "--prune 1%", "--topology free"};
  const std::vector<Advice> all{{},
                                {{}, "", std::nullopt, true},
                                {{}, options[0], 7, true},
                                {{}, options[2], std::nullopt, true},
                                {{options[1]}, options[0], 7, true},
                                {{options[0], options[2]}, options[2], std::nullopt, true}};
  for (const Advice& advice : all) {
    const std::string text = to_string(advice);
    for (const std::string& option : options) {
      EXPECT_EQ(advice.names(option), text.find('\'' + option + '\'') != std::string::npos) << option << ": " << text;
    }
  }
}

}  // namespace
}  // namespace whittle::test
