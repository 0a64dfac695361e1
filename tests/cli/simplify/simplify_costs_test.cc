// What the costs and guards of `simplify` do to a result.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "program/simplified.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/io/read.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/line_distance.hh"
#include "whittle/metrics/lines.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

double mean_error(const std::string& input, const IndexedMesh& result) {
  metrics::DistanceOptions options;
  options.samples = 50000;
  return metrics::surface_distance(io::read_mesh(input).mesh, result, options).mean;
}

Simplified with(const std::string& mesh, const std::string& ratio, std::vector<std::string> more) {
  more.insert(more.begin(), {"--ratio", ratio});
  return simplify(mesh, more);
}

TEST(SimplifyCosts, LindstromTurkIsMoreAccurate) {
  const std::string knot = data_file("knot.ply");
  const double plain = mean_error(knot, with(knot, "5%", {"--effort", "fast", "--cost", "quadric"}).mesh);
  const Simplified exact = with(knot, "5%", {"--effort", "fast", "--cost", "lindstrom-turk"});
  const Simplified approximate =
      with(knot, "5%", {"--effort", "fast", "--cost", "lindstrom-turk", "--order", "approximate"});
  EXPECT_EQ(exact.report["options"]["cost"], "lindstrom-turk");
  EXPECT_EQ(exact.report["options"]["max_normal_flip_deg"], 110);
  EXPECT_EQ(approximate.report["options"]["order"], "approximate");
  EXPECT_LT(mean_error(knot, exact.mesh), 0.9 * plain);
  EXPECT_LT(mean_error(knot, approximate.mesh), 0.95 * plain);
  EXPECT_EQ(exact.report["output"]["closed"], true);
  EXPECT_EQ(exact.report["output"]["genus"], 1);
}

TEST(SimplifyCosts, MoreEffortIsMoreAccurate) {
  const std::string knot = data_file("knot.ply");
  const Simplified plain = with(knot, "5%", {"--effort", "fast", "--cost", "quadric"});
  const Simplified fast = with(knot, "5%", {"--effort", "fast"});
  const Simplified normal = with(knot, "5%", {});
  const Simplified best = with(knot, "5%", {"--effort", "best"});
  EXPECT_EQ(fast.report["options"]["cost"], "memoryless");
  EXPECT_EQ(with(data_file("blob.obj"), "5%", {"--effort", "fast"}).report["options"]["cost"], "quadric") << "small";
  EXPECT_EQ(fast.report["options"]["polish"], 0);
  EXPECT_TRUE(fast.report["polish"].is_null());
  EXPECT_EQ(normal.report["options"]["effort"], "normal");
  EXPECT_EQ(normal.report["options"]["cost"], "memoryless");
  EXPECT_EQ(normal.report["options"]["max_normal_flip_deg"], 60);
  EXPECT_EQ(normal.report["options"]["order"], "approximate");
  EXPECT_EQ(normal.report["polish"]["passes"], 1);
  EXPECT_GT(normal.report["polish"]["moved"], 1000);
  EXPECT_LT(normal.report["polish"]["rms_after"], 0.97 * normal.report["polish"]["rms_before"].get<double>());
  EXPECT_EQ(best.report["options"]["polish"], 2);
  EXPECT_EQ(best.report["polish"]["passes"], 2);
  EXPECT_LT(mean_error(knot, fast.mesh), 0.9 * mean_error(knot, plain.mesh));
  EXPECT_LT(mean_error(knot, normal.mesh), 0.9 * mean_error(knot, fast.mesh));
  EXPECT_LT(mean_error(knot, normal.mesh), 0.8 * mean_error(knot, plain.mesh));
  EXPECT_LT(mean_error(knot, best.mesh), 0.99 * mean_error(knot, normal.mesh));
  EXPECT_NE(best.mesh.faces, normal.mesh.faces) << "edges are flipped";
  const Simplified three = with(knot, "5%", {"--polish", "3"});
  EXPECT_EQ(three.report["polish"]["passes"], 3);
  EXPECT_LT(mean_error(knot, three.mesh), 0.99 * mean_error(knot, normal.mesh));
}

