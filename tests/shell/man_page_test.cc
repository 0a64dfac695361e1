// The manual page: what the help has, in a form that groff reads without a warning.
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "program/help_text.hh"
#include "program/program.hh"

namespace whittle::test {
namespace {

/// The page as a reader sees it, in lines of 200 columns; empty if groff isn't installed.
std::string formatted() {
  const Outcome page = whittle({"man"});
  EXPECT_EQ(page.exit_code, 0) << page;
  EXPECT_EQ(page.err, "");
  if (run({"bash", "-c", "command -v groff"}).exit_code != 0) return {};
  RunOptions options;
  options.input = page.out;
  // -c and -P-c print no colours, -P-bou neither bold nor underlined letters.
  const Outcome outcome = run({"groff", "-man", "-ww", "-rLL=200n", "-rHY=0", "-c", "-Tascii", "-P-cbou"}, options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

std::string with_single_spaces(const std::string& text) { return std::regex_replace(text, std::regex("\\s+"), " "); }

/// The lines below a heading, up to the next one that is indented as far or less.
std::string below(const std::string& heading, const std::string& page) {
  const std::size_t depth = heading.find_first_not_of(' ');
  bool inside = false;
  std::string part;
  for (const std::string& line : lines_of(page)) {
    if (inside && line.find_first_not_of(' ') <= depth) break;
    if (inside) part += line + '\n';
    if (line == heading) inside = true;
  }
  EXPECT_TRUE(inside) << "no heading '" << heading << "' in\n" << page;
  return with_single_spaces(part);
}

TEST(ManPage, SaysWhatTheHelpSays) {
  const std::string page = formatted();
  if (page.empty()) GTEST_SKIP() << "groff is not installed";
  const std::string common = below("COMMON OPTIONS", page);
  const std::vector<std::string> subcommands = subcommands_of_help(whittle({"--help"}).out);
  ASSERT_GE(subcommands.size(), 5U);
  for (const std::string& sub : subcommands) {
    const std::string part = below("   " + sub, page);
    for (const OptionText& option : options_of_help(whittle({sub, "--help"}).out)) {
      const std::string text = option.name + ' ' + option.meaning;
      EXPECT_TRUE(part.find(text) != std::string::npos || common.find(text) != std::string::npos)
          << sub << ": " << text;
    }
  }
}

TEST(ManPage, HasTheUsualSections) {
  const std::string page = formatted();
  if (page.empty()) GTEST_SKIP() << "groff is not installed";
  for (const char* heading :
       {"NAME", "SYNOPSIS", "DESCRIPTION", "SUBCOMMANDS", "COMMON OPTIONS", "EXIT STATUS", "ENVIRONMENT"}) {
    EXPECT_NE(page.find('\n' + std::string(heading) + '\n'), std::string::npos) << heading << '\n' << page;
  }
  EXPECT_NE(page.find("whittle - make triangle meshes smaller"), std::string::npos) << page;
}

}  // namespace
}  // namespace whittle::test
