// Runs the examples of docs/user and of the README as they are written. Each block that begins with "```console" runs
// in a new folder with the meshes of data/. The program must print what the page shows, except for times and memory.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "program/help_text.hh"
#include "program/program.hh"

namespace whittle::test {
namespace {

namespace fs = std::filesystem;

/// A command and its output on the page.
struct Example {
  std::string command;
  std::vector<std::string> printed;
};
using Block = std::vector<Example>;

/// A page, cut at its blocks of examples: text, block, text, …, text.
struct Page {
  std::vector<std::string> texts{1};
  std::vector<Block> blocks;
};

Page page_of(const std::string& content) {
  Page page;
  bool inside = false;
  for (const std::string& line : lines_of(content)) {
    if (inside && line == "```") {
      inside = false;
      page.texts.emplace_back();
    }
    if (!inside) {
      page.texts.back() += line + '\n';
    } else if (line.rfind("$ ", 0) == 0) {
      page.blocks.back().push_back({line.substr(2), {}});
    } else {
      page.blocks.back().back().printed.push_back(line);
    }
    if (line == "```console") {
      inside = true;
      page.blocks.emplace_back();
    }
  }
  return page;
}

std::string content_of(const Page& page) {
  std::string content = page.texts[0];
  for (std::size_t i = 0; i < page.blocks.size(); ++i) {
    for (const Example& example : page.blocks[i]) {
      content += "$ " + example.command + '\n';
      for (const std::string& line : example.printed) content += line + '\n';
    }
    content += page.texts[i + 1];
  }
  return content;
}

/// A line without what differs between runs. The width of the times moves table columns.
std::string steady(const std::string& line) {
  std::string text = std::regex_replace(line, std::regex(R"(\d+\.\d+ s\b)"), "T s");
  text = std::regex_replace(text, std::regex(R"(\d+ MiB)"), "M MiB");
  text = std::regex_replace(text, std::regex(R"((T s +T s +)\S+)"), "$1R");
  text = std::regex_replace(text, std::regex(R"(\S+ times as fast)"), "X times as fast");
  return std::regex_replace(text, std::regex(" +"), " ");
}

std::vector<std::string> steady(std::vector<std::string> lines) {
  for (std::string& line : lines) line = steady(line);
  return lines;
}

/// What the commands of a block print when run in order in a new folder.
std::vector<std::vector<std::string>> printed_by(const Block& block) {
  const TemporaryFolder folder;
  for (const auto& entry : fs::directory_iterator(fs::path(data_file("knot.ply")).parent_path())) {
    if (entry.is_regular_file()) fs::copy_file(entry.path(), folder.path() / entry.path().filename());
  }
  RunOptions options;
  options.folder = folder.path();
  std::string script;
  for (const Example& example : block) {
    script += "{ " + example.command + "\n} 2>&1; status=$?; echo \"==$status==\"; (exit $status)\n";
  }
  const Outcome outcome = run({"bash", "-c", script}, options);
  EXPECT_EQ(outcome.err, "");
  std::vector<std::vector<std::string>> printed(1);
  for (const std::string& line : lines_of(outcome.out)) {
    if (std::regex_match(line, std::regex("==[0-9]+=="))) {
      printed.emplace_back();
    } else {
      printed.back().push_back(line);
    }
  }
  EXPECT_EQ(printed.size(), block.size() + 1) << outcome;
  printed.resize(block.size());
  return printed;
}

/// Runs all examples of a page. If WHITTLE_UPDATE_DOCS is in the environment, writes the output into the page.
/// \return the number of commands.
std::size_t check(const fs::path& path) {
  std::size_t n_commands = 0;
  Page page = page_of(read_text(path));
  EXPECT_EQ(content_of(page), read_text(path));
  for (Block& block : page.blocks) {
    const auto printed = printed_by(block);
    for (std::size_t i = 0; i < block.size(); ++i, ++n_commands) {
      if (steady(printed[i]) == steady(block[i].printed)) continue;
      EXPECT_EQ(steady(printed[i]), steady(block[i].printed))
          << "$ " << block[i].command << "\nWHITTLE_UPDATE_DOCS=1 writes what it prints into " << path;
      block[i].printed = printed[i];
    }
  }
  if (std::getenv("WHITTLE_UPDATE_DOCS") != nullptr) write_text(path, content_of(page));
  return n_commands;
}

TEST(Examples, PrintWhatTheDocumentationSays) {
  std::size_t n_commands = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(WHITTLE_DOCS_DIR) / "user")) {
    if (!entry.is_regular_file()) continue;
    SCOPED_TRACE(entry.path().filename().string());
    n_commands += check(entry.path());
  }
  n_commands += check(fs::path(WHITTLE_DOCS_DIR).parent_path() / "README.md");
  EXPECT_GE(n_commands, 10U);
}

TEST(Examples, AreThereForEverySubcommand) {
  for (const std::string& sub : subcommands_with_pages(whittle({"--help"}).out)) {
    std::size_t n_calls = 0;
    for (const Block& block : page_of(read_text(fs::path(WHITTLE_DOCS_DIR) / "user" / (sub + ".md"))).blocks) {
      for (const Example& example : block) n_calls += example.command.find("whittle " + sub) != std::string::npos;
    }
    EXPECT_GE(n_calls, 2U) << sub;
  }
}

TEST(Examples, NameEveryPageInTheIndex) {
  const std::string index = read_text(fs::path(WHITTLE_DOCS_DIR) / "user" / "README.md");
  for (const auto& entry : fs::directory_iterator(fs::path(WHITTLE_DOCS_DIR) / "user")) {
    const std::string name = entry.path().filename().string();
    if (name == "README.md" || entry.is_directory()) continue;
    EXPECT_NE(index.find("(" + name + ")"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace whittle::test
