// What is proven of glTF files: of their scenes as they are shown, read again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_cube.hh"
#include "program/gltf_scene.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/write.hh"
#include "whittle/pipeline/run.hh"
#include "whittle/scene/read_scene.hh"

namespace whittle::test {
namespace {

using Arguments = std::vector<std::string>;
using Json = nlohmann::json;
using testing::HasSubstr;

/// The largest distance that is found between two scenes as they are shown.
double measured_distance(const std::string& input, const std::string& output) {
  const Outcome measured = whittle({"measure", input, output, "--samples", "1000", "--exact", "1e-3", "--json", "-"});
  EXPECT_EQ(measured.exit_code, 0) << measured;
  const Json exact = parse_json(measured.out)["exact"];
  return std::max(exact["forward"]["at_least"].get<double>(), exact["backward"]["at_least"].get<double>());
}

TEST(GltfError, IsLimitedWhereAMeshIsDrawnOut) {
  const TemporaryFolder folder;
  const std::string in = folder / "in.glb";
  const std::string out = folder / "out.glb";
  write_gltf_scene(in, {knot(100, 12)},
                   {{{"mesh", 0}}, {{"mesh", 0}, {"scale", {0.1, 0.1, 4}}, {"translation", {9, 0, 0}}}}, {0, 1});
  const Outcome run = whittle({"simplify", in, "-o", out, "--max-error", "0.05", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const double found = measured_distance(in, out);
  EXPECT_LE(found, 0.05);
  EXPECT_LE(found, parse_json(run.out)["max_error"]["proven"]);
  const Outcome certified = whittle({"simplify", in, "-o", out, "--faces", "500", "--certify", "--json", "-"});
  ASSERT_EQ(certified.exit_code, 0) << certified;
  EXPECT_LE(measured_distance(in, out), parse_json(certified.out)["max_error"]["proven"]);
  const std::string level = folder / "level_{i}.glb";
  const Outcome levels = whittle({"lod", in, "-o", level, "--errors", "0.05"});
  ASSERT_EQ(levels.exit_code, 0) << levels;
  EXPECT_LE(measured_distance(in, folder / "level_0.glb"), 0.05);
}

class GltfCertificate : public testing::Test {
 protected:
  /// A file, the result by these options, and the certificate of both, which holds.
  void expect_proven(const std::string& input, const std::string& output, const Arguments& options) {
    Arguments all{"simplify", input, "-o", output, "--certificate", proof_, "--json", "-", "--force"};
    all.insert(all.end(), options.begin(), options.end());
    const Outcome run = whittle(all);
    ASSERT_EQ(run.exit_code, 0) << run;
    run_ = parse_json(run.out);
    EXPECT_LT(run_["output"]["faces"], run_["input"]["faces"]);
    const Outcome verified = whittle({"verify", input, output, proof_, "--json", "-"});
    ASSERT_EQ(verified.exit_code, 0) << verified;
    verified_ = parse_json(verified.out);
    EXPECT_LE(measured_distance(input, output), verified_["max_error"].get<double>() * (1 + 1e-9));
  }

  TemporaryFolder folder_;
  std::string in_ = folder_ / "in.glb";
  std::string out_ = folder_ / "out.glb";
  std::string proof_ = folder_ / "proof";
  Json run_;
  Json verified_;
};

/// A knot three times, once mirrored and once drawn out, and a sphere that isn't shown.
void write_three_knots(const std::string& path) {
  write_gltf_scene(path, {knot(100, 12), sphere(3)},
                   {{{"mesh", 0}, {"translation", {9, 0, 0}}},
                    {{"mesh", 0}, {"scale", {-1, 1, 1}}},
                    {{"children", {3}}, {"scale", {0.2, 0.2, 3}}, {"translation", {0, 9, 0}}},
                    {{"mesh", 0}, {"rotation", {0.6, 0, 0, 0.8}}},
                    {{"mesh", 1}}},
                   {0, 1, 2});
}

TEST_F(GltfCertificate, IsAboutEachPlaceOfAMesh) {
  write_three_knots(in_);
  const double limit = 0.05;
  for (const Arguments& more :
       {Arguments{}, {"--compress"}, {"--quantize", "--merge-meshes"}, {"--topology", "free", "--boundary", "free"}}) {
    SCOPED_TRACE(testing::PrintToString(more));
    Arguments options{"--max-error", std::to_string(limit)};
    options.insert(options.end(), more.begin(), more.end());
    expect_proven(in_, out_, options);
    EXPECT_EQ(verified_["max_error"], limit);
    EXPECT_EQ(verified_["input"]["faces"], 3 * 2400);
    EXPECT_EQ(run_["input"]["faces"], 2400 + 1280);
  }
  expect_proven(in_, out_, {"--face-ratio", "20%"});
  EXPECT_GT(verified_["max_error"], 0);
}

TEST_F(GltfCertificate, GoesWithPrimitivesSeamsAndPoints) {
  write_gltf_cube(in_, 8);
  for (const std::string name : {"out.glb", "out.gltf"}) {
    expect_proven(in_, folder_ / name, {"--max-error", "1%"});
    expect_proven(in_, folder_ / name, {"--max-error", "1%", "--compress"});
  }
  EXPECT_THAT(gltf::Asset::read(folder_ / "out.gltf").other_content(), testing::Contains("points"));
  const std::string quantized = folder_ / "quantized.glb";
  ASSERT_EQ(whittle({"simplify", in_, "-o", quantized, "--face-ratio", "99%", "--compress"}).exit_code, 0);
  expect_proven(quantized, out_, {"--max-error", "1%"});
}

/// A hemisphere and a quarter of a sphere: borders that meet, and borders that don't.
TEST_F(GltfCertificate, TellsOfBorders) {
  IndexedMesh left = sphere(4);
  IndexedMesh right = left;
  const auto is_left = [&](const Triangle& face) {
    return left.positions[face[0]].x() + left.positions[face[1]].x() + left.positions[face[2]].x() < 0;
  };
  std::erase_if(right.faces, [&](const Triangle& face) {
    return is_left(face) || right.positions[face[0]].y() + right.positions[face[1]].y() > 0;
  });
  std::erase_if(left.faces, [&](const Triangle& face) { return !is_left(face); });
  write_gltf_scene(in_, {left, right}, {{{"mesh", 0}, {"scale", {2, 2, 2}}}, {{"mesh", 1}, {"scale", {2, 2, 2}}}},
                   {0, 1});
  expect_proven(in_, out_, {"--max-error", "0.05", "--max-error-borders", "0.02"});
  EXPECT_EQ(verified_["max_error_borders"], 0.02);
}

TEST_F(GltfCertificate, GoesFromAndToOtherFormats) {
  write_three_knots(in_);
  expect_proven(in_, folder_ / "out.ply", {"--max-error", "0.05"});
  expect_proven(in_, out_, {"--max-error", "0.05", "--attributes", "position-only", "--compress"});
  IndexedMesh far = knot(100, 12);
  for (Vec3& p : far.positions) p += Vec3(4e6, 5e6, 0);
  const std::string ply = folder_ / "far.ply";
  io::write_mesh(ply, far);
  expect_proven(ply, out_, {"--max-error", "0.05"});
  expect_proven(ply, out_, {"--max-error", "0.05", "--compress"});
}

/// As the Python package has it: a result that isn't written is one mesh, and so is what it is compared with.
TEST_F(GltfCertificate, IsAboutOneMeshIfTheOutputIsOne) {
  write_three_knots(in_);
  Request request;
  request.output.format = &format_of(io::Format::ply);
  request.makes_certificate = true;
  request.targets.max_error = Length{0.05};
  const Plan settled = plan(read_scene(in_), request);
  const whittle::Outcome outcome = run(settled);
  io::write_mesh(folder_ / "in.ply", settled.scene.read.mesh);
  io::write_mesh(folder_ / "out.ply", outcome.simplified.mesh);
  write_text(proof_, outcome.certificate);
  const Outcome verified = whittle({"verify", folder_ / "in.ply", folder_ / "out.ply", proof_});
  EXPECT_EQ(verified.exit_code, 0) << verified;
}

TEST_F(GltfCertificate, DoesNotHoldForAnotherScene) {
  write_three_knots(in_);
  expect_proven(in_, out_, {"--max-error", "0.05"});
  const std::string other = folder_ / "other.glb";
  gltf::Asset asset = gltf::Asset::read(out_);
  IndexedMesh moved = asset.triangles(0);
  moved.positions[moved.faces[0][0]] *= 1.5;
  asset.set_triangles(0, moved);
  asset.write(other);
  expect_failure(whittle({"verify", in_, other, proof_, "--quiet"}), 1,
                 {proof_ + ": does not hold for " + in_ + " and " + other});
  expect_failure(whittle({"verify", in_, in_, proof_, "--quiet"}), 1, {"it is about other meshes: OUT "});
}

TEST_F(GltfCertificate, IsRefusedWhereRoundingIsLargerThanTheLimit) {
  write_three_knots(in_);
  const Outcome run = whittle({"simplify", in_, "-o", out_, "--max-error", "1e-6", "--compress"});
  EXPECT_EQ(run.exit_code, 1) << run;
  EXPECT_THAT(run.err, HasSubstr("choose a larger --max-error, or leave out --compress"));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(GltfCertificate, RefusesWhatCountsAMeshOnce) {
  write_three_knots(in_);
  for (const Arguments& wish :
       {Arguments{"--compress", "--certify"}, {"--quantize", "--certify"}, {"--certificate", proof_}}) {
    for (const Arguments& other : {Arguments{"--prune", "1%"}, {"--tolerance-map", folder_ / "map"}}) {
      Arguments all{"simplify", in_, "-o", out_, "--max-error", "0.05"};
      all.insert(all.end(), wish.begin(), wish.end());
      all.insert(all.end(), other.begin(), other.end());
      expect_usage_error(whittle(all), {other.front(), wish.front()});
    }
  }
}

}  // namespace
}  // namespace whittle::test
