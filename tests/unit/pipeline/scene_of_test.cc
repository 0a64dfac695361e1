// Meshes in memory, as scenes.
#include <gtest/gtest.h>

#include <sstream>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"
#include "whittle/pipeline/plan.hh"
#include "whittle/scene/read_scene.hh"

namespace whittle::test {
namespace {

/// The mesh as it is read from a PLY file.
io::ReadResult read_again(const IndexedMesh& mesh) {
  std::ostringstream out;
  io::write_mesh(out, io::Format::ply, mesh);
  const std::string bytes = std::move(out).str();
  return io::read_mesh(std::span(bytes.data(), bytes.size()), "mesh.ply");
}

TEST(MeshInMemory, IsReadAsFromAFile) {
  for (const auto& [name, mesh] : all_meshes()) {
    SCOPED_TRACE(name);
    const IndexedMesh plain = without_attributes(mesh);
    const io::ReadResult expected = read_again(plain);
    const io::ReadResult taken = io::take_mesh(plain, "mesh");
    EXPECT_EQ(taken.mesh.positions, expected.mesh.positions);
    EXPECT_EQ(taken.mesh.faces, expected.mesh.faces);
    EXPECT_EQ(taken.mesh.origins, expected.mesh.origins);
    EXPECT_EQ(taken.vertex_map, expected.vertex_map);
    EXPECT_EQ(taken.repairs.entries(), expected.repairs.entries());
    EXPECT_EQ(taken.file_vertices, mesh.positions.size());
    EXPECT_EQ(taken.file_faces, mesh.faces.size());
  }
}

TEST(MeshInMemory, IsRefusedWithoutFaces) {
  IndexedMesh mesh = single_triangle();
  mesh.faces.clear();
  EXPECT_THROW(io::take_mesh(mesh, "mesh"), io::ReadError);
  mesh.faces = {{0, 1, 1}};
  EXPECT_THROW(io::take_mesh(mesh, "mesh"), io::ReadError);
  mesh = single_triangle();
  mesh.positions[1].x() = 1e200;
  EXPECT_THROW(scene_of(mesh, "mesh", {}), UnsupportedMesh);
}

TEST(MeshInMemory, IsWeldedAsAsked) {
  const IndexedMesh apart = soup(blob(2, 1));
  EXPECT_LT(scene_of(apart, "mesh", {}).read.mesh.positions.size(), apart.positions.size() / 2);
  const Scene as_given = scene_of(apart, "mesh", {}, {.weld = false});
  EXPECT_EQ(as_given.read.mesh.positions.size(), apart.positions.size());
  IndexedMesh with_gaps = apart;
  double gap = 0;
  for (Vec3& p : with_gaps.positions) p.x() += (gap = 1e-7 - gap);
  SceneReadOptions options;
  options.weld_tolerance.length = {1e-5, false};
  const Scene welded = scene_of(with_gaps, "mesh", {}, options);
  EXPECT_EQ(welded.weld_tolerance, 1e-5);
  EXPECT_LT(welded.read.mesh.positions.size(), apart.positions.size() / 2);
}

TEST(MeshInMemory, HasTolerances) {
  const IndexedMesh mesh = blob(3, 1);
  Request request;
  request.targets.max_error = Length{0.1, false};
  const Plan settled = plan(scene_of(mesh, "mesh", std::vector<double>(mesh.positions.size(), 0.01)), request);
  EXPECT_EQ(settled.options.decimate.tolerances, std::vector<double>(mesh.positions.size(), 0.01));
}

}  // namespace
}  // namespace whittle::test
