// What `simplify` does with a mesh: targets, options, engines.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "program/simplified.hh"
#include "whittle/io/read.hh"
#include "whittle/metrics/line_distance.hh"
#include "whittle/metrics/lines.hh"

namespace whittle::test {
namespace {

std::size_t n_faces(const Simplified& result) { return result.mesh.faces.size(); }
std::size_t n_vertices(const Simplified& result) { return result.mesh.positions.size(); }

std::set<std::array<double, 3>> positions_of(const IndexedMesh& mesh) {
  std::set<std::array<double, 3>> positions;
  for (const Vec3& p : mesh.positions) positions.insert({p.x(), p.y(), p.z()});
  return positions;
}

TEST(Simplify, ReachesTheNumberOfFaces) {
  for (const std::size_t faces : {5000U, 1000U, 300U}) {
    const Simplified result = simplify(data_file("blob.obj"), {"--faces", std::to_string(faces)});
    EXPECT_EQ(n_faces(result), faces);
    EXPECT_EQ(result.report["target"], (nlohmann::json{{"faces", faces}, {"met", true}}));
    EXPECT_EQ(result.report["stop"], "target");
  }
  // The number of faces of a closed mesh falls by two.
  EXPECT_EQ(n_faces(simplify(data_file("blob.obj"), {"--faces", "301"})), 300U);
}

TEST(Simplify, ReachesTheNumberOfVertices) {
  const Simplified result = simplify(data_file("blob.obj"), {"--vertices", "777"});
  EXPECT_EQ(n_vertices(result), 777U);
  EXPECT_EQ(result.report["target"], (nlohmann::json{{"vertices", 777}, {"met", true}}));
}

TEST(Simplify, KeepsTheShareOfTheVerticesRoundedDown) {
  // 2562 vertices.
  EXPECT_EQ(n_vertices(simplify(data_file("blob.obj"), {"--ratio", "0.3"})), 768U);
  const Simplified by_faces = simplify(data_file("terrain.ply"), {"--face-ratio", "10%"});
  EXPECT_EQ(by_faces.report["target"]["faces"], 460);  // of 4608
  EXPECT_EQ(by_faces.report["target"]["face_ratio"], 0.1);
  EXPECT_LE(n_faces(by_faces), 460U);
  EXPECT_GE(n_faces(by_faces), 459U);
  EXPECT_EQ(n_vertices(simplify(data_file("blob.obj"), {"-r", "30%"})), 768U);
  EXPECT_EQ(n_vertices(simplify(data_file("blob.obj"), {"-r0.5"})), 1281U);
  // 200 vertices: 0.29 · 200 is a little below 58 in binary.
  const Simplified result = simplify(data_file("cubes.obj"), {"--ratio", "0.58"});
  EXPECT_EQ(result.report["target"]["vertices"], 116);
  EXPECT_EQ(simplify(data_file("flat.off"), {"--ratio", "0.29"}).report["target"]["vertices"], 181);
  EXPECT_EQ(result.report["target"]["ratio"], 0.58);
}

TEST(Simplify, CountsAfterTheRepairs) {
  // 4428 corners in the file, 738 vertices.
  const Simplified result = simplify(data_file("bracket.stl"), {"--ratio", "0.5"});
  EXPECT_EQ(n_vertices(result), 369U);
  EXPECT_EQ(result.report["input"]["vertices"], 738);
  EXPECT_EQ(result.report["input"]["repairs"]["welded_vertices"], 3690);
}

TEST(Simplify, StopsAtTheFirstTargetReached) {
  EXPECT_EQ(n_faces(simplify(data_file("blob.obj"), {"--faces", "1000", "--vertices", "100"})), 1000U);
  EXPECT_EQ(n_vertices(simplify(data_file("blob.obj"), {"--faces", "100", "--vertices", "1000"})), 1000U);
  EXPECT_EQ(n_vertices(simplify(data_file("blob.obj"), {"--ratio", "0.3", "--vertices", "100"})), 768U);
  EXPECT_EQ(n_faces(simplify(data_file("blob.obj"), {"--face-ratio", "0.25", "--faces", "100"})), 1280U);
  const Simplified result = simplify(data_file("blob.obj"), {"--faces", "4", "--max-cost", "1e-6"});
  EXPECT_GT(n_faces(result), 4U);
  EXPECT_EQ(result.report["stop"], "cost");
  EXPECT_EQ(result.report["target"]["met"], false);
}

TEST(Simplify, KeepsToTheCostLimit) {
  std::size_t before = 5120;
  for (const std::string limit : {"1e-8", "1e-6", "1e-4"}) {
    const Simplified result = simplify(data_file("blob.obj"), {"--max-cost", limit});
    EXPECT_LE(result.report["max_cost"].get<double>(), std::stod(limit));
    EXPECT_LT(n_faces(result), before) << "a greater limit leaves fewer faces; limit " << limit;
    before = n_faces(result);
  }
}

TEST(Simplify, LeavesAMeshAloneThatIsSmallEnough) {
  const Simplified result = simplify(data_file("cubes.obj"), {"--faces", "300"});
  EXPECT_EQ(result.report["contractions"], 0);
  EXPECT_EQ(result.report["target"]["met"], true);
  EXPECT_EQ(positions_of(result.mesh), positions_of(io::read_mesh(data_file("cubes.obj")).mesh));
}

TEST(Simplify, KeepsAClosedSurfaceClosed) {
  for (const char* name : {"knot.ply", "blob.obj", "bracket.stl"}) {
    const Simplified result = simplify(data_file(name), {"--ratio", "0.1"});
    const auto& output = result.report["output"];
    EXPECT_EQ(output["closed"], true) << name;
    EXPECT_EQ(output["manifold"], true) << name;
    EXPECT_EQ(output["components"], 1) << name;
    EXPECT_EQ(output["genus"], std::string(name) == "blob.obj" ? 0 : 1) << name;
    EXPECT_EQ(output["vanished_components"], 0) << name;
  }
}

TEST(Simplify, PlacesVerticesAsAsked) {
  const IndexedMesh input = io::read_mesh(data_file("blob.obj")).mesh;
  const auto n_old = [before = positions_of(input)](const Simplified& result) {
    std::size_t count = 0;
    for (const auto& p : positions_of(result.mesh)) count += before.count(p);
    return count;
  };
  const Simplified endpoint = simplify(data_file("blob.obj"), {"--faces", "500", "--placement", "endpoint"});
  EXPECT_EQ(n_old(endpoint), n_vertices(endpoint));
  const Simplified midpoint = simplify(data_file("blob.obj"), {"--faces", "500", "--placement", "midpoint"});
  const Simplified optimal = simplify(data_file("blob.obj"), {"--faces", "500", "--placement", "optimal"});
  EXPECT_LT(n_old(midpoint), n_vertices(midpoint) / 2);
  EXPECT_LT(n_old(optimal), n_vertices(optimal) / 2);
  EXPECT_NE(positions_of(midpoint.mesh), positions_of(optimal.mesh));
}

TEST(Simplify, WeighsFacesAsAsked) {
  std::set<std::set<std::array<double, 3>>> results;
  for (const char* weights : {"area", "uniform", "area-angle"}) {
    const Simplified result = simplify(data_file("blob.obj"), {"--faces", "500", "--weights", weights});
    EXPECT_EQ(result.report["options"]["weights"], weights);
    results.insert(positions_of(result.mesh));
  }
  EXPECT_EQ(results.size(), 3U) << "each kind of weights gives another result";
}

/// The largest distance of the border from where it was.
double border_error(const std::string& input, const IndexedMesh& result) {
  return metrics::line_distance(metrics::border_lines(io::read_mesh(input).mesh), metrics::border_lines(result), {})
      ->max;
}

TEST(Simplify, TreatsBordersAsAsked) {
  const std::string terrain = data_file("terrain.ply");
  for (const char* effort : {"fast", "normal"}) {
    const auto error_with = [&](const std::string& option, const std::string& value) {
      return border_error(terrain, simplify(terrain, {"--faces", "400", "--effort", effort, option, value}).mesh);
    };
    const double weighted = error_with("--boundary", "weighted");
    EXPECT_EQ(error_with("--boundary", "locked"), 0) << effort;
    EXPECT_GT(weighted, 0) << effort;
    EXPECT_GT(error_with("--boundary", "free"), 5 * weighted) << effort;
    EXPECT_NE(error_with("--boundary-weight", "1e6"), weighted) << effort;
  }
}

TEST(Simplify, RefusesToTurnFacesFurtherThanAsked) {
  const auto flips = [](const char* degrees) {
    return simplify(data_file("knot.ply"), {"--ratio", "0.05", "--max-normal-flip", degrees})
        .report["rejections"]["flip"]
        .get<std::size_t>();
  };
  EXPECT_GT(flips("10"), 10 * flips("75"));
  EXPECT_GE(flips("75"), flips("180"));
}

TEST(Simplify, WeldsUnlessToldNotTo) {
  EXPECT_EQ(simplify(data_file("bracket.stl"), {"--faces", "700"}).report["output"]["closed"], true);
  const Simplified apart = simplify(data_file("bracket.stl"), {"--faces", "700", "--no-weld"});
  EXPECT_EQ(apart.report["input"]["vertices"], 4428);
  EXPECT_EQ(apart.report["options"]["weld"], false);
  EXPECT_EQ(apart.report["target"]["met"], false) << "single triangles can't be contracted";
}

TEST(Simplify, GivesTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "2", "7"}) {
    const std::string out = folder / (std::string("out") + threads + ".ply");
    EXPECT_EQ(whittle({"simplify", data_file("knot.ply"), "-o", out, "-r", "10%", "--threads", threads}).exit_code, 0);
    EXPECT_EQ(read_text(out), read_text(folder / "out1.ply")) << threads << " threads";
  }
}

