// A surface in several meshes of a glTF file, closed in the scene, stays closed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include "program/failure.hh"
#include "program/gltf_scene.hh"
#include "program/program.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/pieces.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/read.hh"

namespace whittle::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

/// Joins vertices that lie almost at one place, one by one.
std::vector<Index> places_of(const std::vector<Vec3>& positions) {
  std::vector<Index> by_x(positions.size());
  std::iota(by_x.begin(), by_x.end(), Index{0});
  std::sort(by_x.begin(), by_x.end(), [&](Index a, Index b) { return positions[a].x() < positions[b].x(); });
  constexpr double near = 1e-5;
  std::vector<Index> place(positions.size(), invalid_index);
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    if (place[by_x[i]] == invalid_index) place[by_x[i]] = by_x[i];
    for (std::size_t k = i + 1; k < by_x.size(); ++k) {
      const Vec3 difference = positions[by_x[k]] - positions[by_x[i]];
      if (difference.x() > near) break;
      if (difference.norm() < near) place[by_x[k]] = place[by_x[i]];
    }
  }
  return place;
}

/// Edges that have other than two faces.
std::size_t n_open_edges(const std::vector<Vec3>& positions, const std::vector<Triangle>& faces) {
  const std::vector<Index> place = places_of(positions);
  std::map<std::pair<Index, Index>, int> n_faces;
  for (const Triangle& face : faces) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Index a = place[face[c]];
      const Index b = place[face[(c + 1) % 3]];
      if (a != b) ++n_faces[std::minmax(a, b)];
    }
  }
  return static_cast<std::size_t>(
      std::count_if(n_faces.begin(), n_faces.end(), [](const auto& edge) { return edge.second != 2; }));
}

std::size_t n_open_edges_in_scene(const std::string& path) {
  const gltf::Asset asset = gltf::Asset::read(path);
  std::vector<Vec3> positions;
  std::vector<Triangle> faces;
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    const IndexedMesh mesh = asset.triangles(m);
    for (const Eigen::Matrix4d& place : asset.world_transforms(m)) {
      const auto first = static_cast<Index>(positions.size());
      for (const Vec3& p : mesh.positions) positions.push_back(Eigen::Affine3d(place) * p);
      for (const auto& [a, b, c] : mesh.faces) faces.push_back({first + a, first + b, first + c});
    }
  }
  return n_open_edges(positions, faces);
}

std::size_t n_open_edges_in_file(const std::string& path) {
  const IndexedMesh mesh = io::read_mesh(path).mesh;
  return n_open_edges(mesh.positions, mesh.faces);
}

std::vector<IndexedMesh> pieces_of_sphere(std::size_t n) {
  const IndexedMesh whole = sphere(4);
  std::vector<Index> piece_of;
  for (const auto& [a, b, c] : whole.faces) {
    const Vec3 middle = whole.positions[a] + whole.positions[b] + whole.positions[c];
    const double around = std::atan2(middle.y(), middle.x()) / 6.2832 + 0.5;
    const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
    const auto row = std::min(rows - 1, static_cast<std::size_t>((middle.normalized().z() + 1) / 2 * double(rows)));
    piece_of.push_back(static_cast<Index>(row * (n / rows) + static_cast<std::size_t>(around * double(n / rows))));
  }
  std::vector<IndexedMesh> pieces;
  for (MeshPiece& piece : split_mesh(whole, piece_of, n)) pieces.push_back(std::move(piece.mesh));
  return pieces;
}

Eigen::Affine3d any_rigid_place(Random& random) {
  const auto number = [&] { return random.uniform(-1, 1); };
  Eigen::Affine3d place = Eigen::Affine3d::Identity();
  place.translate(3 * Vec3(number(), number(), number()));
  return place.rotate(Eigen::Quaterniond(number(), number(), number(), number()).normalized());
}

/// A node whose mesh lies there. Numbers have 32 bits, as exporters write them.
Json node_at(const Eigen::Affine3d& place, std::size_t mesh) {
  const Eigen::Quaternionf turn(Eigen::Quaterniond(place.linear()).cast<float>());
  const Eigen::Vector3f way = place.translation().cast<float>();
  return {{"mesh", mesh},
          {"rotation", {turn.x(), turn.y(), turn.z(), turn.w()}},
          {"translation", {way.x(), way.y(), way.z()}}};
}

/// The number of meshes, and whether each has coordinates of its own.
class SphereOfMeshes : public testing::TestWithParam<std::tuple<std::size_t, bool>> {
 protected:
  SphereOfMeshes() {
    std::vector<IndexedMesh> pieces = pieces_of_sphere(std::get<0>(GetParam()));
    Json nodes = Json::array();
    std::vector<std::size_t> roots;
    Random random(7);
    for (IndexedMesh& piece : pieces) {
      const std::size_t i = roots.size();
      roots.push_back(i);
      const Eigen::Affine3d place =
          std::get<1>(GetParam()) ? any_rigid_place(random) : Eigen::Affine3d(Eigen::Affine3d::Identity());
      nodes.push_back(node_at(place, i));
      for (Vec3& p : piece.positions) p = place.inverse() * p;
    }
    write_gltf_scene(in_, pieces, nodes, roots);
  }

  TemporaryFolder folder_;
  std::string in_ = folder_ / "in.glb";
  std::string out_ = folder_ / "out.glb";
};

