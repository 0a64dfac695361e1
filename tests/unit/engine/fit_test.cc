#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "support/shapes/shapes.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/detail/decimate_and_fit.hh"
#include "whittle/metrics/certify.hh"

// A run that is fitted to its input in the end.

namespace whittle::test {
namespace {

using detail::decimate_and_fit;
using detail::FittedDecimation;

/// Moves the first vertices.
detail::Fit move_up(Index n_vertices, double way) {
  return [=](Decimation& decimation) {
    for (Index v = 0; v < n_vertices; ++v) decimation.mesh.positions[v].z() += way;
    return true;
  };
}

DecimateOptions with_steps() {
  DecimateOptions options;
  options.keep_steps = true;
  return options;
}

TEST(Fit, IsWhatDecimateGivesAndThenWhatTheFitDoes) {
  const IndexedMesh mesh = noisy_torus(24, 12, 1, 0.35, 0.02, 3);
  const DecimateTarget target = DecimateTarget::faces(100);
  const Decimation plain = decimate(mesh, target, with_steps());
  const auto [fitted, is_fitted] = decimate_and_fit(mesh, target, with_steps(), move_up(2, 0.01));
  EXPECT_TRUE(is_fitted);
  EXPECT_EQ(fitted.mesh.faces, plain.mesh.faces);
  std::vector<Vec3> expected = plain.mesh.positions;
  for (Index v = 0; v < 2; ++v) expected[v].z() += 0.01;
  EXPECT_EQ(fitted.mesh.positions, expected);
  const std::vector<PassEnd::MovedVertex>& moved = fitted.steps.pass_ends.back().moved;
  ASSERT_EQ(moved.size(), 2);
  EXPECT_EQ(fitted.vertex_map[moved[0].vertex], 0);
  EXPECT_EQ(moved[1].position, expected[1]);
}

TEST(Fit, GoesAsFarAsTheErrorAllows) {
  const IndexedMesh mesh = grid(30, 30);
  constexpr double limit = 0.05;
  const DecimateTarget target = DecimateTarget::max_error(limit).or_faces(400);
  const Decimation plain = decimate(mesh, target, {});
  ASSERT_GT(plain.mesh.positions.size(), 100);
  const auto fit = [&](Decimation& decimation) {
    for (Vec3& p : decimation.mesh.positions) p.z() += limit / 4;
    decimation.mesh.positions[0].z() += 2 * limit;
    decimation.mesh.positions[50].z() += 100 * limit;
    return true;
  };
  const auto [fitted, is_fitted] = decimate_and_fit(mesh, target, {}, fit);
  EXPECT_TRUE(is_fitted);
  EXPECT_DOUBLE_EQ(fitted.mesh.positions[0].z(), 2.25 * limit / 3);
  EXPECT_EQ(fitted.mesh.positions[50].z(), 0);
  EXPECT_EQ(fitted.mesh.positions.back().z(), limit / 4);
  EXPECT_EQ(metrics::certify(mesh, fitted.mesh, limit).verdict, Verdict::proven);
}

TEST(Fit, TurnsNoFaceOverWhereItGoesPartOfTheWay) {
  const IndexedMesh mesh = grid(30, 30);
  const double step = (mesh.positions[1] - mesh.positions[0]).norm();
  const DecimateTarget target = DecimateTarget::max_error(step / 2).or_faces(400);
  // A push aside as long as several edges: alone the vertices that keep within the limit would go it.
  const auto fit = [&](Decimation& decimation) {
    for (Vec3& p : decimation.mesh.positions) {
      p.x() += 6 * step;
      p.z() += p.y() > 0.5 ? step : 0;
    }
    return true;
  };
  const auto [fitted, is_fitted] = decimate_and_fit(mesh, target, {}, fit);
  for (const Triangle& face : fitted.mesh.faces) {
    EXPECT_GE(area_normal(fitted.mesh.positions, face).z(), 0);
  }
  EXPECT_EQ(metrics::certify(mesh, fitted.mesh, step / 2).verdict, Verdict::proven);
}

TEST(Fit, IsTakenBackWhereTheErrorIsTooLargeOnAnyWay) {
  const IndexedMesh mesh = noisy_sphere(3, 0.01, 5);
  const DecimateTarget target = DecimateTarget::max_error(0.05);
  const Decimation plain = decimate(mesh, target, {});
  const auto push_all = [](Decimation& decimation) {
    for (Vec3& p : decimation.mesh.positions) p *= 2;
    return true;
  };
  const auto [fitted, is_fitted] = decimate_and_fit(mesh, target, {}, push_all);
  EXPECT_FALSE(is_fitted);
  EXPECT_EQ(fitted.mesh.positions, plain.mesh.positions);
  const auto cancel = [](Decimation& decimation) {
    decimation.mesh.positions[0].setZero();
    return false;
  };
  EXPECT_EQ(decimate_and_fit(mesh, target, {}, cancel).decimation.mesh.positions, plain.mesh.positions);
}

TEST(Fit, IsNotMadeOfARunThatIsCancelled) {
  DecimateOptions options;
  options.progress = [](const Progress&) { return false; };
  const auto refuse = [](Decimation&) -> bool { throw std::logic_error("a fit after cancelling"); };
  const FittedDecimation cancelled = decimate_and_fit(sphere(3), DecimateTarget::faces(50), options, refuse);
  EXPECT_EQ(cancelled.decimation.result.stop, StopReason::cancelled);
  EXPECT_FALSE(cancelled.is_fitted);
}

}  // namespace
}  // namespace whittle::test
