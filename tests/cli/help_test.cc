// The help text, and whether the tables of docs/user agree with it.
#include "program/help_text.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "program/program.hh"

namespace whittle::test {
namespace {

const std::vector<std::string> subcommands{"simplify", "measure", "info", "polish",   "compare", "convert",
                                           "verify",   "replay",  "lod",  "geomorph", "report"};

std::string page(const std::string& subcommand) {
  return read_text(std::filesystem::path(WHITTLE_DOCS_DIR) / "user" / (subcommand + ".md"));
}

/// Options of the page, then those of all subcommands, which are in the index.
std::vector<OptionText> documented_options(const std::string& subcommand) {
  return options_of_page(page(subcommand) + page("README"));
}

/// Conflicts of the page, and those of the index between options that the subcommand has.
std::vector<std::pair<std::string, std::string>> documented_conflicts(const std::string& subcommand) {
  const std::string help = whittle({subcommand, "--help"}).out;
  auto conflicts = conflicts_of_page(page(subcommand));
  for (const auto& [first, second] : conflicts_of_page(page("README"))) {
    const bool has_both = help.find(words_of(first).front() + ' ') != std::string::npos &&
                          help.find(words_of(second).front() + ' ') != std::string::npos;
    if (has_both) conflicts.emplace_back(first, second);
  }
  return conflicts;
}

/// The name of an argument: "W", "FILE".
bool is_placeholder(const std::string& word) {
  return std::all_of(word.begin(), word.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

TEST(Help, IsPrintedOnStandardOutput) {
  for (const std::string& flag : {std::string("-h"), std::string("--help")}) {
    const Outcome top = whittle({flag});
    EXPECT_EQ(top.exit_code, 0) << top;
    EXPECT_EQ(top.err, "") << top;
    for (const std::string& sub : subcommands) {
      EXPECT_NE(top.out.find("\n  " + sub + " "), std::string::npos) << top;
      const Outcome help = whittle({sub, flag});
      EXPECT_EQ(help.exit_code, 0) << help;
      EXPECT_EQ(help.err, "") << help;
      EXPECT_NE(help.out.find("Usage: whittle " + sub), std::string::npos) << help;
      EXPECT_NE(help.out.find("Examples:\n"), std::string::npos) << help;
    }
  }
}

TEST(Help, FitsAHundredColumns) {
  for (const std::string& sub : subcommands) {
    for (const std::string& line : lines_of(whittle({sub, "--help"}).out)) EXPECT_LE(line.size(), 100U) << line;
  }
}

TEST(Help, GivesEveryOptionADefault) {
  for (const std::string& sub : subcommands) {
    const std::vector<OptionText> options = options_of_help(whittle({sub, "--help"}).out);
    EXPECT_GE(options.size(), 7U) << sub;
    for (const OptionText& option : options) {
      EXPECT_FALSE(option.meaning.empty()) << option.name;
      EXPECT_TRUE(!option.standard.empty() || option.name == "-h, --help") << option.name;
    }
  }
}

TEST(Help, SaysWhatTheDocumentationSays) {
  for (const std::string& sub : subcommands) {
    const std::string help = whittle({sub, "--help"}).out;
    EXPECT_EQ(table_of(options_of_help(help)), table_of(documented_options(sub)))
        << "docs/user/" << sub << ".md, with docs/user/README.md, should have the table of the first kind";
  }
}

TEST(Help, DocumentsEveryConflict) {
  const TemporaryFolder folder;
  std::size_t n_conflicts = 0;
  for (const std::string& sub : subcommands) {
    for (const auto& [first, second] : documented_conflicts(sub)) {
      const std::string mesh = data_file("cubes.obj");
      std::vector<std::string> arguments{sub, mesh};
      if (sub == "measure" || sub == "polish") arguments.push_back(mesh);
      if (sub == "verify") arguments.insert(arguments.end(), {mesh, folder / "proof"});
      if (sub == "convert") arguments.push_back(folder / "out.obj");
      if (sub == "lod") arguments.insert(arguments.end(), {"-o", folder / "out{i}.obj", "--faces", "100"});
      if (sub == "replay") arguments.insert(arguments.end(), {"-o", folder / "out.obj", "--at", "1"});
      if (sub == "report") arguments.insert(arguments.end(), {"-o", folder / "out.html"});
      if (sub == "geomorph") arguments.insert(arguments.end(), {"-o", folder / "out.glb"});
      if (sub == "simplify" || sub == "compare") arguments.insert(arguments.end(), {"--faces", "150"});
      const bool names_output = first.starts_with("--output") || second.starts_with("--output");
      if ((sub == "simplify" || sub == "polish") && !names_output)
        arguments.insert(arguments.end(), {"-o", folder / "out.obj"});
      if (names_output) arguments.insert(arguments.end(), {"--format", "obj"});
      for (const std::string& side : {first, second}) {
        for (const std::string& word : words_of(side)) arguments.push_back(is_placeholder(word) ? "1" : word);
      }
      const Outcome outcome = whittle(arguments);
      EXPECT_EQ(outcome.exit_code, 2) << outcome;
      EXPECT_NE(outcome.err.find("doesn't go with"), std::string::npos) << outcome;
      for (const std::string& side : {first, second}) {
        for (const std::string& word : words_of(side)) {
          EXPECT_TRUE(is_placeholder(word) || outcome.err.find(word) != std::string::npos) << word << '\n' << outcome;
        }
      }
      ++n_conflicts;
    }
  }
  EXPECT_GE(n_conflicts, 5U);
}

TEST(Version, IsOneLineOnStandardOutput) {
  const Outcome outcome = whittle({"--version"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.out, "whittle " WHITTLE_VERSION "\n") << outcome;
  EXPECT_EQ(outcome.err, "") << outcome;
  EXPECT_EQ(whittle({"-V"}).out, outcome.out);
}

TEST(Help, IsThereAsASubcommandToo) {
  EXPECT_EQ(whittle({"help"}).out, whittle({"--help"}).out);
  for (const std::string& sub : subcommands) {
    const Outcome outcome = whittle({"help", sub});
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_EQ(outcome.out, whittle({sub, "--help"}).out);
  }
}

}  // namespace
}  // namespace whittle::test
