// What is for terminals only: the progress bar, which is erased at the end, and colours, as --color and NO_COLOR say.
#include <gtest/gtest.h>

#include <map>
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

using Arguments = std::vector<std::string>;
using Environment = std::map<std::string, std::string>;

const Environment terminal_variables{{"TERM", "xterm"}, {"NO_COLOR", ""}};

/// What a run writes on standard error, which is a terminal or a pipe.
std::string said(const Arguments& arguments, bool at_terminal, const Environment& environment) {
  Terminal terminal(200);
  RunOptions options;
  options.environment = environment;
  if (at_terminal) options.stderr_to = terminal.descriptor();
  const Outcome outcome = whittle(arguments, options);
  return at_terminal ? terminal.read_all() : outcome.err;
}

Arguments with(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// An error of the command line, one of a file, and a run with a warning and a progress bar.
std::vector<Arguments> talkative_runs(const TemporaryFolder& folder) {
  return {{"simplify", data_file("cubes.obj"), "--faces", "none"},
          {"info", folder / "missing.obj"},
          {"simplify", data_file("cubes.obj"), "-o", folder / "out.obj", "--faces", "10", "--topology", "keep"}};
}

TEST(Color, IsForTerminalsOnly) {
  const TemporaryFolder folder;
  for (const Arguments& run : talkative_runs(folder)) {
    SCOPED_TRACE(run.back());
    EXPECT_TRUE(has_color(said(run, true, terminal_variables)));
    EXPECT_FALSE(has_color(said(run, false, terminal_variables)));
    EXPECT_FALSE(has_color(said(run, true, {{"TERM", "xterm"}, {"NO_COLOR", "1"}})));
    EXPECT_FALSE(has_color(said(run, true, {{"TERM", "dumb"}, {"NO_COLOR", ""}})));
  }
}

TEST(Color, IsAsTheOptionSays) {
  const TemporaryFolder folder;
  for (const Arguments& run : talkative_runs(folder)) {
    SCOPED_TRACE(run.back());
    EXPECT_TRUE(has_color(said(with(run, {"--color", "always"}), false, {{"NO_COLOR", "1"}})));
    EXPECT_FALSE(has_color(said(with(run, {"--color=never"}), true, terminal_variables)));
    EXPECT_TRUE(has_color(said(with(run, {"--color", "auto"}), true, terminal_variables)));
  }
  const std::string wrong = said({"info", "--color", "blue", "x.obj"}, false, {});
  EXPECT_NE(wrong.find("--color: 'blue' is none of auto|always|never"), std::string::npos) << wrong;
}

TEST(Color, IsInThePrefixAlone) {
  const TemporaryFolder folder;
  EXPECT_EQ(
      said({"info", folder / "missing.obj", "--color", "always"}, false, {}),
      "\x1b[1;31mwhittle:\x1b[0m " + (folder / "missing.obj") + ": cannot be opened: No such file or directory\n");
  const std::string warned = said(with(talkative_runs(folder).back(), {"--color", "always"}), false, {});
  EXPECT_NE(warned.find("whittle: \x1b[1;33mwarning:\x1b[0m "), std::string::npos) << warned;
  EXPECT_NE(warned.find("whittle: " + (folder / "out.obj") + ": 300 -> 100"), std::string::npos) << warned;
}

}  // namespace
}  // namespace whittle::test
