// The completion scripts have what the help has. zsh and fish read them, where they are installed.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "program/help_text.hh"
#include "program/program.hh"

namespace whittle::test {
namespace {

const std::vector<std::string> shells{"bash", "zsh", "fish"};

bool is_installed(const std::string& program) { return run({"bash", "-c", "command -v " + program}).exit_code == 0; }

std::string script(const std::string& shell) {
  const Outcome outcome = whittle({"completion", shell});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

/// What fish offers at the end of such a line: the words without their descriptions.
std::set<std::string> offered_by_fish(const std::string& line, const TemporaryFolder& folder) {
  write_text(folder.path() / "whittle.fish", script("fish"));
  RunOptions options;
  options.folder = folder.path();
  options.environment = {{"HOME", folder.path().string()}};
  const Outcome outcome =
      run({"fish", "--no-config", "-c", "source whittle.fish; complete -C '" + line + "'"}, options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.err, "");
  std::set<std::string> words;
  for (const std::string& row : lines_of(outcome.out)) words.insert(row.substr(0, row.find('\t')));
  return words;
}

TEST(Completion, NamesEverySubcommandAndOption) {
  const std::vector<std::string> subcommands = subcommands_of_help(whittle({"--help"}).out);
  ASSERT_GE(subcommands.size(), 5U);
  for (const std::string& shell : shells) {
    const std::string text = script(shell);
    for (const std::string& sub : subcommands) {
      EXPECT_NE(text.find(sub), std::string::npos) << shell << ' ' << sub;
      for (const OptionText& option : options_of_help(whittle({sub, "--help"}).out)) {
        for (const std::string& name : names_of(option)) {
          const std::string bare = name.substr(name.find_first_not_of('-'));
          const bool is_long = name.starts_with("--");
          const std::string as_written = shell != "fish" ? name : (is_long ? "-l " : "-s ") + bare + ' ';
          EXPECT_NE(text.find(as_written), std::string::npos) << shell << ' ' << sub << ' ' << name;
        }
      }
    }
  }
}

TEST(Completion, RefusesOtherShells) {
  const Outcome outcome = whittle({"completion", "tcsh"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome;
  EXPECT_NE(outcome.err.find("'tcsh' is none of bash|zsh|fish"), std::string::npos) << outcome;
}

TEST(Completion, IsReadByEachShell) {
  std::string missing;
  for (const std::string& shell : shells) {
    if (!is_installed(shell)) {
      missing += ' ' + shell;
      continue;
    }
    const TemporaryFolder folder;
    write_text(folder.path() / "script", script(shell));
    const Outcome outcome = run({shell, "-n", folder / "script"});
    EXPECT_EQ(outcome.exit_code, 0) << shell << outcome;
    EXPECT_EQ(outcome.out + outcome.err, "") << shell;
  }
  if (!missing.empty()) GTEST_SKIP() << "not installed:" << missing;
}

TEST(Completion, OffersInFishWhatTheHelpHas) {
  if (!is_installed("fish")) GTEST_SKIP() << "fish is not installed";
  const TemporaryFolder folder;
  const std::vector<std::string> subcommands = subcommands_of_help(whittle({"--help"}).out);
  std::set<std::string> expected(subcommands.begin(), subcommands.end());
  EXPECT_EQ(offered_by_fish("whittle help ", folder), expected);
  expected.insert("help");
  EXPECT_EQ(offered_by_fish("whittle ", folder), expected);
  for (const std::string& sub : subcommands) {
    std::set<std::string> names;
    for (const OptionText& option : options_of_help(whittle({sub, "--help"}).out)) {
      for (const std::string& name : names_of(option)) {
        if (name.starts_with("--")) names.insert(name);
      }
    }
    EXPECT_EQ(offered_by_fish("whittle " + sub + " --", folder), names) << sub;
  }
  EXPECT_EQ(offered_by_fish("whittle simplify --effort ", folder), (std::set<std::string>{"best", "fast", "normal"}));
  EXPECT_EQ(offered_by_fish("whittle simplify --faces ", folder), std::set<std::string>());
}

TEST(Completion, OffersMeshFilesInFish) {
  if (!is_installed("fish")) GTEST_SKIP() << "fish is not installed";
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "parts");
  for (const char* name : {"a.obj", "B.PLY", "c.ply.gz", "d.glb", "notes.txt", "c.gz"})
    write_text(folder.path() / name, "");
  const std::set<std::string> meshes{"B.PLY", "a.obj", "c.ply.gz", "d.glb", "parts/"};
  EXPECT_EQ(offered_by_fish("whittle info ", folder), meshes);
  EXPECT_EQ(offered_by_fish("whittle simplify a.obj --output ", folder), meshes);
}

}  // namespace
}  // namespace whittle::test
