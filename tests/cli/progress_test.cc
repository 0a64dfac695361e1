// The progress bar: shown on a terminal only, erased at the end, without colour if NO_COLOR is set.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program/program.hh"
#include "program/terminal.hh"

namespace whittle::test {
namespace {

/// What a run writes to a terminal.
std::string seen_on_terminal(const std::vector<std::string>& more,
                             const std::map<std::string, std::string>& environment, unsigned short columns = 80) {
  const TemporaryFolder folder;
  Terminal terminal(columns);
  std::vector<std::string> arguments{"simplify", data_file("knot.ply"), "-o", folder / "out.ply", "--ratio", "0.1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  RunOptions options;
  options.stderr_to = terminal.descriptor();
  options.environment = environment;
  const Outcome outcome = whittle(arguments, options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.out, "");
  return terminal.read_all();
}

bool has_bar(const std::string& seen) { return seen.find("decimating") != std::string::npos; }
bool has_color(const std::string& seen) { return seen.find('\x1b') != std::string::npos; }

TEST(ProgressBar, IsDrawnOnATerminalAndGoneInTheEnd) {
  const std::string seen = seen_on_terminal({}, {{"TERM", "xterm"}, {"NO_COLOR", ""}});
  EXPECT_TRUE(has_bar(seen)) << seen;
  EXPECT_TRUE(has_color(seen)) << seen;
  // The summary begins on a line that was erased.
  const std::size_t wiped = seen.rfind(" \r");
  ASSERT_NE(wiped, std::string::npos) << seen;
  EXPECT_EQ(seen.compare(wiped + 2, 9, "whittle: "), 0) << seen;
}

TEST(ProgressBar, IsPlainWhereNoColorIsSet) {
  const std::string seen = seen_on_terminal({}, {{"TERM", "xterm"}, {"NO_COLOR", "1"}});
  EXPECT_TRUE(has_bar(seen)) << seen;
  EXPECT_FALSE(has_color(seen)) << seen;
}

TEST(ProgressBar, IsNotDrawnWhereItWouldOnlyMakeAMess) {
  EXPECT_FALSE(has_bar(seen_on_terminal({}, {{"TERM", "dumb"}})));
  EXPECT_FALSE(has_bar(seen_on_terminal({}, {{"TERM", "xterm"}}, 40))) << "a bar wider than the window wraps";
  EXPECT_EQ(seen_on_terminal({"--quiet"}, {{"TERM", "xterm"}}), "");
}

TEST(ProgressBar, IsNotWrittenToAFile) {
  const TemporaryFolder folder;
  RunOptions options;
  options.environment = {{"TERM", "xterm"}};
  const Outcome outcome =
      whittle({"simplify", data_file("knot.ply"), "-o", folder / "out.ply", "--ratio", "0.1"}, options);
  EXPECT_FALSE(has_bar(outcome.err)) << outcome;
  EXPECT_FALSE(has_color(outcome.err)) << outcome;
}

}  // namespace
}  // namespace whittle::test