/// Each option overrides what the effort would choose.
TEST(SimplifyCosts, CostAndPolishCanBeChosen) {
  const std::string blob = data_file("blob.obj");
  const auto options = [&](const std::vector<std::string>& more) { return with(blob, "10%", more).report["options"]; };
  EXPECT_EQ(options({"--effort", "fast", "--polish", "2"})["polish"], 2);
  EXPECT_EQ(options({"--effort", "fast", "--cost", "memoryless"})["cost"], "memoryless");
  EXPECT_EQ(options({"--polish", "0"})["cost"], "memoryless");
  EXPECT_EQ(options({"--max-normal-flip", "75"})["max_normal_flip_deg"], 75);
  EXPECT_EQ(options({"--effort", "fast"})["max_normal_flip_deg"], 75);
  EXPECT_EQ(options({"--polish", "0"})["polish"], 0);
  EXPECT_EQ(options({"--cost", "quadric"})["polish"], 1);
}

/// An option that doesn't go with the default cost changes the default to plain quadrics; it is no conflict.
TEST(SimplifyCosts, PlainQuadricsAreTheDefaultWithWhatOnlyTheyHave) {
  const std::string blob = data_file("blob.obj");
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--isotropic", "0.5"},
                                               {"--weights", "uniform"},
                                               {"--threshold", "1%", "--order", "exact"}}) {
    EXPECT_EQ(with(blob, "10%", more).report["options"]["cost"], "quadric") << more[0];
  }
  EXPECT_EQ(with(blob, "10%", {"--threshold", "1%"}).report["options"]["cost"], "memoryless");
}

/// Endpoint placement was asked for, so polish moves no vertex.
TEST(SimplifyCosts, PolishMovesNothingThatHasAPlaceOfItsOwn) {
  const IndexedMesh input = io::read_mesh(data_file("blob.obj")).mesh;
  const Simplified result = with(data_file("blob.obj"), "10%", {"--placement", "endpoint"});
  EXPECT_EQ(result.report["options"]["polish"], 0);
  for (const Vec3& p : result.mesh.positions) {
    const auto is_there = [&p](const Vec3& q) { return (p - q).norm() < 1e-6; };
    ASSERT_TRUE(std::any_of(input.positions.begin(), input.positions.end(), is_there));
  }
}

TEST(SimplifyCosts, PolishLeavesFeatureLinesWhereTheyAre) {
  const std::string bracket = data_file("bracket.stl");
  const Simplified plain = with(bracket, "30%", {"--cost", "memoryless", "--feature-angle", "40"});
  const Simplified polished = with(bracket, "30%", {"--cost", "memoryless", "--feature-angle", "40", "--polish", "2"});
  const auto lines = [](const IndexedMesh& mesh) { return metrics::feature_lines(mesh, 40); };
  const auto distance = metrics::line_distance(lines(plain.mesh), lines(polished.mesh), {});
  ASSERT_TRUE(distance.has_value());
  EXPECT_LT(distance->max, 1e-6 * diagonal_of(plain.mesh.positions));
}

TEST(SimplifyCosts, ValencePenaltyMakesValencesRegular) {
  const std::string blob = data_file("blob.obj");
  const auto plain = metrics::shape(with(blob, "10%", {}).mesh).valence;
  const auto regular = metrics::shape(with(blob, "10%", {"--valence", "0.5"}).mesh).valence;
  EXPECT_LT(plain.share_5_to_7, 0.95);
  EXPECT_GT(regular.share_5_to_7, 0.96);
  EXPECT_GT(regular.min, 3U);
}

TEST(SimplifyCosts, SaysWhereThreeEdgesAreLeft) {
  const Simplified cubes = with(data_file("cubes.obj"), "50%", {"--valence", "1"});
  ASSERT_GE(cubes.report["warnings"].size(), 1U) << "each cube has become a tetrahedron";
  EXPECT_NE(cubes.report["warnings"][0].get<std::string>().find("three edges"), std::string::npos);
}

TEST(SimplifyCosts, IsotropyMakesEdgesEven) {
  const std::string blob = data_file("blob.obj");
  double last = 1;
  for (const char* weight : {"0", "0.5", "1"}) {
    const Simplified result = with(blob, "10%", {"--isotropic", weight, "--polish", "0"});
    const double variation = metrics::shape(result.mesh).edge_length_cv;
    EXPECT_LT(variation, 0.95 * last) << weight;
    last = variation;
  }
  EXPECT_LT(last, 0.22);
  const Simplified midpoint = with(blob, "10%", {"--cost", "midpoint", "--polish", "0"});
  EXPECT_LT(metrics::shape(midpoint.mesh).edge_length_cv, 0.22);
}

