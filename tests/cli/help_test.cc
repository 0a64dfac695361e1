// The help text, and whether the tables of docs/user agree with it.
#include "program/help_text.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "program/program.hh"

namespace whittle::test {
namespace {

std::vector<std::string> subcommands() { return subcommands_with_pages(whittle({"--help"}).out); }

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

TEST(Help, ListsTheSubcommandsThatHavePages) {
  std::vector<std::string> documented;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(WHITTLE_DOCS_DIR) / "user")) {
    const std::string name = entry.path().stem().string();
    if (name != "README" && !entry.is_directory() && !options_of_page(page(name)).empty()) documented.push_back(name);
  }
  EXPECT_THAT(subcommands(), testing::UnorderedElementsAreArray(documented));
}

TEST(Help, IsPrintedOnStandardOutput) {
  for (const std::string& flag : {std::string("-h"), std::string("--help")}) {
    const Outcome top = whittle({flag});
    EXPECT_EQ(top.exit_code, 0) << top;
    EXPECT_EQ(top.err, "") << top;
    for (const std::string& sub : subcommands()) {
      const Outcome help = whittle({sub, flag});
      EXPECT_EQ(help.exit_code, 0) << help;
      EXPECT_EQ(help.err, "") << help;
      EXPECT_NE(help.out.find("Usage: whittle " + sub), std::string::npos) << help;
      EXPECT_NE(help.out.find("Examples:\n"), std::string::npos) << help;
    }
  }
}

TEST(Help, FitsAHundredColumns) {
  for (const std::string& sub : subcommands()) {
    for (const std::string& line : lines_of(whittle({sub, "--help"}).out)) EXPECT_LE(line.size(), 100U) << line;
  }
}

TEST(Help, GivesEveryOptionADefault) {
  for (const std::string& sub : subcommands()) {
    const std::vector<OptionText> options = options_of_help(whittle({sub, "--help"}).out);
    EXPECT_GE(options.size(), 7U) << sub;
    for (const OptionText& option : options) {
      EXPECT_FALSE(option.meaning.empty()) << option.name;
      EXPECT_TRUE(!option.standard.empty() || option.name == "-h, --help") << option.name;
    }
  }
}

TEST(Help, NamesNoWordOfOutThatIsNotReplaced) {
  for (const std::string& sub : subcommands()) {
    const bool is_replaced = sub == "simplify";
    EXPECT_EQ(whittle({sub, "--help"}).out.find("{stem}") != std::string::npos, is_replaced) << sub;
  }
}

TEST(Help, SaysWhatTheDocumentationSays) {
  for (const std::string& sub : subcommands()) {
    const std::string help = whittle({sub, "--help"}).out;
    EXPECT_EQ(table_of(options_of_help(help)), table_of(documented_options(sub)))
        << "docs/user/" << sub << ".md, with docs/user/README.md, should have the table of the first kind";
  }
}

/// A subcommand with the arguments and options that it requires, but for those that conflict.
std::vector<std::string> call_of(const std::string& sub, const std::string& first, const std::string& second,
                                 const TemporaryFolder& folder) {
  const std::string help = whittle({sub, "--help"}).out;
  std::vector<std::string> arguments{sub};
  arguments.resize(1 + arguments_of_help(help).size(), data_file("cubes.obj"));
  bool names_output = false;
  for (const OptionText& option : options_of_help(help)) {
    if (option.standard != "required") continue;
    const std::string name = names_of(option).back();
    const bool is_named = first.starts_with(name) || second.starts_with(name);
    names_output |= is_named;
    if (!is_named) arguments.insert(arguments.end(), {name, folder / "out.obj"});
  }
  if (names_output) arguments.insert(arguments.end(), {"--format", "obj"});
  if (!options_of_group(help, "Targets").empty()) arguments.insert(arguments.end(), {"--faces", "150"});
  return arguments;
}

TEST(Help, DocumentsEveryConflict) {
  const TemporaryFolder folder;
  std::size_t n_conflicts = 0;
  for (const std::string& sub : subcommands()) {
    for (const auto& [first, second] : documented_conflicts(sub)) {
      std::vector<std::string> arguments = call_of(sub, first, second, folder);
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
  for (const std::string& sub : subcommands()) {
    const Outcome outcome = whittle({"help", sub});
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_EQ(outcome.out, whittle({sub, "--help"}).out);
  }
}

}  // namespace
}  // namespace whittle::test
