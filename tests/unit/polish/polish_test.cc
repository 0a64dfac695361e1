
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "decimated.hh"
#include "original/closest_point_finder.hh"
#include "original/closest_point_sums.hh"
#include "support/brute_distance.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "surface/ordered_mesh.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/shape.hh"

namespace whittle::test {

using namespace polishing;

namespace {

/// The bounds below hold for these meshes.
Decimation decimated_within_75_deg(const IndexedMesh& mesh, double ratio) {
  return decimated(mesh, ratio, {.max_normal_flip_deg = 75});
}
metrics::SurfaceDistance distance(const IndexedMesh& original, const IndexedMesh& mesh,
                                  std::uint64_t samples = 10'000) {
  return metrics::surface_distance(original, mesh, {.samples = samples});
}

Vec3 normal_of(const IndexedMesh& mesh, const Triangle& face) {
  const Vec3& p = mesh.positions[face[0]];
  return (mesh.positions[face[1]] - p).cross(mesh.positions[face[2]] - p);
}

/// The distance of the nearest of all faces whose normals agree with the given one. Infinite without any.
double distance_to_agreeing(const IndexedMesh& mesh, const Vec3& position, const Vec3& unit_normal) {
  double least = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const double distance = distance_to_triangle(corners_of(mesh, f), position);
    if (!(distance < least)) continue;
    if (normal_of(mesh, mesh.faces[f]).normalized().dot(unit_normal) > 0.5) least = distance;
  }
  return least;
}

Vec3 position_of(const IndexedMesh& mesh, const ClosestFacePoint& closest) {
  const auto& [a, b, c] = mesh.faces[closest.face];
  return (1.0 - closest.second - closest.third) * mesh.positions[a] + double{closest.second} * mesh.positions[b] +
         double{closest.third} * mesh.positions[c];
}

/// The distance of the nearest of the faces at a vertex that contain the closest point and whose normals agree. `slack`
/// widens or narrows the test. Infinite without any.
double distance_at(const IndexedMesh& mesh, Index v, const ClosestPointFinder::Point& point, double slack) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& face : mesh.faces) {
    const auto& [a, b, c] = face;
    if (a != v && b != v && c != v) continue;
    const Vec3 normal = normal_of(mesh, face);
    const double cosine = normal.normalized().dot(point.normal.cast<double>().normalized());
    const Vec3 to = point.position - mesh.positions[a];
    const Vec3 ab = mesh.positions[b] - mesh.positions[a];
    const Vec3 ac = mesh.positions[c] - mesh.positions[a];
    const double second = normal.dot(to.cross(ac)) / normal.squaredNorm();
    const double third = normal.dot(ab.cross(to)) / normal.squaredNorm();
    const double distance = std::abs(normal.normalized().dot(to));
    if (std::min({second, third, 1 - second - third}) > -slack && cosine > 0.5 - slack)
      least = std::min(least, distance);
  }
  return least;
}

ClosestFacePoint find(ClosestPointFinder& finder, Index v, const ClosestPointFinder::Point& point) {
  ClosestFacePoint closest;
  finder.find(v, std::span(&point, 1), std::span(&closest, 1));
  return closest;
}

TEST(ClosestPointFinder, FindsWhatSearchesOfFacesFind) {
  std::size_t n_points = 0;
  std::size_t n_without = 0;
  std::size_t n_farther = 0;
  for (const IndexedMesh& original :
       {noisy_sphere(4, 0.05, 1), noisy_torus(60, 30, 1.0, 0.4, 0.02, 2), tessellated_cube(12), bracket(12)}) {
    const Decimation d = decimated_within_75_deg(original, 0.1);
    const VertexCorners corners = corners_by_vertex(d.mesh.faces, d.mesh.positions.size());
    ClosestPointFinder finder({d.mesh.faces, corners, d.mesh.positions});
    const double size = diagonal_of(original.positions);
    for (const Triangle& face : original.faces) {
      const Vec3 center = (original.positions[face[0]] + original.positions[face[1]] + original.positions[face[2]]) / 3;
      const Vec3 normal = normal_of(original, face);
      const ClosestPointFinder::Point point{center, normal.cast<float>()};
      const Index v = d.vertex_map[face[0]];
      const ClosestFacePoint found = find(finder, v, point);
      ++n_points;
      const double distance =
          found.face == invalid_index ? std::numeric_limits<double>::infinity() : std::abs(found.distance);
      EXPECT_LE(distance, distance_at(d.mesh, v, point, -1e-3) + 1e-6 * size);
      EXPECT_GE(distance, distance_at(d.mesh, v, point, 1e-3) - 1e-6 * size);
      if (found.face == invalid_index) {
        ++n_without;
        continue;
      }
      const Corner& corner = corners.of(v)[found.corner];
      EXPECT_EQ(corner.face, found.face);
      const Vec3 offset = center - position_of(d.mesh, found);
      n_farther += static_cast<std::size_t>(
          offset.norm() > 1.01 * distance_to_agreeing(d.mesh, center, normal.normalized()) + 1e-4 * size);
      const Vec3 found_normal = normal_of(d.mesh, d.mesh.faces[found.face]).normalized();
      EXPECT_NEAR(found.distance, found_normal.dot(center - d.mesh.positions[d.mesh.faces[found.face][0]]),
                  1e-6 * size);
      EXPECT_GE(std::min({found.second, found.third, 1 - found.second - found.third}), -1.1e-4F);
    }
  }
  EXPECT_LE(n_without, n_points / 20) << "of " << n_points;
  EXPECT_LE(n_farther, n_points / 100) << "of " << n_points;
}

