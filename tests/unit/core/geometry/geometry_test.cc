#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/nearest_on_triangle.hh"
#include "whittle/core/geometry/overlapping_boxes.hh"
#include "whittle/core/geometry/segment.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/geometry/triangle_intersection.hh"

namespace whittle::test {
namespace {

TEST(Box, IsAroundItsPoints) {
  const std::vector<Vec3> points{{1, 2, 3}, {-1, 5, 3}, {0, 3, 7}};
  const Box box = bounds_of(points);
  EXPECT_EQ(box.min(), Vec3(-1, 2, 3));
  EXPECT_EQ(box.max(), Vec3(1, 5, 7));
  EXPECT_EQ(center_of(box), Vec3(0, 3.5, 5));
  EXPECT_DOUBLE_EQ(diagonal_of(points), std::sqrt(4 + 9 + 16));
  EXPECT_EQ(diagonal_of(Box()), 0);
  EXPECT_EQ(bounds_of(std::vector<Vec3>{}).max(), Vec3::Zero());
}

TEST(Triangle, HasHalfTheAreaOfItsNormal) {
  const std::vector<Vec3> positions{{0, 0, 1}, {2, 0, 1}, {0, 3, 1}};
  EXPECT_EQ(area_normal(positions, {0, 1, 2}), Vec3(0, 0, 6));
  EXPECT_EQ(area_normal(positions, {0, 2, 1}), Vec3(0, 0, -6));
  EXPECT_EQ(area_of(positions, {0, 2, 1}), 3);
  EXPECT_EQ(point_at(corners_of(positions, {0, 1, 2}), {0.5, 0.25}), Vec3(1, 0.75, 1));
}

TEST(Segment, HasItsNearestPointInsideOrAtAnEnd) {
  const Vec3 from(1, 0, 0), to(3, 0, 0);
  EXPECT_EQ(nearest_share(Vec3(0, 4, 0), from, to), 0);
  EXPECT_EQ(nearest_share(Vec3(2.5, 4, 0), from, to), 0.75);
  EXPECT_EQ(nearest_share(Vec3(9, 4, 0), from, to), 1);
  EXPECT_EQ(nearest_share(Vec3(9, 4, 0), from, from), 0);
  EXPECT_EQ(nearest_on_segment(Vec3(2.5, 4, 0), from, to), Vec3(2.5, 0, 0));
  EXPECT_EQ(distance_sq_to_segment(Vec3(2.5, 4, 0), from, to), 16);
  EXPECT_EQ(distance_sq_to_segment(Vec3(1, 1, 0), from, from), 1);
}

TEST(Intersections, AreNewWhereThereWasNone) {
  const Corners floor{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const Corners above{Vec3(1, 1, 1), Vec3(2, 1, 1), Vec3(1, 1, 2)};
  const Corners through{Vec3(1, 1, -1), Vec3(2, 1, 1), Vec3(1, 1, 2)};
  EXPECT_TRUE(detail::intersect_newly({floor, above}, {floor, through}));
  EXPECT_FALSE(detail::intersect_newly({floor, through}, {floor, through}));
  EXPECT_FALSE(detail::intersect_newly({floor, through}, {floor, above}));
  const Corners line{Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(1, 1, 2)};
  EXPECT_FALSE(detail::intersect(floor, line)) << "a triangle without area intersects nothing";
}

TEST(OverlappingBoxes, AreWhatComparingAllFinds) {
  Random random(1);
  for (const std::size_t n : {0U, 1U, 2U, 8U, 9U, 65U, 700U}) {
    for (const double size : {0.001, 0.1, 3.0}) {
      std::vector<FloatBox> boxes(n);
      std::vector<Triangle> faces(n);
      for (std::size_t i = 0; i < n; ++i) {
        boxes[i].extend(random.uniform_vector(-1, 1).cast<float>());
        boxes[i].extend(boxes[i].min() + random.uniform_vector(0, size).cast<float>());
        for (Index& corner : faces[i]) corner = static_cast<Index>(random.uniform(0, 30));
      }
      IndexPairs expected;
      IndexPairs expected_apart;
      for (Index i = 0; i < n; ++i) {
        for (Index j = i + 1; j < n; ++j) {
          if (!boxes[i].intersects(boxes[j])) continue;
          expected.push_back({i, j});
          if (std::find_first_of(faces[i].begin(), faces[i].end(), faces[j].begin(), faces[j].end()) == faces[i].end())
            expected_apart.push_back({i, j});
        }
      }
      const auto check = [&boxes](const auto& keep, const IndexPairs& pairs) {
        IndexPairs found = overlapping_boxes(boxes, keep, 1);
        EXPECT_EQ(overlapping_boxes(boxes, keep, 3), found);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, pairs);
      };
      check([](Index, Index) { return true; }, expected);
      check([&](Index i, Index j) { return n_common_corners(faces[i], faces[j]) == 0; }, expected_apart);
    }
  }
}

}  // namespace
}  // namespace whittle::test
