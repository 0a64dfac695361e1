// A rough level is small, and lies where the mesh lies.
#include <gtest/gtest.h>

#include "support/shapes/shapes.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/report/rough_level.hh"

namespace whittle::test {
namespace {

TEST(RoughLevel, LooksLikeTheMesh) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    SCOPED_TRACE(scale);
    IndexedMesh mesh = noisy_sphere(6, 0.01, 1);  // 81,920 faces
    for (Vec3& position : mesh.positions) position = scale * (position + Vec3(100, 0, 0));
    const IndexedMesh level = report::rough_level(mesh, 5000);
    EXPECT_LE(level.faces.size(), 5000U);
    EXPECT_GE(level.faces.size(), 1000U);
    metrics::DistanceOptions how;
    how.samples = 20'000;
    const double diagonal = diagonal_of(bounds_of(mesh));
    EXPECT_LT(metrics::surface_distance(mesh, level, how).max, 0.05 * diagonal);
  }
}

TEST(RoughLevel, KeepsAMeshOfFewFaces) {
  const IndexedMesh mesh = noisy_sphere(3, 0.01, 1);
  const IndexedMesh level = report::rough_level(mesh, mesh.faces.size());
  EXPECT_EQ(level.positions, mesh.positions);
  EXPECT_EQ(level.faces, mesh.faces);
}

/// Triangles of which each is smaller than a cell.
TEST(RoughLevel, HasFacesOfScatteredParts) {
  IndexedMesh mesh;
  for (Index i = 0; i < 3000; i += 3) {
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1e-9, 0, 0), Vec3(0, 1e-9, 0)}) {
      mesh.positions.push_back(corner + Vec3(i % 97, i % 89, i % 83));
    }
    mesh.faces.push_back({i, i + 1, i + 2});
  }
  const IndexedMesh level = report::rough_level(mesh, 100);
  EXPECT_FALSE(level.faces.empty());
  EXPECT_LE(level.faces.size(), 100U);
}

TEST(RoughLevel, HasFacesWhereAllLieInOnePoint) {
  IndexedMesh mesh;
  for (Index i = 0; i < 30; ++i) mesh.positions.emplace_back(1, 2, 3);
  for (Index i = 0; i < 30; i += 3) mesh.faces.push_back({i, i + 1, i + 2});
  EXPECT_EQ(report::rough_level(mesh, 5).faces.size(), 5U);
}

}  // namespace
}  // namespace whittle::test
