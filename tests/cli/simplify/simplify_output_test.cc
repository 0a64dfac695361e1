// The output of `simplify`: the result, the map, the report, and the messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::test {
namespace {

namespace fs = std::filesystem;

/// The numbers of a file written by --map.
std::vector<long> read_map(const std::string& path) {
  std::vector<long> map;
  std::istringstream in(read_text(path));
  for (long number = 0; in >> number;) map.push_back(number);
  return map;
}

void expect_total_and_onto(const std::vector<long>& map, std::size_t n_file_vertices, std::size_t n_vertices) {
  EXPECT_EQ(map.size(), n_file_vertices);
  std::vector<bool> is_hit(n_vertices, false);
  for (const long v : map) {
    ASSERT_GE(v, -1);
    ASSERT_LT(v, static_cast<long>(n_vertices));
    if (v >= 0) is_hit[static_cast<std::size_t>(v)] = true;
  }
  EXPECT_TRUE(std::all_of(is_hit.begin(), is_hit.end(), [](bool hit) { return hit; }));
}

TEST(VertexMap, SendsEveryVertexOfTheFileSomewhere) {
  for (const char* engine : {"flat", "openmesh"}) {
    const TemporaryFolder folder;
    const Outcome outcome = whittle({"simplify", data_file("blob.obj"), "-o", folder / "out.ply", "--vertices", "300",
                                     "--map", folder / "map", "--engine", engine});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    const std::vector<long> map = read_map(folder / "map");
    expect_total_and_onto(map, 2562, 300);
    // Vertices far apart don't merge: each is near its new vertex, on a mesh of size about 2.
    const IndexedMesh before = io::read_mesh(data_file("blob.obj")).mesh;
    const IndexedMesh after = io::read_mesh(folder / "out.ply").mesh;
    for (std::size_t v = 0; v < map.size(); ++v) {
      const Vec3 moved = after.positions[static_cast<std::size_t>(map[v])] - before.positions[v];
      EXPECT_LT(moved.norm(), 0.7) << engine << ", vertex " << v;
    }
  }
}

/// For each vertex of the result, those of the file, as the map has them.
std::vector<std::string> turned_round(const std::vector<long>& map, std::size_t n_vertices) {
  std::vector<std::string> lines(n_vertices);
  for (std::size_t v = 0; v < map.size(); ++v) {
    if (map[v] < 0) continue;
    std::string& line = lines[static_cast<std::size_t>(map[v])];
    line += (line.empty() ? "" : " ") + std::to_string(v);
  }
  return lines;
}

TEST(VertexMap, GoesBack) {
  const TemporaryFolder folder;
  write_text(folder / "in.obj", read_text(data_file("cubes.obj")) + "v 7 7 7\n");  // a vertex without a face
  for (const std::string& mesh : {folder / "in.obj", data_file("bracket.stl"), data_file("nonmanifold.obj")}) {
    const Outcome outcome = whittle({"simplify", mesh, "-o", folder / "out.ply", "--face-ratio", "30%", "--threshold",
                                     "auto", "--map", folder / "map", "--map-back", folder / "back"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    std::string expected;
    const std::size_t n_vertices = io::read_mesh(folder / "out.ply").mesh.positions.size();
    for (const std::string& line : turned_round(read_map(folder / "map"), n_vertices)) expected += line + '\n';
    EXPECT_EQ(read_text(folder / "back"), expected) << mesh;
  }
}

TEST(VertexMap, GoesThroughWelding) {
  const TemporaryFolder folder;
  ASSERT_EQ(whittle({"simplify", data_file("bracket.stl"), "-o", folder / "out.ply", "--vertices", "300", "--map",
                     folder / "map"})
                .exit_code,
            0);
  const std::vector<long> map = read_map(folder / "map");
  expect_total_and_onto(map, 4428, 300);
  const IndexedMesh corners = io::read_mesh(data_file("bracket.stl"), {.weld = false}).mesh;
  std::map<std::vector<double>, long> at_position;
  for (std::size_t v = 0; v < map.size(); ++v) {
    const Vec3& p = corners.positions[v];
    const auto [place, is_new] = at_position.try_emplace({p.x(), p.y(), p.z()}, map[v]);
    EXPECT_EQ(place->second, map[v]) << "corner " << v << " was welded to one that went elsewhere";
  }
  EXPECT_EQ(at_position.size(), 738U);
}

TEST(VertexMap, SaysMinusOneOfVerticesWithoutAFace) {
  const TemporaryFolder folder;
  write_text(folder / "in.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 8 8 8\nv 0 1 0\nf 2 3 5\n");
  const Outcome outcome =
      whittle({"simplify", folder / "in.obj", "-o", folder / "out.obj", "--faces", "1", "--map", folder / "map"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(read_text(folder / "map"), "-1\n0\n1\n-1\n2\n");
}

TEST(VertexMap, CanGoToStandardOutput) {
  const TemporaryFolder folder;
  const Outcome outcome =
      whittle({"simplify", data_file("cubes.obj"), "-o", folder / "out.obj", "--faces", "300", "--map", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 200) << outcome;
}

TEST(Output, ReplacesAFileAndKeepsItsPermissions) {
  const TemporaryFolder folder;
  write_text(folder / "out.obj", "something else");
  const fs::perms perms = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(folder / "out.obj", perms);
  const Outcome outcome = whittle({"simplify", data_file("cubes.obj"), "-o", folder / "out.obj", "--faces", "150"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(io::read_mesh(folder / "out.obj").mesh.faces.size(), 150U);
  EXPECT_EQ(fs::status(folder / "out.obj").permissions(), perms);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"out.obj"});
}

TEST(Output, IsInTheFormatOfItsName) {
  const TemporaryFolder folder;
  std::vector<std::string> names{"OUT.PLY"};
  for (const io::Format format : io::all_formats) names.push_back("out." + std::string(io::name_of(format)));
  for (const std::string& name : names) {
    const Outcome outcome = whittle({"simplify", data_file("blob.obj"), "-o", folder / name, "--faces", "500"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_EQ(io::read_mesh(folder / name).mesh.faces.size(), 500U) << name;
  }
}

TEST(Output, StreamsThroughPipes) {
  RunOptions options;
  options.input = read_text(data_file("knot.ply"));
  const Outcome outcome = whittle({"simplify", "-", "-o", "-", "--format", "ply", "--faces", "1000"}, options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("whittle: standard output: 51200 -> 1000 faces"), std::string::npos) << outcome.err;
  EXPECT_EQ(io::read_mesh(outcome.out, "stdout.ply").mesh.faces.size(), 1000U);

  const Outcome chain = run({"bash", "-c",
                             "whittle simplify \"$0\" -o - --format obj --faces 1000 --quiet |"
                             " whittle simplify - -o - --format obj --faces 500 --quiet |"
                             " whittle info - --format obj --json - | tr -d ' \\n'",
                             data_file("blob.obj")});
  EXPECT_EQ(chain.err, "") << chain;
  EXPECT_EQ(parse_json(chain.out)["faces"], 500);
}

TEST(Output, TakesAFormatWhereTheNameTellsNone) {
  const TemporaryFolder folder;
  fs::copy_file(data_file("blob.obj"), folder / "blob");
  const Outcome outcome =
      whittle({"simplify", folder / "blob", "-o", folder / "out", "--format", "obj", "--faces", "500"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(io::read_mesh(folder / "out", {.format = io::Format::obj}).mesh.faces.size(), 500U);
  // The extension takes precedence over --format.
  EXPECT_EQ(
      whittle({"simplify", folder / "blob", "-o", folder / "out.off", "--format", "obj", "--faces", "500"}).exit_code,
      0);
  EXPECT_EQ(read_text(folder / "out.off").substr(0, 3), "OFF");
}

TEST(Normals, AreKeptRecomputedOrDropped) {
  const TemporaryFolder folder;
  IndexedMesh mesh = io::read_mesh(data_file("blob.obj")).mesh;
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  io::write_mesh(folder / "in.ply", mesh);
  const auto simplified = [&folder](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"simplify", folder / "in.ply", "-o", folder / "out.ply", "--faces", "500"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = whittle(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    return io::read_mesh(folder / "out.ply").mesh;
  };
  const IndexedMesh kept = simplified({});
  ASSERT_EQ(kept.normals.size(), 252U);
  for (const auto& normal : kept.normals)
    EXPECT_EQ(normal, (std::array<float, 3>{0, 0, 1})) << "polish keeps them, too";
  EXPECT_EQ(simplified({"--normals", "keep"}).normals, kept.normals);

  const IndexedMesh anew = simplified({"--normals", "recompute"});
  EXPECT_EQ(anew.positions, kept.positions);
  const auto is_upwards = [](const std::array<float, 3>& normal) { return normal[2] > 0.99F; };
  EXPECT_LT(std::count_if(anew.normals.begin(), anew.normals.end(), is_upwards), 100);
  EXPECT_EQ(anew.normals.size(), 252U);

  const IndexedMesh dropped = simplified({"--normals", "drop"});
  EXPECT_EQ(dropped.positions, kept.positions);
  EXPECT_TRUE(dropped.normals.empty());
  const Outcome openmesh = whittle({"simplify", folder / "in.ply", "-o", folder / "out.ply", "--faces", "500",
                                    "--engine", "openmesh", "--normals", "drop"});
  EXPECT_EQ(openmesh.err.find("not carried"), std::string::npos) << openmesh;
}

/// Largest angle between the normal of a corner and that of the side of the cube on which its face lies, degrees. Faces
/// that lie along an edge, as thin as it is rounded, are left out.
double farthest_from_sides(const IndexedMesh& mesh) {
  double largest = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto [a, b, c] = mesh.faces[f];
    const Vec3 of_face = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    Eigen::Index axis = 0;
    of_face.cwiseAbs().maxCoeff(&axis);
    if (of_face.norm() < 1e-3) continue;
    const Vec3 of_side = of_face[axis] * Vec3::Unit(axis);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& n = mesh.normals[mesh.wedge(f, k)];
      const Vec3 of_corner(n[0], n[1], n[2]);
      largest = std::max(largest, std::atan2(of_side.cross(of_corner).norm(), of_side.dot(of_corner)));
    }
  }
  return largest * 180 / std::numbers::pi;
}

TEST(Normals, BreakAtCreasesInEveryFormat) {
  const TemporaryFolder folder;
  IndexedMesh cube = tessellated_cube(6);
  cube.normals = vertex_normals(cube, Frame{});
  io::write_mesh(folder / "in.obj", cube);
  for (const char* name : {"out.obj", "out.ply", "out.off", "out.glb"}) {
    const std::string out = folder / name;
    for (const bool is_recorded : {false, true}) {
      std::vector<std::string> arguments{"simplify", folder / "in.obj", "-o",        out,      "--faces",
                                         "60",       "--normals",       "recompute", "--force"};
      if (is_recorded) arguments.insert(arguments.end(), {"--record", folder / "rec"});
      const Outcome outcome = whittle(arguments);
      ASSERT_EQ(outcome.exit_code, 0) << outcome;
      const bool is_gltf = out.ends_with(".glb");
      const IndexedMesh mesh = is_gltf ? gltf::Asset::read(out).triangles(0) : io::read_mesh(out).mesh;
      EXPECT_LT(farthest_from_sides(mesh), 0.1) << name;
    }
  }
  ASSERT_EQ(whittle({"replay", folder / "rec", "--faces", "60", "-o", folder / "level.obj"}).exit_code, 0);
  EXPECT_EQ(read_text(folder / "level.obj"), read_text(folder / "out.obj"));
  EXPECT_GT(farthest_from_sides([&] {
              const Outcome outcome = whittle({"simplify", folder / "in.obj", "-o", folder / "round.obj", "--faces",
                                               "60", "--normals", "recompute", "--crease-angle", "180"});
              EXPECT_EQ(outcome.exit_code, 0) << outcome;
              return io::read_mesh(folder / "round.obj").mesh;
            }()),
            30);
}

TEST(Talk, IsOneLineOfSummary) {
  const TemporaryFolder folder;
  const std::string out = folder / "out.ply";
  const Outcome outcome = whittle({"simplify", data_file("knot.ply"), "-o", out, "--faces", "5000"});
  EXPECT_EQ(outcome.out, "");
  const std::regex summary("whittle: " + out + R"(: 51200 -> 5000 faces, 25600 -> 2500 vertices in \d+\.\d+ s\n)");
  EXPECT_TRUE(std::regex_match(outcome.err, summary)) << outcome;
}

TEST(Talk, SaysEveryRepairInOneLine) {
  const TemporaryFolder folder;
  const Outcome outcome = whittle({"simplify", data_file("bracket.stl"), "-o", folder / "out.ply", "--faces", "1000"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err.substr(0, outcome.err.find('\n')),
            "whittle: " + data_file("bracket.stl") + ": welded 3690 vertices")
      << outcome;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << outcome;
}

TEST(Talk, IsSilentWhenQuietAndLongerWhenVerbose) {
  const TemporaryFolder folder;
  const std::vector<std::string> arguments{"simplify", data_file("bracket.stl"), "-o", folder / "out.ply", "--faces",
                                           "4"};
  const auto with = [&arguments](const char* more) {
    std::vector<std::string> all = arguments;
    all.emplace_back(more);
    return whittle(all);
  };
  const Outcome quiet = with("--quiet");
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "") << quiet;
  const Outcome verbose = with("-v");
  for (const char* said : {"read 738 vertices, 1476 faces", "contractions: ", "greatest cost ", "by topology", "MiB"}) {
    EXPECT_NE(verbose.err.find(said), std::string::npos) << "not said: " << said << '\n' << verbose;
  }
}

/// Names of all members in order, nested ones as "a.b".
std::vector<std::string> keys_of(const nlohmann::ordered_json& json, const std::string& prefix = "") {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) {
    keys.push_back(prefix + key);
    if (!value.is_object()) continue;
    const std::vector<std::string> inner = keys_of(value, prefix + key + ".");
    keys.insert(keys.end(), inner.begin(), inner.end());
  }
  return keys;
}

constexpr std::array schema_keys{"schema",
                                 "program",
                                 "input",
                                 "input.path",
                                 "input.vertices",
                                 "input.faces",
                                 "input.diagonal",
                                 "input.repairs",
                                 "options",
                                 "output",
                                 "output.path",
                                 "output.vertices",
                                 "output.faces",
                                 "output.manifold",
                                 "output.closed",
                                 "output.components",
                                 "output.boundary_loops",
                                 "output.genus",
                                 "output.nonmanifold_edges",
                                 "output.nonmanifold_vertices",
                                 "output.vanished_components",
                                 "output.pruned_components",
                                 "output.coincident_faces",
                                 "input.components",
                                 "input.nonmanifold_edges",
                                 "input.nonmanifold_vertices",
                                 "target",
                                 "target.faces",
                                 "target.met",
                                 "stop",
                                 "contractions",
                                 "threshold_pairs",
                                 "threshold_pairs.considered",
                                 "threshold_pairs.contracted",
                                 "threshold_pairs.threshold",
                                 "threshold_pairs.capped",
                                 "max_cost",
                                 "rejections",
                                 "rejections.flip",
                                 "rejections.link",
                                 "seconds",
                                 "seconds.read",
                                 "seconds.decimate",
                                 "seconds.polish",
                                 "seconds.write",
                                 "seconds.total",
                                 "peak_rss_bytes",
                                 "warnings"};

TEST(Report, HasEveryKeyOfItsSchema) {
  const TemporaryFolder folder;
  ASSERT_EQ(whittle({"simplify", data_file("knot.ply"), "-o", folder / "out.ply", "--faces", "5000", "--json",
                     folder / "report.json"})
                .exit_code,
            0);
  const auto json = nlohmann::ordered_json::parse(read_text(folder / "report.json"));
  const std::vector<std::string> keys = keys_of(json);
  for (const char* key : schema_keys) {
    EXPECT_EQ(std::count(keys.begin(), keys.end(), key), 1) << key;
  }
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["program"], "whittle " WHITTLE_VERSION);
  EXPECT_EQ(json["input"]["path"], data_file("knot.ply"));
  EXPECT_NEAR(json["input"]["diagonal"].get<double>(), 9.523, 0.001);
  EXPECT_EQ(json["contractions"], 23100);
  EXPECT_EQ(json["threshold_pairs"]["considered"], 0);
  EXPECT_EQ(json["threshold_pairs"]["capped"], false);
  EXPECT_GT(json["seconds"]["polish"], 0);
  EXPECT_EQ(json["polish"]["passes"], 1);
  const auto& seconds = json["seconds"];
  EXPECT_LE(seconds["read"].get<double>() + seconds["decimate"].get<double>() + seconds["write"].get<double>(),
            seconds["total"].get<double>());
  EXPECT_GT(json["peak_rss_bytes"], 1'000'000);
}

TEST(Report, HoldsFileNamesThatAreNotText) {
  const TemporaryFolder folder;
  const std::string name = folder / "caf\xe9.obj";
  fs::copy_file(data_file("cubes.obj"), name);
  const Outcome outcome = whittle({"simplify", name, "-o", folder / "out.obj", "--faces", "150", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(parse_json(outcome.out)["input"]["path"], folder / "caf\xef\xbf\xbd.obj");
}

TEST(Report, HasNoGenusWhereItMeansNothing) {
  const TemporaryFolder folder;
  const Outcome open =
      whittle({"simplify", data_file("terrain.ply"), "-o", folder / "out.ply", "--faces", "500", "--json", "-"});
  const auto output = parse_json(open.out)["output"];
  EXPECT_EQ(output["genus"], nullptr);
  EXPECT_EQ(output["closed"], false);
  EXPECT_EQ(output["boundary_loops"], 1);
}

}  // namespace
}  // namespace whittle::test
