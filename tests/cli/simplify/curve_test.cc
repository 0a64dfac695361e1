#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/program.hh"
#include "support/temporary_folder.hh"

namespace whittle::test {
namespace {

/// The numbers of a file written by --curve, a row a level.
std::vector<std::vector<double>> read_curve(const std::string& path) {
  std::istringstream lines(read_text(path));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "faces,vertices,max_cost,mean,rms,max");
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
    EXPECT_EQ(rows.back().size(), 6U);
  }
  return rows;
}

TEST(Curve, GoesFromTheInputToTheResult) {
  const TemporaryFolder folder;
  const std::string out = folder / "out.ply";
  const std::string csv = folder / "curve.csv";
  for (const std::string mesh : {"blob.obj", "terrain.ply", "cubes.obj"}) {
    const Outcome outcome =
        whittle({"simplify", data_file(mesh), "-o", out, "--face-ratio", "10%", "--curve", csv, "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    const auto report = nlohmann::json::parse(outcome.out);
    const auto rows = read_curve(csv);
    ASSERT_GE(rows.size(), 5U);
    EXPECT_EQ(rows.front()[0], report["input"]["faces"]);
    EXPECT_EQ(rows.front()[5], 0);
    EXPECT_EQ(rows.back()[0], report["output"]["faces"]);
    EXPECT_EQ(rows.back()[2], report["max_cost"]);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      EXPECT_LT(rows[i][0], rows[i - 1][0]);
      EXPECT_GE(rows[i][2], rows[i - 1][2]);
      EXPECT_LE(rows[i][3], rows[i][4]);
      EXPECT_LE(rows[i][4], rows[i][5]);
    }
    const Outcome measured =
        whittle({"measure", data_file(mesh), out, "--samples", "100000", "--no-weld", "--json", "-"});
    ASSERT_EQ(measured.exit_code, 0) << measured;
    EXPECT_NEAR(nlohmann::json::parse(measured.out)["mean"], rows.back()[3], 1e-3 * rows.back()[3]) << mesh;
    ASSERT_EQ(report["curve"].size(), rows.size());
    EXPECT_EQ(report["curve"].back()["rms"], rows.back()[4]);
  }
}

TEST(Curve, IsADrawingToo) {
  const TemporaryFolder folder;
  const std::string svg = folder / "curve.svg";
  ASSERT_EQ(whittle({"simplify", data_file("blob.obj"), "-o", folder / "out.ply", "--faces", "500", "--curve", svg})
                .exit_code,
            0);
  const std::string drawing = read_text(svg);
  EXPECT_TRUE(drawing.starts_with("<svg xmlns"));
  EXPECT_TRUE(drawing.ends_with("</svg>\n"));
  std::size_t n_lines = 0;
  for (std::size_t at = 0; (at = drawing.find("<polyline", at)) != std::string::npos; ++at) ++n_lines;
  EXPECT_EQ(n_lines, 3U);
}

TEST(Curve, NeedsANameThatSaysWhatItIs) {
  const TemporaryFolder folder;
  expect_usage_error(whittle({"simplify", data_file("blob.obj"), "-o", folder / "o.ply", "--faces", "500", "--curve",
                              folder / "curve"}),
                     {"--curve", ".csv", ".svg"});
}

}  // namespace
}  // namespace whittle::test