TEST(ClosestPointFinder, HasNoneForPointsThatFaceTheOtherWay) {
  const IndexedMesh mesh = grid(4, 4);
  const VertexCorners corners = corners_by_vertex(mesh.faces, mesh.positions.size());
  ClosestPointFinder finder({mesh.faces, corners, mesh.positions});
  const Eigen::Vector3f up = normal_of(mesh, mesh.faces[0]).cast<float>();
  const Vec3 above = mesh.positions[6] + 0.1 * up.cast<double>();
  EXPECT_NE(find(finder, 6, {above, up}).face, invalid_index);
  EXPECT_EQ(find(finder, 6, {above, -up}).face, invalid_index);
  EXPECT_EQ(find(finder, 6, {above, Eigen::Vector3f::Zero()}).face, invalid_index);
}

/// A function that is linear on each face of the original, here its height over a plane, is integrated exactly. If a
/// face has only one point, its square is integrated exactly, too.
TEST(MergedPoints, WeighWhatTheSurfaceHasOfArea) {
  const IndexedMesh original = terrain(12, 3);
  IndexedMesh ground;  // one face below the whole mesh
  ground.positions = {Vec3(-9, -9, -1), Vec3(20, -9, -1), Vec3(-9, 20, -1)};
  ground.faces = {{0, 1, 2}};
  double area = 0;
  double integral = 0;
  double square = 0;
  for (const Triangle& face : original.faces) {
    const double face_area = 0.5 * normal_of(original, face).norm();
    double sum = 0;
    double sum_sq = 0;
    for (const Index v : face) {
      const double height = original.positions[v].z() + 1;
      sum += height;
      sum_sq += height * height;
    }
    area += face_area;
    integral += face_area * sum / 3;
    square += face_area * (sum_sq + sum * sum) / 12;
  }
  const OriginalSurface surface(original, 1);
  const Frame& frame = surface.frame();
  for (Vec3& p : ground.positions) p = frame.to_frame(p);
  const VertexCorners corners = corners_by_vertex(ground.faces, ground.positions.size());
  const std::vector<Index> map(original.positions.size(), 0);
  for (const std::size_t per_face : {std::size_t{1}, std::size_t{4}}) {
    const Origins origins(surface, map, ground.positions.size(), per_face, 1);
    MergedPoints points(origins, {ground.faces, corners, ground.positions}, 3);
    points.find(0);
    double weight = 0;
    double linear = 0;
    double found = 0;
    for (std::size_t i = 0; i < points.closest_points().size(); ++i) {
      const ClosestFacePoint& closest = points.closest_points()[i];
      ASSERT_EQ(closest.face, 0U);
      weight += frame.cost_to_model(points.weights()[i], 2);
      linear += frame.cost_to_model(points.weights()[i] * closest.distance, 3);
      found += frame.cost_to_model(points.weights()[i] * closest.distance * closest.distance, 4);
    }
    EXPECT_NEAR(weight, area, 1e-5 * area);
    EXPECT_NEAR(linear, integral, 1e-5 * integral);
    if (per_face == 1) {
      EXPECT_NEAR(found, square, 1e-5 * square);
    }
  }
}

struct CountAndWeight {
  std::size_t count = 0;
  double weight = 0;