TEST(SimplifyCosts, FeatureLinesStayWhereTheyWere) {
  const std::string bracket = data_file("bracket.stl");
  const IndexedMesh input = io::read_mesh(bracket).mesh;
  for (const char* cost : {"quadric", "lindstrom-turk", "midpoint"}) {
    const Simplified result = with(bracket, "20%", {"--feature-angle", "40", "--cost", cost});
    const auto distance =
        metrics::line_distance(metrics::feature_lines(input, 40), metrics::feature_lines(result.mesh, 40), {});
    ASSERT_TRUE(distance) << cost;
    const double diagonal = result.report["input"]["diagonal"].get<double>();
    EXPECT_LE(distance->max, 5.1e-4 * diagonal) << cost << ": both ways, with the rounding of STL";
  }
  const Simplified loose = with(bracket, "5%", {"--feature-angle", "40", "--feature-tolerance", "5%"});
  const Simplified tight = with(bracket, "5%", {"--feature-angle", "40", "--feature-tolerance", "0"});
  EXPECT_LT(loose.mesh.faces.size(), tight.mesh.faces.size());
  EXPECT_EQ(tight.report["target"]["met"], false);
  EXPECT_GT(tight.report["rejections"]["feature"], 0);
}

TEST(SimplifyCosts, FacesGetNoThinnerThanAllowed) {
  const auto least = [](const IndexedMesh& mesh) { return metrics::shape(mesh).radius_ratio_min; };
  const std::string blob = data_file("blob.obj");
  const double limit = 0.4;
  ASSERT_GT(least(io::read_mesh(blob).mesh), limit);
  EXPECT_LT(least(with(blob, "10%", {}).mesh), limit);
  const Simplified guarded = with(blob, "10%", {"--min-radius-ratio", "0.4"});
  EXPECT_GE(least(guarded.mesh), limit - 1e-6) << "but for the rounding of PLY";
  EXPECT_EQ(guarded.report["polish"]["passes"], 1);
  EXPECT_GT(guarded.report["rejections"]["shape"], 0);
}

TEST(SimplifyCosts, WorkInOpenMeshToo) {
  const std::string blob = data_file("blob.obj");
  const auto in_openmesh = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--engine", "openmesh"});
    return with(blob, "10%", more).mesh;
  };
  const double plain = mean_error(blob, in_openmesh({}));
  EXPECT_GT(mean_error(blob, in_openmesh({"--cost", "midpoint"})), plain);
  EXPECT_LT(mean_error(blob, in_openmesh({"--cost", "memoryless"})), 0.95 * plain);
  EXPECT_LT(metrics::shape(in_openmesh({"--isotropic", "1"})).edge_length_cv, 0.25);
  EXPECT_GT(metrics::shape(in_openmesh({"--valence", "0.5"})).valence.share_5_to_7,
            metrics::shape(in_openmesh({})).valence.share_5_to_7);
  EXPECT_EQ(in_openmesh({"--cost", "lindstrom-turk"}).faces.size(), in_openmesh({}).faces.size());
}

TEST(SimplifyCosts, LockedBordersKeepEveryBit) {
  const std::string terrain = data_file("terrain.ply");
  const auto border = [](const IndexedMesh& mesh) {
    std::vector<std::array<double, 6>> ends;
    for (const auto& [from, to] : metrics::border_lines(mesh)) {
      ends.push_back({from.x(), from.y(), from.z(), to.x(), to.y(), to.z()});
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  };
  const auto before = border(io::read_mesh(terrain).mesh);
  for (const std::vector<std::string>& cost : {std::vector<std::string>{"--cost", "quadric"},
                                               {"--cost", "lindstrom-turk"},
                                               {"--cost", "midpoint"},
                                               {"--isotropic", "0.5", "--valence", "0.5"}}) {
    std::vector<std::string> options = cost;
    options.insert(options.end(), {"--boundary", "locked"});
    EXPECT_EQ(border(with(terrain, "20%", options).mesh), before) << cost[1];
  }
}

TEST(Simplify, GivesWhatTheLibraryGives) {
  const std::array<std::pair<std::string, Effort>, 3> efforts{
      {{"fast", Effort::fast}, {"normal", Effort::normal}, {"best", Effort::best}}};
  for (const char* const name : {"knot.ply", "terrain.ply", "bracket.stl", "cubes.obj"}) {
    const IndexedMesh input = io::read_mesh(data_file(name)).mesh;
    for (const auto& [word, effort] : efforts) {
      const IndexedMesh by_program = simplify(data_file(name), {"--faces", "200", "--effort", word}).mesh;
      const IndexedMesh by_library = whittle::simplify(input, DecimateTarget::faces(200), effort).mesh;
      EXPECT_EQ(by_program.faces, by_library.faces) << name << ' ' << word;
      EXPECT_EQ(by_program.positions, by_library.positions) << name << ' ' << word;
    }
  }
}

}  // namespace
}  // namespace whittle::test
