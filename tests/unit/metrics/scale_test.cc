// Meshes as large and as small as coordinates may be are measured like all others.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/line_distance.hh"
#include "whittle/metrics/lines.hh"
#include "whittle/metrics/nearest_vertices.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/shape.hh"

namespace whittle::metrics {
namespace {

class Scale : public testing::TestWithParam<int> {
 protected:
  double factor() const { return std::ldexp(1.0, GetParam()); }
  IndexedMesh scaled(const IndexedMesh& mesh) const { return test::scaled(mesh, factor()); }
};

TEST_P(Scale, OfTheDistanceBetweenSurfaces) {
  const IndexedMesh fine = test::blob(3, 1), coarse = test::blob(2, 1);
  const DistanceOptions options{.samples = 3000};
  const SurfaceDistance expected = surface_distance(fine, coarse, options);
  const SurfaceDistance d = surface_distance(scaled(fine), scaled(coarse), options);
  ASSERT_GT(expected.mean, 0.0);
  EXPECT_EQ(d.mean, expected.mean * factor());
  EXPECT_EQ(d.rms, expected.rms * factor());
  EXPECT_EQ(d.max, expected.max * factor());
  EXPECT_EQ(d.forward.max, expected.forward.max * factor());
  EXPECT_EQ(d.backward.mean, expected.backward.mean * factor());
  EXPECT_EQ(d.diagonal, expected.diagonal * factor());
  EXPECT_EQ(d.normal_deviation_deg, expected.normal_deviation_deg);
  EXPECT_EQ(d.mean_sq, expected.mean_sq * factor() * factor());
  EXPECT_EQ(d.forward.mean_sq, expected.forward.mean_sq * factor() * factor());
  EXPECT_EQ(d.backward.mean_sq, expected.backward.mean_sq * factor() * factor());
  EXPECT_EQ(d.forward.rms, expected.forward.rms * factor());
  EXPECT_EQ(d.garland_heckbert, expected.garland_heckbert * factor() * factor());
}

TEST_P(Scale, OfLines) {
  const IndexedMesh sheet = test::terrain(12, 1), other = test::moved(sheet, Vec3(0.01, 0.02, 0.0));
  const auto expected = line_distance(border_lines(sheet), border_lines(other));
  const auto d = line_distance(border_lines(scaled(sheet)), border_lines(scaled(other)));
  ASSERT_TRUE(expected && d);
  EXPECT_EQ(d->mean, expected->mean * factor());
  EXPECT_EQ(d->backward.max, expected->backward.max * factor());
  const IndexedMesh box = test::tessellated_cube(3);
  const std::vector<Segment> sharp = feature_lines(box, 40), scaled_sharp = feature_lines(scaled(box), 40);
  ASSERT_EQ(scaled_sharp.size(), sharp.size());
  EXPECT_EQ(sharp.size(), 36U);
  for (std::size_t i = 0; i < sharp.size(); ++i) EXPECT_EQ(scaled_sharp[i].from, Vec3(sharp[i].from * factor()));
}

TEST_P(Scale, OfIntersectionsAndNearestVertices) {
  const IndexedMesh ball = test::sphere(2);
  const IndexedMesh two = test::joined(ball, test::moved(ball, Vec3(0.7, 0.1, 0.2)));
  const auto expected = self_intersections(two);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(self_intersections(scaled(two)), expected);
  const IndexedMesh fine = test::sphere(3);
  EXPECT_EQ(nearest_vertices(scaled(fine), scaled(two)), nearest_vertices(fine, two));
}

TEST_P(Scale, OfShape) {
  const IndexedMesh mesh = test::noisy_sphere(3, 0.1, 1);
  const Shape expected = shape(mesh), s = shape(scaled(mesh));
  EXPECT_EQ(s.radius_ratio_mean, expected.radius_ratio_mean);
  EXPECT_EQ(s.min_angle_min_deg, expected.min_angle_min_deg);
  EXPECT_EQ(s.edge_length_mean, expected.edge_length_mean * factor());
  EXPECT_EQ(s.edge_length_cv, expected.edge_length_cv);
  EXPECT_EQ(s.folds, expected.folds);
}

INSTANTIATE_TEST_SUITE_P(PowersOfTwo, Scale, testing::Values(-430, -250, -190, 190, 250, 415, 495));

/// Scaled up to a size of 1, it would lie beyond the range.
TEST(Size, IsTakenWhereTinyAndAwayFromTheOrigin) {
  IndexedMesh sliver;
  sliver.positions = {{0, 1, 0}, {0, 1, 0x1p-510}, {0, 1, 0x1p-511}};
  sliver.faces = {{0, 1, 2}};
  EXPECT_EQ(shape(sliver).degenerate_faces, 1U);
  EXPECT_EQ(surface_distance(sliver, sliver).max, 0.0);
  EXPECT_TRUE(self_intersections(sliver).empty());
  EXPECT_TRUE(feature_lines(sliver, 40).empty());
  EXPECT_EQ(nearest_vertices(sliver, sliver), (std::vector<Index>{0, 1, 2}));
}

/// The power of two that would scale it up to a size of 1 is not a number.
TEST(Size, IsTakenWhereAsTinyAsNumbersGet) {
  const IndexedMesh tiny = test::scaled(test::cube(), 0x1p-1040);
  EXPECT_EQ(shape(tiny).degenerate_faces, 0U);
  EXPECT_EQ(shape(tiny).radius_ratio_mean, shape(test::cube()).radius_ratio_mean);
  EXPECT_EQ(surface_distance(tiny, tiny).max, 0.0);
  EXPECT_TRUE(self_intersections(tiny).empty());
  EXPECT_EQ(feature_lines(tiny, 40).size(), 12U);
  EXPECT_EQ(nearest_vertices(tiny, tiny), (std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(Size, BeyondTheRangeIsRefused) {
  const IndexedMesh ball = test::sphere(1);
  const IndexedMesh huge = test::scaled(ball, 0x1p501);
  EXPECT_THROW(surface_distance(ball, huge), std::invalid_argument);
  EXPECT_THROW(self_intersections(huge), std::invalid_argument);
  EXPECT_THROW(shape(huge), std::invalid_argument);
  EXPECT_THROW(border_lines(huge), std::invalid_argument);
  EXPECT_THROW(nearest_vertices(ball, huge), std::invalid_argument);
  EXPECT_THROW(TriangleTree(test::scaled(ball, 1e71)), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::metrics