  CountAndWeight& operator+=(const CountAndWeight& other) {
    count += other.count;
    weight += other.weight;
    return *this;
  }
  bool operator==(const CountAndWeight&) const = default;
};

TEST(PointSums, HaveEachClosestPointInItsFace) {
  const IndexedMesh original = permuted(noisy_sphere(5, 0.05, 1), 3).mesh;  // so blocks have many faces in common
  const Decimation d = decimated(original, 0.2);
  const OriginalSurface surface(original, 1);
  std::vector<Vec3> positions;
  for (const Vec3& p : d.mesh.positions) positions.push_back(surface.frame().to_frame(p));
  const VertexCorners corners = corners_by_vertex(d.mesh.faces, positions.size());
  const Surface mesh{d.mesh.faces, corners, positions};
  const Origins origins(surface, d.vertex_map, positions.size(), 1, 1);

  std::vector<CountAndWeight> expected(d.mesh.faces.size());
  const auto add = [](CountAndWeight& sums, const ClosestFacePoint&, double weight) { sums += {1, weight}; };
  MergedPoints points(origins, mesh, static_cast<Index>(positions.size()));
  for (Index v = 0; v < positions.size(); ++v) {
    points.find(v);
    for (std::size_t i = 0; i < points.closest_points().size(); ++i) {
      const ClosestFacePoint& closest = points.closest_points()[i];
      if (closest.face != invalid_index) add(expected[closest.face], closest, points.weights()[i]);
    }
  }
  const auto summed = [&](unsigned threads) {
    std::vector<CountAndWeight> sums(d.mesh.faces.size());
    sum_over_closest_points<CountAndWeight>(
        origins, mesh, add, [&sums](Index f) -> CountAndWeight& { return sums[f]; }, threads);
    return sums;
  };
  const std::vector<CountAndWeight> sums = summed(1);
  for (std::size_t f = 0; f < sums.size(); ++f) {
    EXPECT_EQ(sums[f].count, expected[f].count);
    EXPECT_NEAR(sums[f].weight, expected[f].weight, 1e-12 * expected[f].weight);
  }
  EXPECT_EQ(summed(3), sums);
}

/// Numbers of vertices and faces change inside of polish alone.
TEST(OrderedMesh, IsTheSameMesh) {
  IndexedMesh mesh = permuted(noisy_torus(40, 20, 1, 0.4, 0.01, 3), 5).mesh;
  OrderedMesh ordered(mesh, Frame::of_points(mesh.positions), 1);
  std::vector<Index> all(mesh.positions.size());
  std::iota(all.begin(), all.end(), Index{0});
  const std::vector<Index> numbers = ordered.map(all);
  double length = 0;
  double ordered_length = 0;
  for (Index v = 0; v < numbers.size(); ++v) {
    EXPECT_EQ(ordered.mesh.positions[numbers[v]], mesh.positions[v]);
    if (v == 0) continue;
    length += (mesh.positions[v] - mesh.positions[v - 1]).norm();
    ordered_length += (ordered.mesh.positions[v] - ordered.mesh.positions[v - 1]).norm();
  }
  EXPECT_LT(ordered_length, 0.2 * length);
  const std::vector<Index> with_none{invalid_index, 3};
  EXPECT_EQ(ordered.map(with_none), (std::vector<Index>{invalid_index, numbers[3]}));
  const std::vector<VertexPair> edges{{4, 9}};
  EXPECT_EQ(ordered.map(edges), (std::vector<VertexPair>{{numbers[4], numbers[9]}}));
  std::vector<std::uint8_t> values(mesh.positions.size());
  values[6] = 1;
  EXPECT_EQ(ordered.per_vertex(values)[numbers[6]], 1);
  EXPECT_TRUE(ordered.per_vertex({}).empty());

  std::map<Triangle, Index> regions;
  std::vector<Index> of_faces;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    of_faces.push_back(f % 7);
    regions[{numbers[a], numbers[b], numbers[c]}] = f % 7;
  }
  const std::vector<Index> ordered_regions = ordered.per_face(of_faces);
  for (Index f = 0; f < mesh.faces.size(); ++f) EXPECT_EQ(regions.at(ordered.mesh.faces[f]), ordered_regions[f]);
  IndexedMesh written = mesh;
  for (Vec3& p : written.positions) p = Vec3::Zero();
  for (Triangle& face : written.faces) face = {0, 0, 0};
  ordered.write_to(written);
  EXPECT_EQ(written.positions, mesh.positions);
  EXPECT_EQ(written.faces, mesh.faces);
}

