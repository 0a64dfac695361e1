// What error guards and proofs are made of, each against a slow definition.
#include "error/error_bound.hh"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "error/near_test.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::test {
namespace {

class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : random_(seed) {}
  Vec3 operator()() { return {uniform_(random_), uniform_(random_), uniform_(random_)}; }
  double number() { return uniform_(random_); }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

/// Also thin ones, segments and points.
Corners random_corners(RandomPoints& random, int kind) {
  const Vec3 a = random();
  const Vec3 b = kind == 3 ? a : random();
  if (kind == 0) return {a, b, random()};
  if (kind == 1) return {a, b, 0.3 * a + 0.7 * b + 1e-9 * random()};
  return {a, b, b};
}

TEST(NearTest, AgreesWithTheDistance) {
  RandomPoints random(1);
  for (int i = 0; i < 20'000; ++i) {
    const Corners corners = random_corners(random, i % 4);
    const Vec3 point = random();
    const double distance = distance_to(corners, point);
    for (const NearTest& test : {NearTest(corners), NearTest::of_corners(corners)}) {
      EXPECT_TRUE(test.is_within(point, distance * (1 + 1e-9) + 1e-14));
      EXPECT_FALSE(test.is_within(point, distance * (1 - 1e-9) - 1e-14));
    }
  }
}

TEST(NearTest, FindsWhereASegmentLeavesAFace) {
  RandomPoints random(2);
  for (int i = 0; i < 2'000; ++i) {
    const Corners corners = random_corners(random, 0);
    const auto& [a, b, c] = corners;
    const Vec3 normal = area_normal(corners).normalized();
    const Vec3 inside = (a + b + c) / 3 + random.number() * normal;
    const Vec3 outside = inside + 4 * random();
    const Vec3 last = NearTest(corners).last_over(inside, outside);
    // Over a face the distance is that from its plane.
    EXPECT_NEAR(distance_to(corners, last), std::abs(normal.dot(last - a)), 1e-9);
    const Vec3 beyond = last + 1e-3 * (outside - inside);
    if ((outside - last).norm() > 2e-3 * (outside - inside).norm()) {
      EXPECT_GT(distance_to(corners, beyond), std::abs(normal.dot(beyond - a)));
    }
    EXPECT_EQ(NearTest(corners).last_over(outside, outside), outside);
  }
}

/// A check of what has changed finds what a check of all does.
TEST(ErrorBound, IsCheckedAgainWhereVerticesHaveMoved) {
  for (const IndexedMesh& mesh : {noisy_torus(40, 20, 1, 0.4, 0.02, 1), terrain(24, 3), bracket(8)}) {
    const Frame frame = Frame::of_points(mesh.positions);
    const double limit = 0.02 * diagonal_of(mesh.positions);
    const Decimation small = decimate(mesh, DecimateTarget::max_error(0.9 * limit));
    ErrorBound kept(mesh, frame, limit * frame.scale, 2);
    IndexedMesh moved = small.mesh;
    ASSERT_TRUE(kept.check({moved, frame, small.vertex_map}, kept.limit()).empty());
    RandomPoints random(3);
    int n_kept = 0;
    for (int round = 0; round < 60; ++round) {
      std::vector<std::uint8_t> is_changed(moved.positions.size());
      for (int i = 0; i < 1 + round % 3; ++i) {
        const auto v = static_cast<std::size_t>((random.number() + 1) / 2 * static_cast<double>(is_changed.size() - 1));
        const bool is_taken_back = random.number() < 0;
        moved.positions[v] = is_taken_back ? small.mesh.positions[v] : Vec3(moved.positions[v] + 2 * limit * random());
        is_changed[v] = 1;
      }
      if (round % 10 == 9) {
        moved.positions = small.mesh.positions;
        is_changed.assign(is_changed.size(), 1);
      }
      const CheckedSurface surface{moved, frame, small.vertex_map};
      const ErrorBound::Violations again = kept.check_again(surface, is_changed);
      ErrorBound fresh(mesh, frame, limit * frame.scale, 1);
      const ErrorBound::Violations all = fresh.check(surface, fresh.limit());
      EXPECT_EQ(again.is_surface_far, all.is_surface_far);
      EXPECT_EQ(again.points.empty(), all.points.empty());
      n_kept += all.empty() ? 1 : 0;
    }
    EXPECT_GE(n_kept, 6);
    EXPECT_LT(n_kept, 60);
  }
}

}  // namespace
}  // namespace whittle::test
