// `simplify` within an error, beside the levels that `levels_within` finds of a plain run.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/shapes/two_sided.hh"
#include "whittle/metrics/certify.hh"
#include "whittle/progressive/levels.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

std::vector<std::pair<std::string, IndexedMesh>> cad_shapes(int n) {
  return {{"fans", capped_cylinder(n, Caps::fan)},
          {"strips", capped_cylinder(n, Caps::strip)},
          {"middles", capped_cylinder(n, Caps::center)},
          {"cone", cone(n)},
          {"washer", washer(n)},
          {"plate, fans", drilled_plate(n, Caps::fan)},
          {"plate, strip", drilled_plate(n, Caps::strip)}};
}

/// In fans and strips each face is long and thin, and a vertex may have an edge to each other one.
TEST(SlowWithinError, LeavesNoMoreFacesThanALevelOfAPlainRun) {
  for (const int n : {64, 148}) {
    for (const auto& [name, mesh] : cad_shapes(n)) {
      for (const double error : {0.01, 0.001}) {
        SCOPED_TRACE(name + " " + std::to_string(n) + ", within " + std::to_string(error));
        const Simplification result = simplify(mesh, DecimateTarget::max_error(error));
        const std::vector<progressive::ProvenLevel> levels = progressive::levels_within(mesh, {error});
        ASSERT_EQ(levels.size(), 1U);
        EXPECT_LE(result.mesh.faces.size(), levels[0].mesh.faces.size());
        EXPECT_EQ(metrics::certify(mesh, result.mesh, error).verdict, Verdict::proven);
      }
    }
  }
}

TEST(SlowWithinError, LeavesFewFacesOfFans) {
  for (const Caps caps : {Caps::fan, Caps::strip, Caps::center}) {
    const IndexedMesh mesh = capped_cylinder(200, caps);
    const Simplification result = simplify(mesh, DecimateTarget::max_error(0.001));
    EXPECT_LT(result.mesh.faces.size(), mesh.faces.size() / 2) << static_cast<int>(caps);
  }
}

TEST(SlowWithinError, LevelsOfSheetsHaveBothSides) {
  const IndexedMesh mesh = with_backs(noisy_grid(12, 12, 0.1, 3));
  const std::vector<progressive::ProvenLevel> levels = progressive::levels_within(mesh, {0.1, 0.3});
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_LT(levels[0].mesh.faces.size(), mesh.faces.size());
  EXPECT_LT(levels[1].mesh.faces.size(), levels[0].mesh.faces.size());
  for (const progressive::ProvenLevel& level : levels) {
    EXPECT_EQ(level.mesh.faces.size() % 2, 0U);
    EXPECT_EQ(metrics::certify(mesh, level.mesh, level.error).verdict, Verdict::proven);
  }
}

/// Where two cubes meet face to face, that face is there twice, and each edge of it has four faces.
TEST(SlowWithinError, EndsWhereSurfacesTouch) {
  IndexedMesh right = tessellated_cube(6);
  for (Vec3& p : right.positions) p.x() += 2;
  const IndexedMesh mesh = glued(joined(tessellated_cube(6), right));
  for (const double error : {1e-2, 1e-4, 1e-6}) {
    SCOPED_TRACE(error);
    const Simplification result = simplify(mesh, DecimateTarget::max_error(error));
    EXPECT_LE(result.mesh.faces.size(), mesh.faces.size());
    EXPECT_EQ(result.result.proven_error, error);
  }
  EXPECT_LT(simplify(mesh, DecimateTarget::max_error(1e-3)).mesh.faces.size(), mesh.faces.size() / 2);
}

}  // namespace
}  // namespace whittle::test
