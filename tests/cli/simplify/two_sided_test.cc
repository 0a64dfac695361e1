// Sheets that have each face twice, front and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program/program.hh"
#include "program/simplified.hh"
#include "support/shapes/shapes.hh"
#include "support/shapes/two_sided.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

/// 1600 faces with both sides.
std::string write_sheet(const TemporaryFolder& folder, const std::string& name = "sheet.ply") {
  const std::string path = folder / name;
  io::write_mesh(path, with_backs(noisy_grid(20, 20, 0.2, 5)));
  return path;
}

/// Texture, normals and material of either side, on the same vertices, as SketchUp writes them.
std::string write_painted_sheet(const TemporaryFolder& folder) {
  const IndexedMesh front = noisy_grid(20, 20, 0.05, 5);
  std::string text = "mtllib sheet.mtl\nvn 0 0 1\nvn 0 0 -1\n";
  const auto number = [](double x) { return std::to_string(x); };
  for (const Vec3& p : front.positions) {
    text += "v " + number(p.x()) + ' ' + number(p.y()) + ' ' + number(p.z()) + '\n';
    text += "vt " + number(p.x() / 20) + ' ' + number(p.y() / 20) + '\n';
  }
  for (const Vec3& p : front.positions) text += "vt " + number(1 - p.x() / 20) + ' ' + number(p.y() / 20) + '\n';
  for (const auto& [a, b, c] : front.faces) {
    const auto corner = [&](Index v, std::size_t first, const char* normal) {
      return ' ' + std::to_string(v + 1) + '/' + std::to_string(first + v + 1) + '/' + normal;
    };
    const std::size_t n = front.positions.size();
    text += "usemtl wood\nf" + corner(a, 0, "1") + corner(b, 0, "1") + corner(c, 0, "1") + '\n';
    text += "usemtl paint\nf" + corner(b, n, "2") + corner(a, n, "2") + corner(c, n, "2") + '\n';
  }
  write_text(folder / "sheet.obj", text);
  write_text(folder / "sheet.mtl", "newmtl wood\nKd 1 1 1\nnewmtl paint\nKd 1 0 0\n");
  return folder / "sheet.obj";
}

TEST(TwoSided, SheetsReachTheirTargetByDefault) {
  const TemporaryFolder folder;
  const Simplified run = simplify(write_sheet(folder), {"--faces", "200"});
  EXPECT_EQ(run.report["target"]["met"], true);
  EXPECT_EQ(run.report["input"]["faces"], 1600);
  EXPECT_EQ(run.report["output"]["faces"], run.mesh.faces.size());
  EXPECT_LE(run.mesh.faces.size(), 200U);
  EXPECT_GE(run.mesh.faces.size(), 198U);
}

TEST(TwoSided, SheetsKeepBothMaterialsAndTextures) {
  const TemporaryFolder folder;
  for (const std::string output : {"out.obj", "out.glb", "out.ply"}) {
    const std::string path = folder / output;
    const Outcome outcome = whittle({"simplify", write_painted_sheet(folder), "-o", path, "--faces", "200"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_THAT(outcome.err, testing::Not(testing::HasSubstr("chart of its own"))) << "their rims are no seams";
    if (output == "out.glb") {
      const std::string back = folder / "back.obj";
      EXPECT_EQ(whittle({"simplify", path, "-o", back, "--faces", "100"}).exit_code, 0);
      const IndexedMesh small = io::read_mesh(back).mesh;
      EXPECT_LE(small.faces.size(), 100U);
      EXPECT_GE(small.faces.size(), 96U);
      continue;
    }
    const IndexedMesh mesh = io::read_mesh(path).mesh;
    EXPECT_LE(mesh.faces.size(), 200U);
    EXPECT_GE(mesh.faces.size(), 196U);
    if (output == "out.ply") continue;
    ASSERT_EQ(mesh.group_names.size(), 2U);
    ASSERT_EQ(mesh.attributes.size(), 1U);
    const bool is_first_wood = mesh.group_names[0].find("wood") != std::string::npos;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const bool is_front = (mesh.face_groups[f] == 0) == is_first_wood;
      for (std::size_t k = 0; k < 3; ++k) {
        const double u = mesh.positions[mesh.faces[f][k]].x() / 20;
        EXPECT_NEAR(mesh.attributes[0].value(mesh.wedge(f, k))[0], is_front ? u : 1 - u, 1e-4);
        EXPECT_EQ(mesh.normals[mesh.wedge(f, k)][2], is_front ? 1 : -1);
      }
    }
  }
}

TEST(TwoSided, RecordingsEndWithTheResultOfTheRun) {
  const TemporaryFolder folder;
  const std::string rec = folder / "rec";
  for (const std::string& mesh : {write_sheet(folder), write_painted_sheet(folder)}) {
    const std::string extension = mesh.substr(mesh.size() - 4);
    const std::string small = folder / ("small" + extension);
    const std::string level = folder / ("level" + extension);
    for (const std::string effort : {"fast", "normal", "best"}) {
      const Outcome run =
          whittle({"simplify", mesh, "-o", small, "--faces", "150", "--effort", effort, "--record", rec});
      EXPECT_EQ(run.exit_code, 0) << run;
      const Outcome replay = whittle({"replay", rec, "--input", mesh, "--at", "1", "-o", level});
      EXPECT_EQ(replay.exit_code, 0) << replay;
      EXPECT_TRUE(read_text(small) == read_text(level)) << mesh << ", " << effort;
    }
  }
}

TEST(TwoSided, SheetsKeepALimitOfTheErrorThatIsVerified) {
  const TemporaryFolder folder;
  const std::string mesh = write_sheet(folder);
  const std::string out = folder / "out.ply";
  const std::string certificate = folder / "proof";
  const Outcome run = whittle({"simplify", mesh, "-o", out, "--max-error", "0.3", "--certificate", certificate});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_LT(io::read_mesh(out).mesh.faces.size(), 800U);
  const Outcome verified = whittle({"verify", mesh, out, certificate});
  EXPECT_EQ(verified.exit_code, 0) << verified;
}

TEST(TwoSided, SheetsHaveLevels) {
  const TemporaryFolder folder;
  const Outcome run = whittle({"lod", write_sheet(folder), "-o", folder / "lod.glb", "--faces", "800,200,50"});
  EXPECT_EQ(run.exit_code, 0) << run;
}

}  // namespace
}  // namespace whittle::test
