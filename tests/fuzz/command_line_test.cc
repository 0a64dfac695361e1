// Replays the corpus of command lines: runs the program in an empty folder with each of them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/decode/command_line_bytes.hh"
#include "program/program.hh"

namespace whittle::test {
namespace {

TEST(FuzzCorpus, OfCommandLinesKeepsItsPromises) {
  std::size_t n = 0;
  for (const auto& entry : std::filesystem::directory_iterator(WHITTLE_FUZZ_CORPUS "/command_line")) {
    const std::string bytes = read_text(entry.path());
    ByteSource source(bytes);
    const std::vector<std::string> arguments = decode_command_line(source);
    const TemporaryFolder folder;
    RunOptions options;
    options.folder = folder.path();
    const Outcome outcome = whittle(arguments, options);
    EXPECT_NO_THROW(check_ending(arguments, {outcome.exit_code, outcome.out, outcome.err}))
        << entry.path() << ' ' << testing::PrintToString(arguments) << outcome;
    EXPECT_TRUE(folder.files().empty()) << testing::PrintToString(arguments);
    ++n;
  }
  EXPECT_GT(n, 0U);
}

}  // namespace
}  // namespace whittle::test