TEST(Simplify, CarriesColours) {
  const Simplified result = simplify(data_file("terrain.ply"), {"--ratio", "0.2"});
  EXPECT_EQ(result.mesh.colors.size(), n_vertices(result));
  EXPECT_EQ(result.report["warnings"].size(), 0U);
}

TEST(Simplify, NamesWhatItDoesNotCarry) {
  const TemporaryFolder folder;
  write_text(folder / "uv.obj",
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 2/2 4/1 3/3\nl 1 2\n");
  const Outcome outcome =
      whittle({"simplify", folder / "uv.obj", "-o", folder / "out.obj", "--faces", "2", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_NE(outcome.err.find("whittle: warning: " + folder / "uv.obj" + ": "), std::string::npos) << outcome;
  EXPECT_NE(outcome.err.find("lines and points"), std::string::npos) << outcome;
  EXPECT_EQ(parse_json(outcome.out)["warnings"].size(), 1U);
}

TEST(Simplify, JoinsPartsThatLieCloserThanTheThreshold) {
  const Simplified apart = simplify(data_file("cubes.obj"), {"--faces", "60", "--topology", "keep"});
  EXPECT_EQ(n_faces(apart), 100U) << "25 cubes can't have fewer than 4 faces each";
  EXPECT_EQ(apart.report["output"]["components"], 25);
  EXPECT_EQ(apart.report["threshold_pairs"]["considered"], 0);

  const Simplified joined = simplify(data_file("cubes.obj"), {"--faces", "60", "--threshold", "auto"});
  EXPECT_LE(n_faces(joined), 60U);
  EXPECT_EQ(joined.report["target"]["met"], true);
  EXPECT_EQ(joined.report["options"]["threshold"], "auto");
  EXPECT_NEAR(joined.report["threshold_pairs"]["threshold"].get<double>(), 0.22, 1e-6) << "the gap is 0.2";
  EXPECT_EQ(joined.report["threshold_pairs"]["considered"], 160) << "4 at each of 2 · 5 · 4 gaps";
  EXPECT_GT(joined.report["threshold_pairs"]["contracted"], 100);
  EXPECT_EQ(joined.report["input"]["components"], 25);
  EXPECT_LT(joined.report["output"]["components"], 25);

  const Simplified by_length = simplify(data_file("cubes.obj"), {"--faces", "60", "-t", "0.22"});
  EXPECT_EQ(by_length.mesh.positions, joined.mesh.positions);
  const Simplified too_near = simplify(data_file("cubes.obj"), {"--faces", "150", "-t", "0.1%"});
  EXPECT_EQ(too_near.report["threshold_pairs"]["considered"], 0);
  EXPECT_NEAR(too_near.report["threshold_pairs"]["threshold"].get<double>(),
              too_near.report["input"]["diagonal"].get<double>() / 1000, 1e-12);
}

TEST(Simplify, KeepsTheNearestPairsOnly) {
  const Simplified capped =
      simplify(data_file("cubes.obj"), {"--faces", "150", "-t", "50%", "--max-pairs", "2", "--across-walls"});
  EXPECT_EQ(capped.report["threshold_pairs"]["capped"], true);
  EXPECT_LE(capped.report["threshold_pairs"]["considered"], 2 * 200);
  const Simplified all =
      simplify(data_file("cubes.obj"), {"--faces", "150", "-t", "50%", "--max-pairs", "0", "--across-walls"});
  EXPECT_EQ(all.report["threshold_pairs"]["capped"], false);
  EXPECT_GT(all.report["threshold_pairs"]["considered"], 2 * 200);
}

TEST(Simplify, SaysThatThereIsNothingToJoin) {
  const Simplified one_part = simplify(data_file("blob.obj"), {"--faces", "500", "-t", "auto"});
  EXPECT_EQ(one_part.report["threshold_pairs"]["threshold"], 0.0);
  EXPECT_EQ(one_part.report["warnings"].size(), 1U);
}

TEST(Simplify, LetsPartsVanishIfTheTopologyIsFree) {
  const Simplified result =
      simplify(data_file("cubes.obj"), {"--faces", "40", "--topology", "free", "--max-normal-flip", "180"});
  EXPECT_LE(n_faces(result), 40U);
  EXPECT_GT(result.report["output"]["vanished_components"], 10);
}

TEST(Simplify, DropsPartsThatAreTooSmall) {
  const TemporaryFolder folder;
  write_text(folder / "dust.off",
             "OFF\n11 9 0\n5 5 5\n5.1 5 5\n5 5.1 5\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
             "3 0 1 2\n3 3 4 5\n3 4 6 5\n3 7 8 9\n3 8 10 9\n3 3 7 5\n3 7 9 5\n3 4 8 6\n3 8 10 6\n");
  const Simplified pruned = simplify(folder / "dust.off", {"--faces", "9", "--prune", "0.5"});
  EXPECT_EQ(pruned.report["output"]["pruned_components"], 1);
  EXPECT_EQ(n_faces(pruned), 8U);
  EXPECT_EQ(n_vertices(pruned), 8U);
  EXPECT_EQ(simplify(folder / "dust.off", {"--faces", "9", "--prune", "1%"}).report["output"]["pruned_components"], 0);
  const Outcome all =
      whittle({"simplify", folder / "dust.off", "-o", folder / "out.off", "--faces", "9", "--prune", "9"});
  EXPECT_EQ(all.exit_code, 4) << all;
  EXPECT_NE(all.err.find("--prune"), std::string::npos) << all;
}

TEST(Simplify, WorksInOpenMeshToo) {
  const Simplified flat = simplify(data_file("blob.obj"), {"--faces", "500"});
  const Simplified openmesh = simplify(data_file("blob.obj"), {"--faces", "500", "--engine", "openmesh"});
  EXPECT_EQ(n_faces(openmesh), 500U);
  EXPECT_EQ(openmesh.report["options"]["engine"], "openmesh");
  EXPECT_EQ(openmesh.report["output"]["closed"], true);
  EXPECT_EQ(openmesh.report["contractions"], flat.report["contractions"]);
  EXPECT_EQ(openmesh.report["rejections"]["link"], nullptr) << "OpenMesh doesn't say";
  EXPECT_GE(openmesh.report["max_cost"], flat.report["max_cost"]) << "its order is less exact";

  EXPECT_EQ(simplify(data_file("blob.obj"), {"--vertices", "300", "--engine", "openmesh"}).mesh.positions.size(), 300U);
  const Simplified locked =
      simplify(data_file("terrain.ply"), {"--faces", "1000", "--boundary", "locked", "--engine", "openmesh"});
  EXPECT_EQ(border_error(data_file("terrain.ply"), locked.mesh), 0);
  const auto& warnings = locked.report["warnings"];
  const auto is_of_colors = [](const auto& warning) {
    return warning.template get<std::string>().find("colours are not carried") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(), is_of_colors), 1) << warnings;
}

}  // namespace
}  // namespace whittle::test
