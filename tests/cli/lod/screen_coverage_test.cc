// Where the levels of a node take over from one another: MSFT_screencoverage.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "program/gltf_scene.hh"
#include "program/program.hh"
#include "support/shapes/shapes.hh"
#include "support/temporary_folder.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/transform.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/metrics/certify.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;

/// Pixels of a screen of 1920 × 1080 along the diagonal of a box whose sphere covers this share of it.
double pixels_at(double coverage) { return std::sqrt(coverage * 1920 * 1080 * 4 / std::numbers::pi); }

IndexedMesh mesh_at(IndexedMesh mesh, const Eigen::Matrix4d& place) {
  transform_mesh(mesh, Eigen::Affine3d(place));
  return mesh;
}

/// At the coverage of each level of a mesh the next level is proven to be within a pixel, at each of its places.
void expect_a_pixel_at_most(const gltf::Asset& asset, std::size_t mesh, const Json& node) {
  const Json document = Json::parse(asset.document());
  const Json& ids = node["extensions"]["MSFT_lod"]["ids"];
  const Json& coverage = node["extras"]["MSFT_screencoverage"];
  ASSERT_EQ(coverage.size(), ids.size() + 1);
  for (const Eigen::Matrix4d& place : asset.world_transforms(mesh)) {
    const IndexedMesh finest = mesh_at(asset.triangles(mesh), place);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      ASSERT_LT(coverage[k], 1);
      const IndexedMesh level = mesh_at(asset.triangles(document["nodes"][ids[k].get<std::size_t>()]["mesh"]), place);
      const double pixel = diagonal_of(finest.positions) / pixels_at(coverage[k]);
      EXPECT_EQ(metrics::certify(finest, level, pixel * (1 + 1e-6)).verdict, Verdict::proven) << node << " level " << k;
    }
  }
}

/// Each of them for two meshes.
const std::vector<Json> coverage_scenes{
    {{{"mesh", 0}}, {{"mesh", 1}, {"translation", {50, 0, 0}}}},
    {{{"mesh", 0}, {"rotation", {0, 0.6, 0, 0.8}}, {"scale", {1000, 1000, 1000}}}, {{"mesh", 1}}},
    {{{"mesh", 0}, {"scale", {20, 1, 0.1}}}, {{"mesh", 1}, {"scale", {1, 1, 30}}}},
    {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {50, 0, 0}}, {"scale", {1, 8, 0.2}}}, {{"mesh", 1}}},
    {{{"mesh", 0}, {"scale", {1, 1, 0}}}, {{"mesh", 1}}}};

TEST(ScreenCoverage, LeavesAPixelAtMostWhereverAMeshIsShown) {
  for (const Json& nodes : coverage_scenes) {
    for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--compress"}}) {
      const TemporaryFolder folder;
      const std::string in = folder / "in.glb";
      std::vector<std::size_t> roots(nodes.size());
      for (std::size_t i = 0; i < roots.size(); ++i) roots[i] = i;
      write_gltf_scene(in, {sphere(3), torus(24, 12)}, nodes, roots);
      std::vector<std::string> command{"lod", in, "--ratios", "60%,30%,10%", "-o", folder / "out.glb"};
      command.insert(command.end(), more.begin(), more.end());
      const Outcome outcome = whittle(command);
      ASSERT_EQ(outcome.exit_code, 0) << outcome;
      const gltf::Asset asset = gltf::Asset::read(folder / "out.glb");
      for (const Json& node : Json::parse(asset.document())["nodes"]) {
        if (node.contains("extensions")) expect_a_pixel_at_most(asset, node["mesh"], node);
      }
    }
  }
}

TEST(ScreenCoverage, FollowsTheErrorThatMayBeSeen) {
  const TemporaryFolder folder;
  const auto coverage_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command{"lod", data_file("blob.obj"), "--ratios", "20%,5%", "-o", folder / "out.glb"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = whittle(command);
    EXPECT_EQ(outcome.exit_code, 0) << outcome;
    const Json document = Json::parse(gltf::Asset::read(folder / "out.glb").document());
    return document["nodes"][0]["extras"]["MSFT_screencoverage"].get<std::vector<double>>();
  };
  const std::vector<double> usual = coverage_of({});
  const std::vector<double> seen = coverage_of({"--target-pixels", "2", "--view-height", "720"});
  for (std::size_t i = 0; i < usual.size(); ++i) EXPECT_DOUBLE_EQ(seen[i], std::min(1.0, 9 * usual[i]));
}

}  // namespace
}  // namespace whittle::test
