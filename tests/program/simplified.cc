#include "program/simplified.hh"

#include <gtest/gtest.h>

#include "whittle/io/read.hh"

namespace whittle::test {

Simplified simplify(const std::string& input, const std::vector<std::string>& more) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments{"simplify", input, "-o", folder / "out.ply", "--json", "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Simplified result;
  result.outcome = whittle(arguments);
  EXPECT_EQ(result.outcome.exit_code, 0) << result.outcome;
  result.report = parse_json(result.outcome.out);
  result.mesh = io::read_mesh(folder / "out.ply", {.weld = false}).mesh;
  EXPECT_EQ(result.report["output"]["faces"], result.mesh.faces.size());
  EXPECT_EQ(result.report["output"]["vertices"], result.mesh.positions.size());
  return result;
}

}  // namespace whittle::test
