// glTF in and out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/format.hh"
#include "whittle/io/read.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;

/// What isn't geometry.
Json other_than_geometry(Json document) {
  for (const char* key : {"accessors", "bufferViews", "buffers"}) document.erase(key);
  for (Json& mesh : document["meshes"]) mesh.erase("primitives");
  for (Json& animation : document["animations"]) animation.erase("samplers");
  return document;
}

Json document_of(const std::string& path) { return Json::parse(gltf::Asset::read(path).document()); }

TEST(Gltf, IsSimplifiedWithAllThatIsInIt) {
  const TemporaryFolder folder;
  const std::string in = folder / "cube.glb";
  write_gltf_cube(in, 8);
  for (const char* name : {"out.glb", "out.gltf"}) {
    const std::string out = folder / name;
    const Outcome outcome = whittle({"simplify", in, "-o", out, "--faces", "60", "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    const Json json = parse_json(outcome.out);
    EXPECT_EQ(json["target"]["met"], true);
    EXPECT_EQ(json["warnings"].size(), 0U) << json["warnings"];
    const gltf::Asset asset = gltf::Asset::read(out);
    EXPECT_EQ(other_than_geometry(Json::parse(asset.document())), other_than_geometry(document_of(in)));
    const IndexedMesh mesh = asset.triangles(0);
    EXPECT_EQ(mesh.faces.size(), json["output"]["faces"]);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (const Index v : mesh.faces[f]) {
        const auto& n = mesh.normals[v];
        const Vec3 normal(n[0], n[1], n[2]);
        Eigen::Index axis = 0;
        normal.cwiseAbs().maxCoeff(&axis);
        const std::size_t side = 2 * static_cast<std::size_t>(axis) + (normal[axis] > 0 ? 1 : 0);
        EXPECT_EQ(mesh.face_groups[f], side % 2);
        EXPECT_NEAR(mesh.positions[v][axis], side % 2 == 1 ? 1 : -1, 1e-6) << "a material bleeds";
        const auto expected = chart_position(side, mesh.positions[v]);
        for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(mesh.attributes[0].value(v)[i], expected[i], 1e-3);
      }
    }
  }
}

TEST(Gltf, IsReadByOtherCommands) {
  const TemporaryFolder folder;
  const std::string in = folder / "cube.gltf";
  write_gltf_cube(in, 3);
  const Outcome info = whittle({"info", in, "--json", "-"});
  ASSERT_EQ(info.exit_code, 0) << info;
  EXPECT_EQ(parse_json(info.out)["format"], "gltf");
  EXPECT_EQ(parse_json(info.out)["closed"], true) << "it is welded at its seams";
  const Outcome converted = whittle({"convert", in, folder / "cube.obj", "--json", "-"});
  ASSERT_EQ(converted.exit_code, 0) << converted;
  EXPECT_THAT(parse_json(converted.out)["warnings"].dump(), testing::HasSubstr("left out: the materials"));
  EXPECT_EQ(io::read_mesh(folder / "cube.obj").mesh.group_names,
            (std::vector<std::string>{"cube: brick", "cube: glass"}));
  const Outcome measured = whittle({"measure", in, folder / "cube.obj", "--samples", "1000", "--json", "-"});
  ASSERT_EQ(measured.exit_code, 0) << measured;
  EXPECT_LT(parse_json(measured.out)["max_rel"], 1e-9);
}

/// The cube in three nodes: one turns and moves it, one mirrors it, and one makes it flat.
void write_three_places(const std::string& path) {
  write_gltf_cube(path, 4);
  Json document = Json::parse(std::ifstream(path));
  document["nodes"] = {
      {{"mesh", 0}, {"translation", {10, 0, 0}}, {"rotation", {0, 0, 0.6, 0.8}}, {"scale", {1.4, 1.4, 1.4}}},
      {{"mesh", 0}, {"translation", {0, 10, 0}}, {"scale", {-1, 1, 1}}},
      {{"mesh", 0}, {"scale", {1, 0, 1}}}};
  document["scenes"][0]["nodes"] = {0, 1, 2};
  std::ofstream(path) << document;
}

TEST(Gltf, BecomesOtherFormatsAsTheSceneShowsIt) {
  const TemporaryFolder folder;
  const std::string in = folder / "places.gltf";
  write_three_places(in);
  const std::string out = folder / "out.obj";
  const Outcome converted = whittle({"convert", in, out, "--json", "-"});
  ASSERT_EQ(converted.exit_code, 0) << converted;
  EXPECT_EQ(parse_json(converted.out)["output"]["faces"], 3 * 192);
  const IndexedMesh mesh = io::read_mesh(out).mesh;
  EXPECT_EQ(mesh.group_names.size(), 2U) << "all copies have the same groups";
  std::size_t n_first = 0;
  std::size_t n_second = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3& p = mesh.positions[a];
    const Vec3 normal = (mesh.positions[b] - p).cross(mesh.positions[c] - p);
    const Vec3 center = p.x() > 5 ? Vec3(10, 0, 0) : p.y() > 5 ? Vec3(0, 10, 0) : Vec3(0, 0, 0);
    if (center.norm() == 0) continue;
    (center.x() > 0 ? n_first : n_second) += 1;
    EXPECT_GT(normal.dot(p - center), 0) << "fronts stay outside";
  }
  EXPECT_EQ(n_first, 192U);
  EXPECT_EQ(n_second, 192U);
  const Outcome measured = whittle({"measure", in, out, "--samples", "1000", "--json", "-"});
  ASSERT_EQ(measured.exit_code, 0) << measured;
  EXPECT_LT(parse_json(measured.out)["max_rel"], 1e-6);
}