TEST(PolishOriginal, ServesSeveralCalls) {
  const IndexedMesh mesh = noisy_sphere(4, 0.05, 1);
  const PolishOriginal original(mesh, 1);
  for (const double ratio : {0.5, 0.1}) {
    const Decimation d = decimated(mesh, ratio);
    IndexedMesh with_original = d.mesh;
    EXPECT_EQ(polish(original, d.vertex_map, with_original, {.passes = 2}).n_passes, 2U);
    EXPECT_EQ(with_original.positions, polished(mesh, d, {.passes = 2}).positions);
  }
  const Decimation d = decimated(mesh, 0.1);
  IndexedMesh far = d.mesh;
  for (Vec3& p : far.positions) p += Vec3(1e9, 0, 0);
  EXPECT_EQ(polish(original, d.vertex_map, far, {}).n_passes, 0U);
  EXPECT_THROW(PolishOriginal(mesh, 1, [](const TaskProgress&) { return false; }), Cancelled);
  IndexedMesh broken = mesh;
  broken.faces[3][1] = 1'000'000;
  EXPECT_THROW(PolishOriginal{broken}, std::invalid_argument);
}

TEST(SlowPolish, FitsSmoothSurfaces) {
  for (const IndexedMesh& original : {blob(5, 4), noisy_torus(120, 60, 1.0, 0.4, 0.01, 5), knot(200, 24)}) {
    for (const double ratio : {0.5, 0.1, 0.03}) {
      const Decimation d = decimated_within_75_deg(original, ratio);
      const auto before = distance(original, d.mesh);
      const auto after = distance(original, polished(original, d));
      EXPECT_LT(after.mean, 0.98 * before.mean) << ratio;
      EXPECT_LT(after.rms, 0.98 * before.rms) << ratio;
      const auto again = distance(original, polished(original, d, {.passes = 3}));
      EXPECT_LT(again.rms, 1.01 * after.rms) << ratio;
    }
  }
}

TEST(Polish, LeavesCornersAndFlatSidesWhereTheyAre) {
  for (const IndexedMesh& original : {tessellated_cube(16), bracket(24), bracket(40)}) {
    const double size = diagonal_of(original.positions);
    const Decimation d = decimated_within_75_deg(original, 0.1);
    EXPECT_LT(distance(original, polished(original, d, {.passes = 3})).max,
              distance(original, d.mesh).max + 1e-6 * size);
  }
}

TEST(Polish, DoesNoHarm) {
  for (const auto& [name, original] : all_meshes()) {
    for (const double ratio : {0.6, 0.2}) {
      SCOPED_TRACE(name + " to " + std::to_string(ratio));
      const Decimation d = decimated_within_75_deg(original, ratio);
      if (d.mesh.faces.empty()) continue;
      const IndexedMesh after = polished(original, d);
      EXPECT_EQ(after.faces, d.mesh.faces);
      const double size = diagonal_of(original.positions);
      const auto is_as_near = [&, &whole = original](std::uint64_t samples) {
        return distance(whole, after, samples).rms <= 1.02 * distance(whole, d.mesh, samples).rms + 1e-6 * size;
      };
      EXPECT_TRUE(is_as_near(10'000) || is_as_near(100'000)) << "on boxes a few points have most of the sum";
      for (const Triangle& face : d.mesh.faces) {
        const Vec3 was = normal_of(d.mesh, face);
        EXPECT_GE(normal_of(after, face).dot(was), was.norm() > 1e-9 * size * size ? 0 : -1);
      }
      EXPECT_LE(metrics::shape(after).folds, metrics::shape(d.mesh).folds);
    }
  }
}

TEST(Polish, LeavesAMeshThatIsTheOriginal) {
  for (const auto& [name, upright] : all_meshes()) {
    SCOPED_TRACE(name);
    const IndexedMesh original = rotated(soup(upright), 3);
    std::vector<Index> vertex_map(original.positions.size());
    std::iota(vertex_map.begin(), vertex_map.end(), Index{0});
    IndexedMesh mesh = original;
    const PolishResult result = polish(original, vertex_map, mesh, {.passes = 3});
    EXPECT_EQ(result.n_passes, 0U);
    EXPECT_EQ(mesh.positions, original.positions);
    EXPECT_EQ(mesh.faces, original.faces);
  }
}

