// Borders with narrow gaps, and parts that nearly touch.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program/program.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

/// Writes a soup whose corners differ by rounding.
std::string write_rounded_soup(const TemporaryFolder& folder) {
  IndexedMesh mesh = soup(torus(40, 20));
  Random random(1);
  for (Vec3& p : mesh.positions) p += random.uniform_vector(-1e-7, 1e-7);
  const std::string path = folder / "soup.ply";
  io::write_mesh(path, mesh);
  return path;
}

std::string write_near_spheres(const TemporaryFolder& folder) {
  const std::string path = folder / "spheres.ply";
  IndexedMesh mesh = spheres(4, 4, 0.001);
  Random random(2);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double y = mesh.positions[v].y();
    mesh.positions[v].y() = 0.8 * y + 0.6 * mesh.positions[v].z();  // vertices don't face vertices
    mesh.positions[v].z() = 0.8 * mesh.positions[v].z() - 0.6 * y;
  }
  io::write_mesh(path, mesh);
  return path;
}

TEST(Weld, ByToleranceMakesASurfaceOfARoundedSoup) {
  const TemporaryFolder folder;
  const std::string mesh = write_rounded_soup(folder);
  const std::vector<std::string> run{"simplify", mesh, "-o", folder / "out.ply", "--faces", "200", "--json", "-"};
  const Outcome apart = whittle(run);
  EXPECT_EQ(apart.exit_code, 0);
  EXPECT_EQ(parse_json(apart.out)["target"]["met"], false);
  EXPECT_NE(apart.err.find("'--weld auto' or"), std::string::npos) << apart;
  for (const char* tolerance : {"auto", "0.001", "0.01%"}) {
    std::vector<std::string> welding = run;
    welding.insert(welding.end(), {"--weld", tolerance});
    const Outcome welded = whittle(welding);
    const auto json = parse_json(welded.out);
    EXPECT_EQ(json["target"]["met"], true) << tolerance << welded;
    EXPECT_EQ(json["input"]["vertices"], 800) << tolerance;
    EXPECT_EQ(json["input"]["repairs"]["welded_vertices"], 4800 - 800);
    EXPECT_EQ(json["output"]["closed"], true);
    EXPECT_GT(json["input"]["weld_tolerance"], 0);
    EXPECT_EQ(json["options"]["weld_tolerance"], tolerance);
  }
}

TEST(Weld, IsShownByInfoBeforeAnythingIsSimplified) {
  const TemporaryFolder folder;
  const std::string mesh = write_rounded_soup(folder);
  EXPECT_EQ(parse_json(whittle({"info", mesh, "--json", "-"}).out)["weld_tolerance"], 0);
  const auto json = parse_json(whittle({"info", mesh, "--weld", "auto", "--json", "-"}).out);
  EXPECT_EQ(json["vertices"], 800);
  EXPECT_EQ(json["closed"], true);
  EXPECT_EQ(json["unwelded"]["vertices"], 4800);
  EXPECT_EQ(json["repairs"]["welded_vertices"], 4800 - 800);
  EXPECT_GT(json["weld_tolerance"], 0);
}

TEST(Weld, IsAdvisedWhereTheTargetIsMetToo) {
  const TemporaryFolder folder;
  const std::string mesh = write_rounded_soup(folder);
  const Outcome outcome = whittle({"simplify", mesh, "-o", folder / "out.ply", "--faces", "1600"});
  EXPECT_NE(outcome.err.find("gaps between borders; '--weld auto' welds 4000 vertices"), std::string::npos) << outcome;
  const Outcome refused = whittle({"simplify", mesh, "-o", folder / "out.ply", "--faces", "1600", "--no-weld"});
  EXPECT_EQ(refused.err.find("--weld auto"), std::string::npos) << refused;
}

/// So many parts can't get to 4 faces, with or without gaps.
TEST(Weld, IsAdvisedWhereItDoesNotReachTheTarget) {
  const TemporaryFolder folder;
  const std::string mesh = write_rounded_soup(folder);
  const Outcome outcome = whittle({"simplify", mesh, "-o", folder / "out.ply", "--faces", "4"});
  EXPECT_NE(outcome.err.find("target not met"), std::string::npos) << outcome;
  EXPECT_NE(outcome.err.find("gaps between borders; '--weld auto' welds 4000 vertices"), std::string::npos) << outcome;
}