TEST(Gltf, KeepsTheNumbersOfWhatDoesNotMove) {
  const TemporaryFolder folder;
  const std::string in = folder / "places.gltf";
  for (const double x : {10.0, 1e17, 1e160}) {  // where a node is so far off that nothing would be left of the cube
    write_three_places(in);
    Json document = Json::parse(std::ifstream(in));
    document["nodes"][0]["translation"] = {x, 0, 0};
    std::ofstream(in) << document;
    ASSERT_EQ(whittle({"convert", in, folder / "out.glb"}).exit_code, 0);
    const auto sorted = [&](const std::string& path) {
      std::vector<std::vector<double>> positions;
      for (const Vec3& p : gltf::Asset::read(path).triangles(0).positions) positions.emplace_back(p.begin(), p.end());
      std::sort(positions.begin(), positions.end());
      positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
      return positions;
    };
    EXPECT_EQ(sorted(folder / "out.glb"), sorted(in)) << x;
  }
}

TEST(Gltf, MayShowNoMoreThanAnyoneCanRead) {
  const TemporaryFolder folder;
  const std::string in = folder / "many.gltf";
  write_gltf_cube(in, 16);
  Json document = Json::parse(std::ifstream(in));
  const std::size_t n_nodes = (std::size_t{1} << 27) / 3072 + 1;
  document["nodes"] = std::vector<Json>(n_nodes, {{"mesh", 0}});
  document["scenes"] = Json::array();
  document.erase("scene");
  std::ofstream(in) << document;
  const Outcome outcome = whittle({"convert", in, folder / "out.ply"});
  EXPECT_EQ(outcome.exit_code, 4) << outcome;
  EXPECT_THAT(outcome.err, testing::HasSubstr("the scene has more than 2^27 triangles"));
  EXPECT_EQ(whittle({"simplify", in, "-o", folder / "out.glb", "--faces", "99"}).exit_code, 0) << "each mesh once";
}

