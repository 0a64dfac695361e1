#include "whittle/core/local_functions.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::test {
namespace {

/// A tetrahedron of this height, as one wedge: its four corners always lie on a linear function.
LocalFunction function_on_tetrahedron(double height, const std::vector<double>& values) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, height}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const std::vector<Index> map(4, 0);
  const LocalFunctions functions(mesh, Frame::of_points(mesh.positions), map, 1, 1);
  return functions.around(0, 1, [&](Index w, std::size_t) { return values[w]; }).front();
}

TEST(LocalFunctions, GainNoMoreThanAQuarterOfTheRange) {
  for (const double height : {1.0, 0.1, 0.01}) {
    const LocalFunction function = function_on_tetrahedron(height, {0, 0, 0, 1});
    ASSERT_TRUE(function.is_linear) << height;
    const Vec3 up = function.slope.normalized();
    const double one = 1 / function.slope.norm();  // the way on which the function gains 1
    EXPECT_NEAR(function.gain(0.1 * one * up), 0.1, 1e-12) << height;
    EXPECT_NEAR(function.gain(-0.2 * one * up), -0.2, 1e-12) << height;
    EXPECT_DOUBLE_EQ(function.gain(5 * one * up), 0.25) << height;
    EXPECT_DOUBLE_EQ(function.gain(-5 * one * up), -0.25) << height;
  }
}

TEST(LocalFunctions, GainAllWhereTheyHold) {
  LocalFunction function = function_on_tetrahedron(0.1, {0, 0, 0, 1});
  function.holds = true;
  EXPECT_NEAR(function.gain(5 / function.slope.squaredNorm() * function.slope), 5, 1e-12);
}

}  // namespace
}  // namespace whittle::test