TEST(Weld, SaysIfThereAreNoGaps) {
  const TemporaryFolder folder;
  const Outcome outcome =
      whittle({"simplify", data_file("terrain.ply"), "-o", folder / "out.ply", "--faces", "500", "--weld", "auto"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_NE(outcome.err.find("no gaps between borders"), std::string::npos) << outcome;
}

TEST(Weld, KeepsTheVertexMapTrue) {
  const TemporaryFolder folder;
  const std::string mesh = write_rounded_soup(folder);
  const Outcome outcome = whittle({"simplify", mesh, "-o", folder / "out.ply", "--faces", "1600", "--weld", "auto",
                                   "--map", folder / "map", "--effort", "fast"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  std::istringstream lines(read_text(folder / "map"));
  std::vector<long> map;
  for (long v = 0; lines >> v;) map.push_back(v);
  ASSERT_EQ(map.size(), 4800U);
  const IndexedMesh before = soup(torus(40, 20));
  for (std::size_t v = 0; v < map.size(); ++v) {
    ASSERT_GE(map[v], 0);
    ASSERT_LT(map[v], 800);
    for (std::size_t w = 0; w < v && v < 300; ++w) {
      EXPECT_EQ(map[v] == map[w], before.positions[v] == before.positions[w]) << v << ' ' << w;
    }
  }
}

TEST(CloseParts, AreWarnedOfIfTheyMeet) {
  const TemporaryFolder folder;
  const std::string mesh = write_near_spheres(folder);
  const std::vector<std::string> run{"simplify", mesh, "-o", folder / "out.ply", "--face-ratio", "2%", "--json", "-"};
  const Outcome met = whittle(run);
  EXPECT_NE(met.err.find("of parts intersect"), std::string::npos) << met;
  EXPECT_NE(met.err.find("'--self-intersections refuse'"), std::string::npos) << met;
  EXPECT_EQ(parse_json(met.out)["output"]["self_intersections"], nullptr);

  std::vector<std::string> counting = run;
  counting.insert(counting.end(), {"--self-intersections", "count"});
  const Outcome counted = whittle(counting);
  EXPECT_EQ(parse_json(counted.out)["input"]["self_intersections"], 0);
  EXPECT_GT(parse_json(counted.out)["output"]["self_intersections"], 0);
  EXPECT_NE(counted.err.find(" self-intersections"), std::string::npos) << counted;

  counting.back() = "refuse";
  const Outcome refused = whittle(counting);
  const auto json = parse_json(refused.out);
  EXPECT_EQ(json["output"]["self_intersections"], 0) << refused;
  EXPECT_GT(json["rejections"]["intersection"], 0);
  EXPECT_EQ(json["target"]["met"], true) << refused;
  EXPECT_EQ(refused.err.find("of parts intersect"), std::string::npos) << refused;
}

TEST(CloseParts, ThatAreLeftAreCounted) {
  const TemporaryFolder folder;
  const std::vector<std::string> run{"simplify", data_file("cubes.obj"), "-o", folder / "out.obj", "--faces", "60"};
  std::vector<std::string> joining = run;
  joining.insert(joining.end(), {"--threshold", "auto", "--json", "-"});
  const Outcome joined = whittle(joining);
  const std::size_t n_left = parse_json(joined.out)["output"]["components"];
  EXPECT_NE(joined.err.find(", 25 -> " + std::to_string(n_left) + (n_left == 1 ? " part in" : " parts in")),
            std::string::npos)
      << joined;
  EXPECT_EQ(whittle(run).err.find("25 -> "), std::string::npos);
}

TEST(ThinWalls, AreWarnedOfIfTheyCross) {
  const TemporaryFolder folder;
  const std::string mesh = folder / "wall.ply";
  io::write_mesh(mesh, thin_wall(60));
  const std::vector<std::string> run{"simplify", mesh, "-o", folder / "out.ply", "--face-ratio", "4%", "--json", "-"};
  const Outcome crossing = whittle(run);
  const std::string warning = "pairs of faces of one part cross that didn't before; '--self-intersections refuse'";
  EXPECT_NE(crossing.err.find(warning), std::string::npos) << crossing;
  EXPECT_NE(parse_json(crossing.out)["warnings"].dump().find(warning), std::string::npos) << crossing;

  std::vector<std::string> refusing = run;
  refusing.insert(refusing.end(), {"--self-intersections", "refuse"});
  const Outcome refused = whittle(refusing);
  const auto json = parse_json(refused.out);
  EXPECT_LE(json["output"]["self_intersections"], json["input"]["self_intersections"]) << refused;
  EXPECT_EQ(refused.err.find(" cross"), std::string::npos) << refused;
}

}  // namespace
}  // namespace whittle::test