TEST(Polish, KeepsLockedAndBorderVerticesToTheBit) {
  const IndexedMesh original = terrain(40, 7);
  const Decimation d = decimated_within_75_deg(original, 0.1);
  std::vector<std::uint8_t> locked(d.mesh.positions.size());
  for (std::size_t v = 0; v < locked.size(); v += 3) locked[v] = 1;
  const IndexedMesh after = polished(original, d, {.locked = locked, .fit_borders = false});
  std::size_t n_moved = 0;
  std::size_t n_border = 0;
  for (std::size_t v = 0; v < locked.size(); ++v) {
    const Vec3& p = d.mesh.positions[v];
    const bool is_on_border = std::min(p.x(), p.y()) < 1e-9;
    n_border += static_cast<std::size_t>(is_on_border);
    if (locked[v] != 0 || is_on_border) {
      EXPECT_EQ(after.positions[v], p);
    } else {
      n_moved += static_cast<std::size_t>(after.positions[v] != p);
    }
  }
  EXPECT_GT(n_border, 5U);
  EXPECT_GT(n_moved, locked.size() / 3);
}

TEST(Polish, GivesTheSameForAnyThreadsUnitAndPlace) {
  const IndexedMesh original = noisy_sphere(5, 0.05, 8);
  const Decimation d = decimated_within_75_deg(original, 0.1);
  const IndexedMesh one = polished(original, d, {.passes = 2, .threads = 1});
  for (const unsigned threads : {2U, 3U, 8U}) {
    EXPECT_EQ(polished(original, d, {.passes = 2, .threads = threads}).positions, one.positions);
  }
  Decimation large = d;
  large.mesh = scaled(d.mesh, 1024);
  const IndexedMesh scaled_up = polished(scaled(original, 1024), large, {.passes = 2});
  for (std::size_t v = 0; v < one.positions.size(); ++v) EXPECT_EQ(scaled_up.positions[v], 1024 * one.positions[v]);
}

TEST(Polish, TakesAMeshOfAnotherSize) {
  const IndexedMesh original = blob(2, 1);
  const Decimation d = decimated_within_75_deg(original, 0.5);
  for (const double factor : {1e-120, 1e-40, 1e40, 1e120}) {
    IndexedMesh mesh = scaled(d.mesh, factor);
    const PolishResult result = polish(original, d.vertex_map, mesh, {.passes = 2, .flips = true});
    EXPECT_TRUE(std::isfinite(result.rms_after)) << factor;
    for (const Vec3& p : mesh.positions) ASSERT_TRUE(p.allFinite()) << factor;
  }
}

TEST(Polish, ComputesNormalsAnew) {
  IndexedMesh original = blob(4, 9);
  original.normals.assign(original.positions.size(), {0, 0, 1});
  const Decimation d = decimated_within_75_deg(original, 0.1);
  const IndexedMesh after = polished(original, d);
  ASSERT_EQ(after.normals.size(), after.positions.size());
  EXPECT_NE(after.normals, d.mesh.normals);
  EXPECT_EQ(polished(original, d, {.recompute_normals = false}).normals, d.mesh.normals);
  EXPECT_GT(polished(original, d, {.crease_angle_deg = 1}).normals.size(), after.normals.size()) << "they break";
  EXPECT_THROW(polished(original, d, {.crease_angle_deg = 0}), std::invalid_argument);
}

TEST(Polish, SaysWhatIsWrong) {
  const IndexedMesh original = blob(2, 1);
  const Decimation d = decimated_within_75_deg(original, 0.5);
  IndexedMesh mesh = d.mesh;
  std::vector<Index> map = d.vertex_map;
  map[3] = static_cast<Index>(mesh.positions.size());
  EXPECT_THROW(polish(original, map, mesh), std::invalid_argument);
  map.pop_back();
  EXPECT_THROW(polish(original, map, mesh), std::invalid_argument);
  const std::vector<std::uint8_t> locked(1);
  EXPECT_THROW(polish(original, d.vertex_map, mesh, {.locked = locked}), std::invalid_argument);
  EXPECT_THROW(polish(original, d.vertex_map, mesh, {.min_radius_ratio = 1.1}), std::invalid_argument);
  EXPECT_EQ(polish(original, d.vertex_map, mesh, {.passes = 0}).n_moved, 0U);
  EXPECT_EQ(mesh.positions, d.mesh.positions);
  EXPECT_EQ(polish({}, {}, mesh).n_moved, 0U) << "nothing to fit it to";
  EXPECT_EQ(mesh.positions, d.mesh.positions);
}

}  // namespace
}  // namespace whittle::test
