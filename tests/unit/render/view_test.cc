#include "whittle/render/view.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "unit/render/render_scenes.hh"

namespace whittle::render {
namespace {

TEST(Views, HaveUnitVectorsAtRightAngles) {
  for (const std::size_t n : {1U, 2U, 24U, 1000U}) {
    const std::vector<View> views = views_around({Vec3(1, 2, 3), 4}, n);
    ASSERT_EQ(views.size(), n);
    for (const View& view : views) {
      EXPECT_NEAR(view.to_eye.norm(), 1, 1e-14);
      EXPECT_NEAR(view.up.norm(), 1, 1e-14);
      EXPECT_NEAR(view.up.dot(view.to_eye), 0, 1e-14);
      EXPECT_GE(view.up.y(), -1e-14);
      EXPECT_EQ(view.sphere.center, Vec3(1, 2, 3));
    }
  }
}

// For n points spread evenly the nearest neighbour is about 3.6/√n away (hexagons); a Fibonacci lattice has at least 3.
TEST(Views, AreSpreadEvenly) {
  for (const std::size_t n : {6U, 24U, 200U}) {
    const std::vector<View> views = views_around({}, n);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < n; ++i) {
      double nearest = 2;
      for (std::size_t j = 0; j < n; ++j) {
        if (i != j) nearest = std::min(nearest, (views[i].to_eye - views[j].to_eye).norm());
      }
      EXPECT_GT(nearest * std::sqrt(static_cast<double>(n)), 2.4) << n << " " << i;
      EXPECT_LT(nearest * std::sqrt(static_cast<double>(n)), 3.9) << n << " " << i;
      sum += views[i].to_eye;
    }
    EXPECT_LT(sum.norm() / static_cast<double>(n), 0.07) << n;
  }
}

TEST(Views, HaveAnUpwardsDirectionAlsoAlongTheAxis) {
  for (const double y : {1.0, -1.0}) {
    EXPECT_EQ(view_from({}, {0, y, 0}).up, Vec3::UnitZ());
    EXPECT_GT(view_from({}, {0.1, y, 0}).up.y(), 0.05);
  }
}

TEST(BoundingSphere, HoldsAllThatIsDrawn) {
  IndexedMesh mesh = square(3);
  mesh.positions.insert(mesh.positions.end(), {{100, 0, 0}, {std::nan(""), 0, 0}});  // of no face, of a broken one
  mesh.faces.push_back({0, 1, 5});
  Eigen::Affine3d place = Eigen::Affine3d::Identity();
  place.translate(Vec3(10, 0, 0)).scale(2);
  const Sphere sphere = bounding_sphere(scene_of(mesh, {}, place));
  EXPECT_EQ(sphere.center, Vec3(10, 0, 6));
  EXPECT_NEAR(sphere.radius, std::sqrt(8), 1e-14);
}

TEST(BoundingSphere, IsOfAllParts) {
  const IndexedMesh mesh = square();
  Scene scene = scene_of(mesh);
  Eigen::Affine3d place = Eigen::Affine3d::Identity();
  place.translate(Vec3(0, 0, 4));
  scene.parts.push_back(scene_of(mesh, {}, place).parts[0]);
  const Sphere sphere = bounding_sphere(scene);
  EXPECT_EQ(sphere.center, Vec3(0, 0, 2));
  EXPECT_NEAR(sphere.radius, std::sqrt(6), 1e-14);
}

TEST(BoundingSphere, HasARadiusAlsoWhereThereIsNothing) { EXPECT_EQ(bounding_sphere({}).radius, 1); }

}  // namespace
}  // namespace whittle::render
