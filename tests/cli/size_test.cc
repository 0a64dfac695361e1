// Meshes whose coordinates are very large or very small.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

std::string written(const TemporaryFolder& folder, const std::string& name, const IndexedMesh& mesh) {
  io::write_mesh(folder / name, mesh);
  return folder / name;
}

/// Every subcommand on two meshes. \param large the finer one
std::vector<std::vector<std::string>> commands(const TemporaryFolder& folder, const std::string& large,
                                               const std::string& small) {
  return {{"info", large},
          {"measure", large, small, "--samples", "1000"},
          {"polish", large, small, "-o", folder / "polished.ply", "--force"},
          {"compare", large, "--faces", "200", "--samples", "1000"},
          {"simplify", large, "--faces", "200", "-o", folder / "out.ply", "--force"},
          {"simplify", large, "--faces", "200", "-o", folder / "out.ply", "--force", "--feature-angle", "40"},
          {"simplify", large, "--faces", "200", "-o", folder / "out.ply", "--force", "--threshold", "auto"}};
}

TEST(Size, MakesNoDifferenceToAnySubcommand) {
  for (const double size : {1e-140, 1e-80, 1e80, 1e125, 1e149}) {
    const TemporaryFolder folder;
    const std::string large = written(folder, "large.ply", scaled(blob(3, 1), size));
    const std::string small = written(folder, "small.ply", scaled(blob(2, 1), size));
    for (const std::vector<std::string>& arguments : commands(folder, large, small)) {
      const Outcome outcome = whittle(arguments);
      EXPECT_EQ(outcome.exit_code, 0) << arguments[0] << " at " << size << ": " << outcome;
    }
    const auto json = parse_json(whittle({"measure", large, small, "--samples", "1000", "--json", "-"}).out);
    EXPECT_GT(json["mean"].get<double>(), 1e-3 * size) << json;
    EXPECT_LT(json["max"].get<double>(), size) << json;
  }
}

TEST(Size, TooLargeIsSaidWithTheVertex) {
  for (const bool whole : {true, false}) {
    const TemporaryFolder folder;
    IndexedMesh mesh = blob(3, 1);
    if (whole) mesh = scaled(mesh, 1e200);
    mesh.positions[7] = Vec3(0.5, 1e200, 2);
    const std::string large = written(folder, "large.ply", mesh);
    const std::string small = written(folder, "small.ply", blob(2, 1));
    for (const std::vector<std::string>& arguments : commands(folder, large, small)) {
      const Outcome outcome = whittle(arguments);
      EXPECT_EQ(outcome.exit_code, 4) << arguments[0] << ": " << outcome;
      const std::string said = whole ? "vertex " : "vertex 7, counted from 0, lies at 0.5 1e+200 2";
      EXPECT_NE(outcome.err.find("large.ply: coordinates too large: " + said), std::string::npos) << outcome;
    }
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"large.ply", "small.ply"}));
  }
}

}  // namespace
}  // namespace whittle::test
