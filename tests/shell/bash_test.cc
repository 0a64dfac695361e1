// Completion in bash: the script runs in a real bash, with the variables that bash sets when a user presses TAB.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "program/help_text.hh"
#include "program/program.hh"
#include "whittle/io/format.hh"

namespace whittle::test {
namespace {

using Words = std::vector<std::string>;

/// What is offered for the last word, sorted. \param words after the program's name
Words offered(Words words, const std::filesystem::path& folder = {}) {
  words.insert(words.begin(), {"bash", "--noprofile", "--norc", "-c",
                               "eval \"$(whittle completion bash)\"\n"
                               "COMP_WORDS=(whittle \"$@\") COMP_CWORD=$#\n"
                               "_whittle\n"
                               "((${#COMPREPLY[@]} == 0)) || printf '%s\\n' \"${COMPREPLY[@]}\"",
                               "bash"});
  RunOptions options;
  options.folder = folder;
  const Outcome outcome = run(words, options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(outcome.err, "");
  Words found = lines_of(outcome.out);
  std::sort(found.begin(), found.end());
  return found;
}

Words sorted(Words words) {
  std::sort(words.begin(), words.end());
  return words;
}

Words all_subcommands() { return subcommands_of_help(whittle({"--help"}).out); }

Words formats() {
  Words names;
  names.reserve(io::all_formats.size());
  for (const io::Format format : io::all_formats) names.emplace_back(io::name_of(format));
  return names;
}

/// "fast", "normal" and "best" of "--effort fast|normal|best"; the formats of "EXT".
Words values_in(const OptionText& option) {
  Words values;
  std::string value = words_of(option.name).back();
  if (value.starts_with('-')) return {};
  std::replace(value.begin(), value.end(), '|', ' ');
  for (const std::string& word : words_of(value)) {
    if (word == "EXT") {
      const Words names = formats();
      values.insert(values.end(), names.begin(), names.end());
    }
    if (word.front() >= 'a' && word.front() <= 'z') values.push_back(word);
  }
  return values;
}

TEST(Bash, KnowsTheProgram) {
  const Outcome outcome = run({"bash", "-c", "eval \"$(whittle completion bash)\"; complete -p whittle"});
  EXPECT_EQ(outcome.out, "complete -F _whittle whittle\n") << outcome;
}

TEST(Bash, OffersSubcommands) {
  Words expected = all_subcommands();
  EXPECT_EQ(offered({"help", ""}), sorted(expected));
  expected.emplace_back("help");
  EXPECT_EQ(offered({""}), sorted(expected));
  EXPECT_EQ(offered({"si"}), Words{"simplify"});
  EXPECT_EQ(offered({"--v"}), Words{"--version"});
  EXPECT_EQ(offered({"nothing", ""}), Words());
}

TEST(Bash, OffersTheOptionsOfTheHelp) {
  for (const std::string& sub : all_subcommands()) {
    Words names;
    for (const OptionText& option : options_of_help(whittle({sub, "--help"}).out)) {
      for (const std::string& name : names_of(option)) names.push_back(name);
    }
    EXPECT_EQ(offered({sub, "-"}), sorted(names)) << sub;
  }
  EXPECT_EQ(offered({"simplify", "a.obj", "--face"}), (Words{"--face-ratio", "--faces"}));
}

TEST(Bash, OffersTheWordsThatAnOptionTakes) {
  std::size_t n_options = 0;
  for (const std::string& sub : all_subcommands()) {
    for (const OptionText& option : options_of_help(whittle({sub, "--help"}).out)) {
      const Words values = values_in(option);
      if (values.empty()) continue;
      ++n_options;
      for (const std::string& name : names_of(option)) {
        EXPECT_EQ(offered({sub, name, ""}), sorted(values)) << sub << ' ' << name;
      }
    }
  }
  EXPECT_GE(n_options, 9U);
  EXPECT_EQ(offered({"simplify", "--cost", "m"}), (Words{"memoryless", "midpoint"}));
  EXPECT_EQ(offered({"info", "--format", ""}), sorted(formats()));
  EXPECT_EQ(offered({"info", "--input-format", "g"}), (Words{"glb", "gltf"}));
  EXPECT_EQ(offered({"compare", "--input-format", "g"}), Words()) << "reads no glTF";
  EXPECT_EQ(offered({"simplify", "-t", ""}), Words{"auto"});
  EXPECT_EQ(offered({"completion", ""}), (Words{"bash", "fish", "zsh"}));
  EXPECT_EQ(offered({"simplify", "--faces", ""}), Words());
}

TEST(Bash, OffersValuesAfterAnEqualsSign) {
  // As bash cuts the line by default, and as it does where '=' is no break.
  EXPECT_EQ(offered({"simplify", "--effort", "=", "f"}), Words{"fast"});
  EXPECT_EQ(offered({"simplify", "--effort", "="}), (Words{"best", "fast", "normal"}));
  EXPECT_EQ(offered({"simplify", "--effort=f"}), Words{"--effort=fast"});
}

TEST(Bash, OffersMeshFilesAndFolders) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "parts");
  for (const char* name :
       {"a.obj", "B.PLY", "two words.off", "s.stl", "t.gltf", "u.GLB", "z.Obj.gz", "notes.txt", "z.gz", "z.glb.gz"}) {
    write_text(folder.path() / name, "");
  }
  const Words meshes{"B.PLY", "a.obj", "parts", "s.stl", "t.gltf", "two words.off", "u.GLB", "z.Obj.gz"};
  EXPECT_EQ(offered({"info", ""}, folder.path()), meshes);
  EXPECT_EQ(offered({"measure", "a.obj", ""}, folder.path()), meshes);
  EXPECT_EQ(offered({"simplify", "a.obj", "--strict", ""}, folder.path()), meshes);
  EXPECT_EQ(offered({"simplify", "a.obj", "-o", ""}, folder.path()), meshes);
  EXPECT_EQ(offered({"simplify", "a.obj", "--output", "=", "a"}, folder.path()), Words{"a.obj"});
  EXPECT_EQ(offered({"info", "a.obj", "--json", "n"}, folder.path()), Words{"notes.txt"});
  EXPECT_EQ(offered({"verify", "a.obj", "s.stl", "n"}, folder.path()), Words{"notes.txt"}) << "a certificate";
  EXPECT_EQ(offered({"man", ""}, folder.path()), Words());
}

TEST(Bash, OffersFilesOfEveryFormat) {
  const TemporaryFolder folder;
  Words expected;
  for (const io::Format format : io::all_formats) {
    for (const std::string_view extension : io::extensions_of(format)) {
      for (const char* packing : {"", ".gz"}) {
        expected.push_back("mesh." + std::string(extension) + packing);
        write_text(folder / expected.back(), "");
      }
    }
  }
  EXPECT_EQ(offered({"info", ""}, folder.path()), sorted(expected));
}

}  // namespace
}  // namespace whittle::test