TEST_P(SphereOfMeshes, StaysClosedInTheScene) {
  ASSERT_EQ(n_open_edges_in_scene(in_), 0U);
  for (const char* const ratio : {"50%", "10%", "2%"}) {
    for (const char* const effort : {"fast", "normal", "best"}) {
      const Outcome run = whittle({"simplify", in_, "-o", out_, "--face-ratio", ratio, "--effort", effort});
      ASSERT_EQ(run.exit_code, 0) << run;
      EXPECT_EQ(n_open_edges_in_scene(out_), 0U) << run;
    }
  }
  EXPECT_EQ(whittle({"convert", in_, out_, "--force"}).exit_code, 0);
  const gltf::Asset before = gltf::Asset::read(in_);
  const gltf::Asset after = gltf::Asset::read(out_);
  for (std::size_t m = 0; m < before.n_meshes(); ++m) {
    EXPECT_EQ(before.triangles(m).positions.size(), after.triangles(m).positions.size());
    EXPECT_EQ(before.triangles(m).faces.size(), after.triangles(m).faces.size());
  }
}

TEST_P(SphereOfMeshes, IsClosedInOtherFormats) {
  const std::string ply = folder_ / "out.ply";
  ASSERT_EQ(whittle({"convert", in_, ply}).exit_code, 0);
  EXPECT_EQ(n_open_edges_in_file(ply), 0U);
  EXPECT_EQ(io::read_mesh(ply).mesh.faces.size(), sphere(4).faces.size());
  ASSERT_EQ(whittle({"simplify", in_, "-o", ply, "--face-ratio", "10%"}).exit_code, 0);
  EXPECT_EQ(n_open_edges_in_file(ply), 0U);
  const Outcome info = whittle({"info", in_, "--json", "-"});
  EXPECT_EQ(parse_json(info.out)["closed"], true) << info;
}

TEST_P(SphereOfMeshes, StaysClosedMeshByMeshAndInLevels) {
  const Outcome run = whittle({"simplify", in_, "-o", out_, "--face-ratio", "30%", "--per-mesh"});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(n_open_edges_in_scene(out_), 0U) << run;
  const Outcome levels = whittle({"lod", in_, "-o", folder_ / "{i}.glb", "--face-ratios", "30%,10%"});
  ASSERT_EQ(levels.exit_code, 0) << levels;
  for (const char* const name : {"0.glb", "1.glb"}) EXPECT_EQ(n_open_edges_in_scene(folder_ / name), 0U) << levels;
  const Outcome polished = whittle({"polish", in_, folder_ / "1.glb", "-o", out_, "--force"});
  ASSERT_EQ(polished.exit_code, 0) << polished;
  EXPECT_EQ(n_open_edges_in_scene(out_), 0U) << polished;
}

TEST_P(SphereOfMeshes, IsProvenToBeNear) {
  const Outcome run = whittle({"simplify", in_, "-o", out_, "--max-error", "0.02", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(n_open_edges_in_scene(out_), 0U) << run;
  const double proven = parse_json(run.out)["max_error"]["proven"];
  EXPECT_LE(proven, 0.02);
  EXPECT_LT(parse_json(run.out)["output"]["faces"], 2000);
}

INSTANTIATE_TEST_SUITE_P(Meshes, SphereOfMeshes, testing::Combine(testing::Values(2U, 8U, 64U), testing::Bool()));

/// Half a sphere, twice: what moves one border moves the other one, too, and to another place.
TEST(RepeatedMesh, HoldsTheBordersWhereItMeetsItself) {
  const TemporaryFolder folder;
  const std::string in = folder / "in.glb";
  const std::string out = folder / "out.glb";
  const IndexedMesh whole = sphere(4);
  std::vector<Index> piece_of;
  for (const auto& [a, b, c] : whole.faces) {
    const Vec3 middle = whole.positions[a] + whole.positions[b] + whole.positions[c];
    const bool is_front = std::abs(middle.x()) < 1e-9 ? middle.y() > 0 : middle.x() > 0;
    piece_of.push_back(is_front ? 0 : 1);
  }
  write_gltf_scene(in, {split_mesh(whole, piece_of, 2)[0].mesh},
                   {{{"mesh", 0}}, {{"mesh", 0}, {"rotation", {0, 0, 1, 0}}}}, {0, 1});
  ASSERT_EQ(n_open_edges_in_scene(in), 0U);
  for (const char* const effort : {"fast", "best"}) {
    const Outcome run = whittle({"simplify", in, "-o", out, "--face-ratio", "20%", "--effort", effort});
    ASSERT_EQ(run.exit_code, 0) << run;
    EXPECT_THAT(run.err, HasSubstr("meshes that the scene shows several times meet others there"));
    EXPECT_EQ(n_open_edges_in_scene(out), 0U) << run;
  }
  ASSERT_EQ(whittle({"lod", in, "-o", folder / "{i}.glb", "--face-ratios", "20%"}).exit_code, 0);
  EXPECT_EQ(n_open_edges_in_scene(folder / "0.glb"), 0U);
  ASSERT_EQ(whittle({"simplify", in, "-o", folder / "out.ply", "--face-ratio", "10%"}).exit_code, 0);
  EXPECT_EQ(n_open_edges_in_file(folder / "out.ply"), 0U);
}

}  // namespace
}  // namespace whittle::test
