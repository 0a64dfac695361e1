// What is said where a target was missed.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "program/program.hh"

namespace whittle::test {
namespace {

struct Missed {
  std::string mesh;
  std::string faces;
  std::vector<std::string> options;  ///< name, value, …
  std::string expected;              ///< option that is to be named
};

std::vector<std::string> strict_run(const Missed& missed, const std::vector<std::string>& options) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments{"simplify", data_file(missed.mesh), "-o",      folder / "out.ply",
                                     "--faces",  missed.faces,           "--strict"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = whittle(arguments);
  return {std::to_string(outcome.exit_code), outcome.err};
}

/// The options with this one, in the place of any of its name.
std::vector<std::string> with(std::vector<std::string> options, const std::string& name, const std::string& value) {
  const auto there = std::find(options.begin(), options.end(), name);
  if (there == options.end()) {
    options.insert(options.end(), {name, value});
  } else {
    *(there + 1) = value;
  }
  return options;
}

TEST(Advice, NamesOptionsThatReachTheTarget) {
  const std::vector<Missed> cases{{"cubes.obj", "10", {"--topology", "keep"}, "--topology"},
                                  {"terrain.ply", "50", {"--boundary", "locked"}, "--boundary"},
                                  {"terrain.ply", "50", {"--max-normal-flip", "5"}, "--max-normal-flip"},
                                  {"blob.obj", "50", {"--min-radius-ratio", "0.7"}, "--min-radius-ratio"},
                                  {"bracket.stl", "60", {"--feature-angle", "20"}, "--feature-angle"}};
  for (const Missed& missed : cases) {
    SCOPED_TRACE(missed.mesh + ' ' + missed.expected);
    const std::vector<std::string> run = strict_run(missed, missed.options);
    EXPECT_EQ(run[0], "3") << run[1];
    const std::size_t obstacle = run[1].find("the pairs left: ");
    ASSERT_NE(obstacle, std::string::npos) << run[1];
    const std::string said = run[1].substr(obstacle);
    const std::regex quoted("'(--[a-z-]+) ([a-z0-9]+)'");
    bool is_named = false;
    for (std::sregex_iterator it(said.begin(), said.end(), quoted), end; it != end; ++it) {
      is_named = is_named || (*it)[1] == missed.expected;
      if (said.find("reaches it") == std::string::npos) continue;
      const std::vector<std::string> again = strict_run(missed, with(missed.options, (*it)[1], (*it)[2]));
      EXPECT_EQ(again[0], "0") << (*it)[0] << " was advised: " << again[1];
    }
    EXPECT_TRUE(is_named) << said;
  }
}

TEST(Advice, IsInTheReport) {
  const TemporaryFolder folder;
  const Outcome outcome = whittle({"simplify", data_file("cubes.obj"), "-o", folder / "out.obj", "--faces", "10",
                                   "--topology", "keep", "--json", "-"});
  const auto json = parse_json(outcome.out);
  // Each of the 25 cubes has become a tetrahedron, with six edges.
  EXPECT_EQ(json["refused_at_end"]["link"], 150) << outcome;
  EXPECT_EQ(json["refused_at_end"]["flip"], 0) << outcome;
}

}  // namespace
}  // namespace whittle::test
