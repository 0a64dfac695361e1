// A length as target of `simplify`: the file that is written keeps it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "program/simplified.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"
#include "whittle/metrics/certify.hh"

namespace whittle::test {
namespace {

double larger(const nlohmann::json& distances, const char* key) {
  return std::max(distances["forward"][key].get<double>(), distances["backward"][key].get<double>());
}

TEST(MaxErrorOption, IsKeptByTheFile) {
  const TemporaryFolder folder;
  const std::string input = data_file("blob.obj");
  const IndexedMesh mesh = io::read_mesh(input).mesh;
  const double limit = 0.005 * diagonal_of(mesh.positions);
  for (const char* const name : {"out.ply", "out.obj", "out.stl", "out.off"}) {
    SCOPED_TRACE(name);
    const std::string output = folder / name;
    const Outcome run = whittle({"simplify", input, "-o", output, "-e", "0.5%", "--json", "-"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_EQ(report["stop"], "error");
    EXPECT_EQ(report["options"]["pauses"], nlohmann::json::array());
    EXPECT_EQ(report["target"]["met"], true);
    EXPECT_NEAR(report["target"]["max_error"].get<double>(), limit, 1e-12 * limit);
    EXPECT_EQ(report["max_error"]["asked"], report["target"]["max_error"]);
    const double proven = report["max_error"]["proven"];
    EXPECT_LE(proven, limit);
    EXPECT_EQ(proven, larger(report["max_error"], "at_most"));
    EXPECT_GE(larger(report["max_error"], "at_least"), 0.9 * limit) << "more would have been allowed";
    const IndexedMesh written = io::read_mesh(output).mesh;
    EXPECT_EQ(written.faces.size(), report["output"]["faces"]);
    EXPECT_EQ(metrics::certify(mesh, written, limit).verdict, Verdict::proven);
  }
}

TEST(MaxErrorOption, GoesForBorders) {
  const TemporaryFolder folder;
  const std::string output = folder / "out.ply";
  const std::string input = data_file("terrain.ply");
  const IndexedMesh mesh = io::read_mesh(input).mesh;
  const double diagonal = diagonal_of(mesh.positions);
  for (const double limit : {0.01, 0.001}) {
    SCOPED_TRACE(limit);
    const Outcome run = whittle({"simplify", input, "-o", output, "--max-error", "1%", "--max-error-borders",
                                 std::to_string(limit * diagonal), "--json", "-"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_LE(report["max_error"]["borders"]["proven"], report["target"]["max_error_borders"]);
    EXPECT_GT(report["max_error"]["borders"]["proven"], 0.3 * limit * diagonal);
    const IndexedMesh written = io::read_mesh(output).mesh;
    EXPECT_EQ(metrics::certify_borders(mesh, written, 1.00001 * limit * diagonal).verdict, Verdict::proven);
  }
  const Outcome idle = whittle({"simplify", input, "-o", output, "--faces", "900", "--max-error-borders", "1"});
  EXPECT_NE(idle.err.find("--max-error-borders"), std::string::npos) << idle.err;
}

TEST(MaxErrorOption, IsFoundWithoutALimit) {
  const Simplified result = simplify(data_file("blob.obj"), {"--faces", "500", "--certify"});
  const auto& error = result.report["max_error"];
  EXPECT_EQ(error["asked"], nullptr);
  EXPECT_EQ(error["borders"], nullptr);
  EXPECT_LE(error["proven"].get<double>(), 1.0011 * larger(error, "at_least"));
  const IndexedMesh mesh = io::read_mesh(data_file("blob.obj")).mesh;
  EXPECT_EQ(metrics::certify(mesh, result.mesh, error["proven"]).verdict, Verdict::proven);
  EXPECT_EQ(metrics::certify(mesh, result.mesh, 0.99 * larger(error, "at_least")).verdict, Verdict::refuted);
}

TEST(MaxErrorOption, SaysInWordsWhatWasAskedAndFound) {
  const TemporaryFolder folder;
  const std::string output = folder / "out.ply";
  const std::string terrain = data_file("terrain.ply");
  const Outcome limited = whittle({"simplify", terrain, "-o", output, "-e", "1%", "--max-error-borders", "0.5%", "-v"});
  EXPECT_EQ(limited.exit_code, 0) << limited;
  for (const std::string& said :
       {std::string("asked: at most "), std::string(" (1 %) off, borders "), terrain + " is at most ",
        " off " + output + ", and ", output + " is at most ", std::string(" faces have corners nearly as far"),
        "the border of " + terrain + " is at most ", "off that of " + output}) {
    EXPECT_NE(limited.err.find(said), std::string::npos) << "not said: " << said << '\n' << limited;
  }
  const Outcome certified =
      whittle({"simplify", data_file("blob.obj"), "-o", output, "--faces", "500", "--certify", "-v"});
  EXPECT_NE(certified.err.find(output + " is at most "), std::string::npos) << certified;
  for (const char* const unsaid : {"asked:", "border"}) {
    EXPECT_EQ(certified.err.find(unsaid), std::string::npos) << certified;
  }
}

/// So far from the origin that binary STL rounds its coordinates to a 16th.
IndexedMesh far_blob(int level) {
  IndexedMesh mesh = blob(level, 1);
  for (Vec3& p : mesh.positions) p += Vec3(1e6, 0, 0);
  return mesh;
}

/// The run fails as its limit can't be proven, and writes nothing.
void expect_unproven(const std::string& output, const std::vector<std::string>& arguments) {
  const Outcome run = whittle(arguments);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("can't be proven as " + output + " would be written"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST(MaxErrorOption, WritesNothingThatIsNotProven) {
  const TemporaryFolder folder;
  const IndexedMesh far = far_blob(4);
  const std::string input = folder / "far.ply";
  io::write_mesh(input, far);
  const std::string output = folder / "out.stl";
  expect_unproven(output, {"simplify", input, "-o", output, "-e", "0.01"});
  EXPECT_EQ(whittle({"simplify", input, "-o", output, "-e", "0.2"}).exit_code, 0);
  EXPECT_EQ(whittle({"simplify", input, "-o", output, "-e", "0.01", "--ascii"}).exit_code, 0);
}

TEST(MaxErrorOption, SaysIfBordersStandInTheWay) {
  const TemporaryFolder folder;
  IndexedMesh far = terrain(16, 1);
  for (Vec3& p : far.positions) p = 100.3 * p + Vec3(1e6, 0, 0);
  const std::string input = folder / "far.ply";
  io::write_mesh(input, far);
  const std::string output = folder / "out.stl";
  const Outcome run = whittle({"simplify", input, "-o", output, "-e", "1", "--max-error-borders", "0.001"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find(" off as it is read again; choose a larger --max-error-borders"), std::string::npos) << run;
  EXPECT_EQ(whittle({"simplify", input, "-o", output, "-e", "1", "--max-error-borders", "0.2"}).exit_code, 0);
}

/// Tolerances of vertices don't hide that not even the input is proven.
TEST(MaxErrorOption, WritesNothingThatIsNotProvenInPlaces) {
  const TemporaryFolder folder;
  const IndexedMesh far = far_blob(4);
  const std::string input = folder / "far.ply";
  io::write_mesh(input, far);
  std::string lines;
  for (std::size_t v = 0; v < far.positions.size(); ++v) lines += v % 2 == 0 ? "0.005\n" : "100\n";
  const std::string map = folder / "tolerances.txt";
  write_text(map, lines);
  const std::string output = folder / "out.stl";
  expect_unproven(output, {"simplify", input, "-o", output, "-e", "0.01", "--tolerance-map", map});
}

/// What STL can hold it holds again: the input itself is within any error.
TEST(MaxErrorOption, WritesTheInputIfNothingElseIsProven) {
  const TemporaryFolder folder;
  const std::string rounded = folder / "rounded.stl";
  io::write_mesh(rounded, far_blob(3));
  const std::string output = folder / "out.stl";
  const Outcome run = whittle({"simplify", rounded, "-o", output, "-e", "1e-5", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const auto report = parse_json(run.out);
  EXPECT_LE(report["max_error"]["proven"], 1e-5);
  EXPECT_EQ(io::read_mesh(output).mesh.faces.size(), report["output"]["faces"]);
}

TEST(MaxErrorOption, SaysWhyNothingIsContracted) {
  const TemporaryFolder folder;
  const std::string input = folder / "in.ply";
  io::write_mesh(input, icosahedron());
  const Outcome run = whittle({"simplify", input, "-o", folder / "out.ply", "-e", "1e-4"});
  EXPECT_EQ(run.exit_code, 0) << run;
  EXPECT_NE(run.err.find("nothing is contracted"), std::string::npos) << run;
  EXPECT_NE(run.err.find("20 -> 20 faces"), std::string::npos) << run;
}

TEST(MaxErrorOption, MayEndBeforeANumberThatIsAsked) {
  const TemporaryFolder folder;
  const std::string output = folder / "out.ply";
  const auto simplified = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"simplify", data_file("blob.obj"), "-o", output, "--json", "-"});
    return whittle(more);
  };
  const std::vector<std::vector<std::string>> ends{{"--max-error", "0.5%"}, {"--max-cost", "1e-7"}};
  for (const std::vector<std::string>& end : ends) {
    SCOPED_TRACE(end[0]);
    const Outcome run = simplified({"--faces", "20", end[0], end[1]});
    EXPECT_EQ(run.exit_code, 0) << run;
    const auto report = parse_json(run.out);
    EXPECT_EQ(report["target"]["met"], false);
    EXPECT_EQ(report["target"]["ended_by"], end[0]);
    EXPECT_NE(run.err.find("target not met: 20 faces asked"), std::string::npos) << run;
    EXPECT_NE(run.err.find("'" + end[0] + "' ended it"), std::string::npos) << run;
    EXPECT_NE(run.err.find(", ended by '" + end[0] + "', in "), std::string::npos) << run;
    EXPECT_EQ(simplified({"--faces", "20", end[0], end[1], "--strict"}).exit_code, 3);
    EXPECT_EQ(simplified({"--strict", end[0], end[1]}).exit_code, 0) << "no number is asked";
    const auto reached = parse_json(simplified({"--strict", "--faces", "5000", end[0], end[1]}).out);
    EXPECT_EQ(reached["target"]["met"], true);
    EXPECT_FALSE(reached["target"].contains("ended_by"));
  }
}

TEST(MaxErrorOption, IsLessInPlaces) {
  const TemporaryFolder folder;
  const std::string input = data_file("blob.obj");
  const io::ReadResult read = io::read_mesh(input);
  const double diagonal = diagonal_of(read.mesh.positions);
  std::string lines;
  std::vector<double> tolerances;
  for (const Vec3& p : read.mesh.positions) {
    lines += p.x() < 0 ? "0.2%\r\n" : "100\n";
    tolerances.push_back(p.x() < 0 ? 0.002 * diagonal : 100);
  }
  ASSERT_EQ(read.file_vertices, read.mesh.positions.size());
  const std::string map = folder / "tolerances.txt";
  write_text(map, lines);
  const std::string output = folder / "out.ply";
  const auto simplify_by = [&](const std::string& file) {
    return whittle({"simplify", input, "-o", output, "-e", "1%", "--tolerance-map", file, "--json", "-"});
  };
  const Outcome run = simplify_by(map);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out)["target"]["tolerance_map"], map);
  const IndexedMesh written = io::read_mesh(output).mesh;
  EXPECT_EQ(metrics::certify(read.mesh, written, 0.01 * diagonal, {.tolerances = tolerances}).verdict, Verdict::proven);
  ASSERT_EQ(whittle({"simplify", input, "-o", output, "-e", "1%"}).exit_code, 0);
  EXPECT_LT(io::read_mesh(output).mesh.faces.size(), written.faces.size());

  write_text(map, lines + "1\n");
  EXPECT_EQ(simplify_by(map).exit_code, 4);
  write_text(map, "1\n0\n");
  EXPECT_NE(simplify_by(map).err.find(map + ":2: '0' is no length above 0"), std::string::npos);
  EXPECT_NE(simplify_by(folder / "missing").err.find("missing"), std::string::npos);
}

TEST(MaxErrorOption, IsLessWhereAPlyFileSaysSo) {
  const TemporaryFolder folder;
  const IndexedMesh mesh = blob(4, 1);
  const double tight = 0.002 * diagonal_of(mesh.positions);
  const auto text_of = [&mesh](const std::string& type, double left) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.positions.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\nproperty " + type +
                       " tolerance\nelement face " + std::to_string(mesh.faces.size()) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3& p : mesh.positions) {
      for (const double x : p) text += std::to_string(x) + ' ';
      text += std::to_string(p.x() < 0 ? left : 100) + '\n';
    }
    for (const auto& [a, b, c] : mesh.faces) {
      text += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
    }
    return text;
  };
  const std::string input = folder / "in.ply";
  const std::string output = folder / "out.ply";
  const auto simplified = [&] { return whittle({"simplify", input, "-o", output, "-e", "1%", "--json", "-"}); };
  for (const char* const type : {"float", "double"}) {
    write_text(input, text_of(type, tight));
    const Outcome run = simplified();
    ASSERT_EQ(run.exit_code, 0) << run;
    EXPECT_NE(run.err.find("keeps to its vertices' property 'tolerance'"), std::string::npos) << run;
    EXPECT_EQ(parse_json(run.out)["max_error"]["tolerances"], mesh.positions.size());
    const io::ReadResult read = io::read_mesh(input);
    ASSERT_EQ(read.tolerances.size(), mesh.positions.size());
    EXPECT_EQ(metrics::certify(read.mesh, io::read_mesh(output).mesh, 1e9, {.tolerances = read.tolerances}).verdict,
              Verdict::proven);
  }
  write_text(input, text_of("double", -1));
  const Outcome refused = simplified();
  EXPECT_EQ(refused.exit_code, 4) << refused;
  EXPECT_NE(refused.err.find("has the tolerance -1; with --max-error all must be above 0"), std::string::npos)
      << refused;
  EXPECT_EQ(whittle({"info", input}).exit_code, 0) << "only a limit of the error looks at them";
}

}  // namespace
}  // namespace whittle::test