TEST(Gltf, KeepsTheErrorThatIsAskedForWhereTheSceneShowsItLargest) {
  const TemporaryFolder folder;
  const std::string in = folder / "places.gltf";
  for (const double scale : {1.4, 0.7, 20.0}) {
    write_gltf_cube(in, 8);
    Json document = Json::parse(std::ifstream(in));
    document["nodes"][0]["scale"] = {scale, scale, scale};
    std::ofstream(in) << document;
    // So much that corners go.
    const std::string limit = std::to_string(0.9 * scale);
    const Outcome outcome =
        whittle({"simplify", in, "-o", folder / "out.glb", "--max-error", limit, "--seams", "weighted", "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    EXPECT_LT(parse_json(outcome.out)["output"]["faces"], 12);
    const Outcome measured = whittle({"measure", in, folder / "out.glb", "--exact", "0.001", "--json", "-"});
    ASSERT_EQ(measured.exit_code, 0) << measured;
    const Json exact = parse_json(measured.out)["exact"];
    for (const char* way : {"forward", "backward"}) {
      EXPECT_LE(exact[way]["at_least"], 0.9 * scale);
      EXPECT_GT(exact["forward"]["at_most"], 0.05 * scale) << "there is an error";
    }
  }
}

TEST(Gltf, OfPositionsAloneIsANewFileOfTheScene) {
  const TemporaryFolder folder;
  const std::string in = folder / "places.gltf";
  write_three_places(in);
  const Outcome outcome = whittle({"simplify", in, "-o", folder / "out.glb", "--face-ratio", "50%", "--attributes",
                                   "position-only", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(parse_json(outcome.out)["output"]["faces"], 288);
  const gltf::Asset asset = gltf::Asset::read(folder / "out.glb");
  ASSERT_EQ(asset.n_meshes(), 1U);
  const IndexedMesh mesh = asset.triangles(0);
  EXPECT_TRUE(mesh.normals.empty() && mesh.attributes.empty());
  const Outcome measured = whittle({"measure", in, folder / "out.glb", "--samples", "10000", "--json", "-"});
  ASSERT_EQ(measured.exit_code, 0) << measured;
  EXPECT_LT(parse_json(measured.out)["mean_rel"], 0.01);
}

TEST(Gltf, OfPositionsAloneBecomesAnotherFormat) {
  const TemporaryFolder folder;
  write_gltf_cube(folder / "cube.glb", 6);
  const Outcome outcome = whittle(
      {"simplify", folder / "cube.glb", "-o", folder / "out.ply", "--faces", "12", "--attributes", "position-only"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const IndexedMesh mesh = io::read_mesh(folder / "out.ply").mesh;
  EXPECT_EQ(mesh.faces.size(), 12U);
  EXPECT_TRUE(mesh.normals.empty() && mesh.attributes.empty() && mesh.face_groups.empty());
}

TEST(Gltf, IsProvenAsItIsWritten) {
  const TemporaryFolder folder;
  const std::string in = folder / "cube.glb";
  write_gltf_cube(in, 6);
  const std::string out = folder / "out.glb";
  const Outcome outcome = whittle({"simplify", in, "-o", out, "--max-error", "0.1%", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  const Outcome measured = whittle({"measure", in, out, "--exact", "0.01", "--json", "-"});
  ASSERT_EQ(measured.exit_code, 0) << measured;
  EXPECT_LT(parse_json(outcome.out)["output"]["faces"], 100);
}

TEST(Gltf, TakesImagesAlongButNoneFromOutside) {
  const TemporaryFolder folder;
  namespace fs = std::filesystem;
  fs::create_directories(folder.path() / "in" / "tex");
  fs::create_directories(folder.path() / "sub" / "out");
  const std::string in = folder / "in/a cube.gltf";
  write_gltf_cube(in, 3);
  Json document = Json::parse(std::ifstream(in));
  document["images"] = {{{"uri", "tex/wall.png"}}, {{"uri", "../outside.png"}}, {{"uri", "tex/./wall.png"}}};
  std::ofstream(in) << document;
  for (const char* name : {"in/tex/wall.png", "outside.png"}) std::ofstream(folder / name) << "an image";
  const std::string out = folder / "sub/out/small 1.gltf";
  const Outcome outcome = whittle({"simplify", in, "-o", out, "--faces", "30"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_TRUE(fs::exists(folder.path() / "sub" / "out" / "tex" / "wall.png"));
  EXPECT_FALSE(fs::exists(folder.path() / "sub" / "outside.png"));
  EXPECT_THAT(outcome.err, testing::HasSubstr("files that were not copied: ../outside.png (outside of the folder)\n"));
  std::ofstream(folder / "in/tex/wall.png") << "a newer one";
  EXPECT_THAT(whittle({"simplify", in, "-o", out, "--faces", "30", "--force"}).err,
              testing::HasSubstr("tex/wall.png (there is another one)"));
  EXPECT_EQ(gltf::Asset::read(out).triangles(0).faces.size(), 30U) << "its buffer is found";
}

/// Two meshes: the cube, and the half of it that is of one material.
void write_two_meshes(const std::string& path) {
  write_gltf_cube(path, 8);
  Json document = Json::parse(std::ifstream(path));
  Json half = document["meshes"][0];
  half["name"] = "half";
  half["primitives"] = Json::array({half["primitives"][0]});
  document["meshes"].push_back(half);
  std::ofstream(path) << document;
}

TEST(Gltf, HasTheTargetMeshByMeshIfAsked) {
  const TemporaryFolder folder;
  const std::string in = folder / "cubes.gltf";
  write_two_meshes(in);
  const std::string out = folder / "out.glb";
  struct Case {
    std::vector<std::string> target;
    std::size_t of_cube, of_half;
  };
  for (const auto& [target, of_cube, of_half] :
       {Case{{"--face-ratio", "50%"}, 384, 192}, Case{{"--faces", "100"}, 100, 100},
        Case{{"--faces", "500"}, 500, 384}}) {
    std::vector<std::string> arguments{"simplify", in, "-o", out, "--per-mesh", "--json", "-"};
    arguments.insert(arguments.end(), target.begin(), target.end());
    const Outcome outcome = whittle(arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    const Json json = parse_json(outcome.out);
    EXPECT_EQ(json["target"]["met"], true) << outcome;
    EXPECT_EQ(json["target"]["faces"], of_cube + of_half);
    const gltf::Asset asset = gltf::Asset::read(out);
    EXPECT_THAT(asset.n_triangles(0), testing::AllOf(testing::Le(of_cube), testing::Ge(of_cube - 1)));
    EXPECT_THAT(asset.n_triangles(1), testing::AllOf(testing::Le(of_half), testing::Ge(of_half - 1)));
  }
  const Outcome missed = whittle({"simplify", in, "-o", out, "--per-mesh", "--faces", "3"});
  EXPECT_THAT(missed.err, testing::HasSubstr("target not met by cube")) << missed;
  const std::string blob = data_file("blob.obj");
  expect_usage_error(whittle({"simplify", blob, "-o", folder / "o.ply", "--per-mesh", "--faces", "9"}), {"--per-mesh"});
}

/// Parts that lie near one another could be joined in other formats.
TEST(Gltf, IsAdvisedWhatItTakes) {
  const TemporaryFolder folder;
  const std::string cubes = folder / "cubes.glb";
  ASSERT_EQ(whittle({"convert", data_file("cubes.obj"), cubes}).exit_code, 0);
  const Outcome missed = whittle({"simplify", cubes, "-o", folder / "out.glb", "--faces", "10", "--topology", "keep"});
  EXPECT_THAT(missed.err, testing::HasSubstr("target not met: 10 faces asked")) << missed;
  EXPECT_THAT(missed.err, testing::HasSubstr("'--topology free' reaches it")) << missed;
  EXPECT_THAT(missed.err, testing::Not(testing::HasSubstr("--threshold"))) << missed;
  const Outcome info = whittle({"info", cubes});
  EXPECT_THAT(info.out, testing::HasSubstr("--self-intersections refuse")) << info;
  EXPECT_THAT(info.out, testing::Not(testing::HasSubstr("--threshold"))) << info;
}

TEST(Gltf, KeepsATriangleOfAMeshThatVanishes) {
  const TemporaryFolder folder;
  const std::string in = folder / "cubes.gltf";
  write_two_meshes(in);
  Json document = Json::parse(std::ifstream(in));
  std::swap(document["meshes"][0], document["meshes"][1]);  // the half is the greater one
  document["nodes"].push_back({{"mesh", 1}, {"scale", {1e-3, 1e-3, 1e-3}}});
  document["scenes"][0]["nodes"].push_back(document["nodes"].size() - 1);
  std::ofstream(in) << document;
  const std::string out = folder / "out.glb";
  const Outcome outcome = whittle(
      {"simplify", in, "-o", out, "--faces", "6", "--topology", "free", "--max-normal-flip", "180", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(parse_json(outcome.out)["target"]["met"], true);
  EXPECT_THAT(outcome.err, testing::HasSubstr("has vanished; a triangle without area stands for it"));
  const gltf::Asset asset = gltf::Asset::read(out);
  EXPECT_LE(asset.n_triangles(0), 6U);
  ASSERT_EQ(asset.n_triangles(1), 1U);
  const IndexedMesh point = asset.triangles(1);
  for (const Index v : point.faces[0]) EXPECT_EQ(point.positions[v], point.positions[0]);
}

TEST(Gltf, IsRecorded) {
  const TemporaryFolder folder;
  const std::string in = folder / "cube.glb";
  write_gltf_cube(in, 8);
  const Outcome outcome = whittle({"simplify", in, "-o", folder / "out.glb", "--faces", "60", "--record", folder / "r",
                                   "--curve", folder / "c.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(gltf::Asset::read(folder / "out.glb").triangles(0).attributes.size(), 1U) << "the result keeps its texture";
  const Outcome replayed = whittle({"replay", folder / "r", "--faces", "300", "-o", folder / "level.ply"});
  ASSERT_EQ(replayed.exit_code, 0) << replayed;
  EXPECT_NEAR(static_cast<double>(io::read_mesh(folder / "level.ply").mesh.faces.size()), 300, 1);
  EXPECT_THAT(read_text(folder / "c.csv"), testing::HasSubstr("\n768,"));
}

TEST(Gltf, HasACurve) {
  const TemporaryFolder folder;
  const std::string in = folder / "cube.glb";
  write_gltf_cube(in, 6);
  const auto simplify = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"simplify", in, "-o", folder / "out.glb", "--face-ratio", "20%", "--quiet"});
    const Outcome outcome = whittle(options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    return read_text(folder / "out.glb");
  };
  const std::string plain = simplify({});
  EXPECT_EQ(simplify({"--curve", folder / "curve.csv"}), plain) << "the result is the same";
  EXPECT_FALSE(read_text(folder / "curve.csv").empty());
}

TEST(Gltf, HoldsSeamsAsAsked) {
  const TemporaryFolder folder;
  const std::string in = folder / "cube.glb";
  write_gltf_cube(in, 8);
  for (const std::string seams : {"weighted", "keep"}) {
    const std::string out = folder / (seams + ".glb");
    const Outcome outcome =
        whittle({"simplify", in, "-o", out, "--face-ratio", "1%", "--seams", seams, "--json", "-", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome;
    const Json json = parse_json(outcome.out);
    EXPECT_EQ(json["options"]["seams"], seams);
    EXPECT_EQ(json["target"]["met"], seams == "weighted");
    EXPECT_EQ(json["refused_at_end"]["feature"] == 0, seams == "weighted");
    EXPECT_EQ(json["output"]["folded_texture_faces"], 0);
    const std::string warnings = json["warnings"].dump();
    EXPECT_EQ(warnings.find("'--seams weighted' reaches it") != std::string::npos, seams == "keep") << outcome;
  }
  expect_usage_error(whittle({"simplify", in, "-o", folder / "o.glb", "--faces", "9", "--seams", "loose"}),
                     {"--seams"});
}

TEST(Gltf, WeighsAttributesAsAsked) {
  const TemporaryFolder folder;
  const std::string in = folder / "cube.glb";
  write_gltf_cube(in, 8);
  const auto simplify = [&](const std::string& weights) {
    return whittle(
        {"simplify", in, "-o", folder / "out.glb", "--faces", "100", "--json", "-", "--attribute-weight", weights});
  };
  const Outcome outcome = simplify("uv=0.5,joints=0");
  ASSERT_EQ(outcome.exit_code, 0) << outcome;
  EXPECT_EQ(parse_json(outcome.out)["options"]["attribute_weights"],
            "uv=0.5,normal=1,color=1,morph=0.3,joints=0,seam=0.05");
  for (const std::string weights : {"uv", "uv=-1", "texture=1", "uv=1,", "uv=x", ""}) {
    expect_usage_error(simplify(weights), {"--attribute-weight"});
  }
}

/// Turns the cube into a file of points alone, or of triangles that are points.
std::string write_cube_without_faces(const TemporaryFolder& folder, bool has_points) {
  const std::string path = folder / (has_points ? "points.gltf" : "degenerate.gltf");
  write_gltf_cube(path, 2);
  Json document = Json::parse(std::ifstream(path));
  document["accessors"].push_back({{"componentType", 5123}, {"count", 9}, {"type", "SCALAR"}});  // zeros
  for (Json& primitive : document["meshes"][0]["primitives"]) {
    primitive["mode"] = has_points ? 0 : 4;
    primitive["indices"] = document["accessors"].size() - 1;
  }
  std::ofstream(path) << document;
  return path;
}

void expect_same_points(const std::string& path, const std::string& other) {
  const Json before = document_of(path);
  const Json after = document_of(other);
  EXPECT_EQ(other_than_geometry(after), other_than_geometry(before));
  const Json& primitives = before["meshes"][0]["primitives"];
  ASSERT_EQ(after["meshes"][0]["primitives"].size(), primitives.size());
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    const auto positions = [p](const Json& document) -> const Json& {
      return document["accessors"][document["meshes"][0]["primitives"][p]["attributes"]["POSITION"].get<std::size_t>()];
    };
    for (const char* key : {"count", "min", "max"}) EXPECT_EQ(positions(after)[key], positions(before)[key]) << key;
  }
}

TEST(Gltf, WithoutFacesIsWrittenAsItWas) {
  const TemporaryFolder folder;
  for (const bool has_points : {true, false}) {
    const std::string in = write_cube_without_faces(folder, has_points);
    const std::string why =
        has_points ? "there are no triangles in it" : "there are only degenerate triangles in it (9)";
    for (const std::vector<std::string>& target :
         {std::vector<std::string>{"--faces", "1"},
          {"--face-ratio", "10%", "--per-mesh"},
          {"--max-error", "1%"},
          {"--vertices", "5", "--strict", "--prune", "1%", "--self-intersections", "count"}}) {
      for (const char* name : {"out.glb", "out.gltf"}) {
        std::vector<std::string> arguments{"simplify", in, "-o", folder / name, "--json", "-"};
        arguments.insert(arguments.end(), target.begin(), target.end());
        const Outcome outcome = whittle(arguments);
        ASSERT_EQ(outcome.exit_code, 0) << outcome;
        const Json json = parse_json(outcome.out);
        EXPECT_EQ(json["target"]["met"], true);
        EXPECT_EQ(json["output"]["faces"], 0);
        ASSERT_EQ(json["warnings"].size(), 1U) << json["warnings"];
        EXPECT_THAT(json["warnings"][0].get<std::string>(),
                    testing::AllOf(testing::HasSubstr(why), testing::HasSubstr("nothing to simplify")));
        expect_same_points(in, folder / name);
      }
    }
    const Outcome converted = whittle({"convert", in, folder / "converted.glb", "--json", "-"});
    ASSERT_EQ(converted.exit_code, 0) << converted;
    EXPECT_EQ(parse_json(converted.out)["output"]["faces"], 0);
    expect_same_points(in, folder / "converted.glb");
  }
}

TEST(Gltf, WithoutFacesIsRefusedWhereFacesAreNeeded) {
  const TemporaryFolder folder;
  const std::string in = write_cube_without_faces(folder, true);
  const std::string out = folder / "out.ply";
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"simplify", in, "-o", out, "--faces", "1"},
        {"simplify", in, "-o", folder / "out.glb", "--faces", "1", "--curve", folder / "c.csv"},
        {"convert", in, out},
        {"info", in},
        {"measure", in, in},
        {"report", in, "-o", folder / "page.html"}}) {
    const Outcome outcome = whittle(command);
    EXPECT_EQ(outcome.exit_code, 4) << outcome;
    EXPECT_THAT(outcome.err, testing::HasSubstr(in + ": there are no triangles in it")) << outcome;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome;
  }
}

TEST(Gltf, RefusesWhatItCannotDo) {
  const TemporaryFolder folder;
  const std::string in = folder / "cube.glb";
  write_gltf_cube(in, 3);
  const std::string out = folder / "out.glb";
  expect_usage_error(whittle({"simplify", in, "-o", folder / "o.ply", "--faces", "9", "--compress"}), {"--compress"});
  expect_usage_error(whittle({"convert", in, folder / "o.ply", "--quantize"}), {"--quantize", "glTF"});
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--per-mesh", "--curve", folder / "c.svg"},
                                                  {"--per-mesh", "--page", folder / "p.html"},
                                                  {"--per-mesh", "--live", folder / "p.html"},
                                                  {"--map", folder / "m"},
                                                  {"--engine", "openmesh"},
                                                  {"--weld", "1%"},
                                                  {"--threshold", "auto"}}) {
    std::vector<std::string> all{"simplify", in, "-o", out, "--faces", "9"};
    all.insert(all.end(), options.begin(), options.end());
    expect_usage_error(whittle(all), {options.front()});
  }
  const Outcome unread = whittle({"compare", in, "--faces", "9"});
  EXPECT_EQ(unread.exit_code, 4) << unread;
  EXPECT_THAT(unread.err, testing::HasSubstr("'whittle convert' makes " + io::format_titles() + " of it"));
  expect_usage_error(whittle({"simplify", in, "-o", folder / "o.glb.gz", "--faces", "9"}), {".gz"});
  std::ofstream(folder / "cut.glb") << "glTF";
  const Outcome outcome = whittle({"simplify", folder / "cut.glb", "-o", out, "--faces", "9"});
  EXPECT_EQ(outcome.exit_code, 4) << outcome;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome;
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace whittle::test
