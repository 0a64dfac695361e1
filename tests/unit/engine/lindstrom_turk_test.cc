#include "whittle/engine/formula/lindstrom_turk.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "oracle/volume_sums.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/topology.hh"
#include "support/transforms.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/volume_placement.hh"

namespace whittle::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Faces and border edges around a pair, in local coordinates.
struct Neighbourhood {
  Vec3 first, second;
  std::vector<std::array<Vec3, 3>> faces;
  std::vector<std::pair<Vec3, Vec3>> border;
  std::vector<Vec3> neighbours;

  /// Sums about the origin.
  VolumeSums volume() const {
    VolumeSums sums;
    for (const auto& [p, q, r] : faces) {
      const Vec3 normal = (q - p).cross(r - p);
      sums += VolumeSums{normal, 0, {SymmetricMatrix::outer(normal, 1)}}.about(-p);
    }
    return sums;
  }
  BorderSums border_sums() const {
    BorderSums sums;
    for (const auto& [p, q] : border) sums.add(p, q);
    return sums;
  }
  PairEvaluation evaluate(PairConstraint constraint = PairConstraint::none) const {
    LindstromTurk term(volume().lanes(), border_sums(), first, second);
    if (!term.is_determined()) {
      NeighbourSums sums;
      for (const Vec3& p : neighbours) sums.add(p);
      term.add_neighbours(sums.lanes());
    }
    return term.evaluate(constraint);
  }

  /// Volumes and areas by their definitions.
  double signed_volume(const Vec3& x) const {
    double sum = 0;
    for (const auto& [p, q, r] : faces) sum += (p - x).dot((q - x).cross(r - x)) / 6;
    return sum;
  }
  double sum_of_squared_volumes(const Vec3& x) const {
    double sum = 0;
    for (const auto& [p, q, r] : faces) sum += std::pow((p - x).dot((q - x).cross(r - x)) / 6, 2);
    return sum;
  }
  Vec3 area(const Vec3& x) const {
    Vec3 sum = Vec3::Zero();
    for (const auto& [p, q] : border) sum += 0.5 * (p - x).cross(q - x);
    return sum;
  }
  double sum_of_squared_areas(const Vec3& x) const {
    double sum = 0;
    for (const auto& [p, q] : border) sum += (0.5 * (p - x).cross(q - x)).squaredNorm();
    return sum;
  }
  double objective(const Vec3& x) const {
    return 0.5 * sum_of_squared_volumes(x) + 0.5 * (second - first).squaredNorm() * sum_of_squared_areas(x);
  }
  /// The regularisation term of the cost.
  double spread(const Vec3& x) const {
    double sum = 0;  // sum of squared areas
    for (const auto& [p, q, r] : faces) sum += (0.5 * (q - p).cross(r - p)).squaredNorm();
    const double mean_distance_sq = 0.5 * ((x - first).squaredNorm() + (x - second).squaredNorm());
    return 0.5 * lindstrom_turk_regularization * sum / 9 * mean_distance_sq;
  }
  double cost(const Vec3& x) const { return objective(x) + spread(x); }

  template <class Transformation>
  Neighbourhood transformed(const Transformation& transform) const {
    Neighbourhood there{transform(first), transform(second), {}, {}, {}};
    for (const auto& [p, q, r] : faces) there.faces.push_back({transform(p), transform(q), transform(r)});
    for (const auto& [p, q] : border) there.border.emplace_back(transform(p), transform(q));
    for (const Vec3& p : neighbours) there.neighbours.push_back(transform(p));
    return there;
  }
};

/// A pair (−½, 0, 0), (½, 0, 0) with its neighbours on a rough ring around it. On a border the neighbours form only a
/// part of a ring. Its ends are on the border with the pair, so the edges from them to the pair and the pair's edge are
/// border edges.
Neighbourhood rough(Random& random, bool on_border, double roughness = 0.3) {
  Neighbourhood result{{-0.5, 0, 0}, {0.5, 0, 0}, {}, {}, {}};
  const auto n = 7 + random.below(4);
  const double end = (on_border ? 180 : 360) * degree;
  const auto n_steps = static_cast<double>(on_border ? n - 1 : n);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = static_cast<double>(i) * end / n_steps;
    const Vec3 bump = roughness * random.uniform_vector(-1, 1);
    result.neighbours.push_back(Vec3(1.5 * std::cos(angle), 1.2 * std::sin(angle), -0.3) + bump);
  }
  // The second vertex has the neighbours up to the top one, and those from the bottom one on.
  const std::size_t top = on_border ? n / 2 : n / 4;
  const std::size_t bottom = on_border ? n - 1 : 3 * n / 4;
  const std::vector<Vec3>& ring = result.neighbours;
  for (std::size_t i = 0; i + 1 < n + (on_border ? 0 : 1); ++i) {
    const bool is_at_first = i >= top && i < bottom;
    result.faces.push_back({is_at_first ? result.first : result.second, ring[i], ring[(i + 1) % n]});
  }
  result.faces.push_back({result.first, result.second, ring[top]});
  if (!on_border) result.faces.push_back({result.second, result.first, ring[bottom]});
  if (on_border) {
    result.border = {{ring.back(), result.first}, {result.first, result.second}, {result.second, ring.front()}};
  }
  return result;
}

template <class Function>
Vec3 gradient(const Function& f, const Vec3& x) {
  constexpr double step = 1e-3;  // central differences have no truncation error for a quadric
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 ahead = x;
    Vec3 behind = x;
    ahead[axis] += step;
    behind[axis] -= step;
    result[axis] = (f(ahead) - f(behind)) / (2 * step);
  }
  return result;
}

void expect_near(const Vec3& found, const Vec3& expected, double tolerance) {
  EXPECT_LE((found - expected).norm(), tolerance) << found.transpose() << ", expected " << expected.transpose();
}

TEST(VolumeSums, AreThoseOfTetrahedra) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Neighbourhood n = rough(random, i % 2 == 0);
    const VolumeSums sums = n.volume();
    const Vec3 x = random.uniform_vector(-2, 2);
    EXPECT_NEAR(sums.squares(x) / 36, n.sum_of_squared_volumes(x), 1e-12);
    EXPECT_NEAR((sums.offset - sums.normal.dot(x)) / 6, n.signed_volume(x), 1e-13);
    const auto squares = [&](const Vec3& y) { return 36 * n.sum_of_squared_volumes(y); };
    expect_near(2 * (sums.squares.a * x + sums.squares.b), gradient(squares, x), 1e-8);
    EXPECT_NEAR(sums.about(x).squares(Vec3::Zero()), sums.squares(x), 1e-11);
    EXPECT_NEAR(sums.about(x).offset, sums.offset - sums.normal.dot(x), 1e-13);
  }
}

TEST(BorderSums, AreThoseOfTriangles) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Neighbourhood n = rough(random, true);
    const BorderSums sums = n.border_sums();
    const Vec3 x = random.uniform_vector(-2, 2);
    EXPECT_EQ(sums.n_edges, 3);
    EXPECT_NEAR(sums.squares(x) / 4, n.sum_of_squared_areas(x), 1e-12);
    const auto squares = [&](const Vec3& y) { return 4 * n.sum_of_squared_areas(y); };
    expect_near(2 * (sums.squares.a * x + sums.squares.b), gradient(squares, x), 1e-9);
    expect_near(0.5 * (sums.area - x.cross(sums.edge)), n.area(x), 1e-14);
  }
}

TEST(LindstromTurk, InsideASurfaceKeepsTheVolumeWithTheLeastSquares) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Neighbourhood n = rough(random, false);
    const PairEvaluation e = n.evaluate();
    EXPECT_NEAR(n.signed_volume(e.position), 0, 1e-13) << i;
    const auto squares = [&](const Vec3& y) { return n.sum_of_squared_volumes(y); };
    const Vec3 normal = n.volume().normal.normalized();
    const Vec3 slope = gradient(squares, e.position);
    expect_near(slope - slope.dot(normal) * normal, Vec3::Zero(), 1e-11);
    EXPECT_NEAR(e.cost, n.cost(e.position), 1e-13) << i;
    EXPECT_EQ(e.bound, e.cost);
  }
}

/// The border runs in random directions, so volume and boundary constraints fix all of v̄. Along a straight border the
/// area would leave one direction free.
TEST(LindstromTurk, OnABorderKeepsTheVolumeAndTheSweptAreaLeast) {
  Random random(4);
  int n_fixed = 0;
  for (int i = 0; i < 400; ++i) {
    Neighbourhood n = rough(random, true);
    n.border.front().first = random.uniform_vector(-2, 2);
    n.border.back().second = random.uniform_vector(-2, 2);
    const PairEvaluation e = n.evaluate();
    EXPECT_NEAR(e.cost, n.cost(e.position), 1e-12 * (1 + e.cost)) << i;
    const Vec3 normal = n.volume().normal.normalized();
    if (std::abs(normal.dot(n.border_sums().edge.normalized())) < 0.3) continue;
    ++n_fixed;
    EXPECT_NEAR(n.signed_volume(e.position), 0, 1e-12) << i;
    const auto swept = [&](const Vec3& y) { return n.area(y).squaredNorm(); };
    const Vec3 slope = gradient(swept, e.position);
    expect_near(slope - slope.dot(normal) * normal, Vec3::Zero(), 1e-9);
  }
  EXPECT_GT(n_fixed, 100);
}

TEST(LindstromTurk, OnAPlaneTheNeighboursPlaceTheVertex) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    Neighbourhood flat = rough(random, false);
    for (auto& face : flat.faces) {
      for (Vec3& p : face) p.z() = 0;
    }
    Vec3 mean = Vec3::Zero();
    for (Vec3& p : flat.neighbours) {
      p.z() = 0;
      mean += p / static_cast<double>(flat.neighbours.size());
    }
    const Eigen::AngleAxisd turn(random.uniform(0, 3), random.uniform_vector(-1, 1).normalized());
    const Neighbourhood n = flat.transformed([&](const Vec3& p) -> Vec3 { return turn * p; });
    const PairEvaluation e = n.evaluate();
    expect_near(e.position, turn * mean, 1e-12);
    EXPECT_NEAR(e.cost, n.spread(e.position), 1e-17);  // rounding of sums of about 1
  }
}

/// The pair lies on the edge y = 0. Both sides of it are flat and meet in a ridge.
Neighbourhood ridge(Random& random) {
  Neighbourhood n = rough(random, false, 0.1);
  while (n.neighbours.size() % 2 == 1) n = rough(random, false, 0.1);  // there must be one at the other end
  return n.transformed([](const Vec3& p) -> Vec3 {
    const double y = std::abs(p.y()) < 0.2 ? 0 : p.y();
    return {p.x(), y, -0.4 * std::abs(y)};
  });
}

TEST(LindstromTurk, OnARidgeTheNeighboursPlaceTheVertexAlongIt) {
  Random random(11);
  for (int i = 0; i < 50; ++i) {
    const Neighbourhood here = ridge(random);
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : here.neighbours) mean += p / static_cast<double>(here.neighbours.size());
    const Eigen::AngleAxisd turn(random.uniform(0, 3), random.uniform_vector(-1, 1).normalized());
    const Neighbourhood n = here.transformed([&](const Vec3& p) -> Vec3 { return turn * p; });
    const PairEvaluation e = n.evaluate();
    expect_near(e.position, turn * Vec3(mean.x(), 0, 0), 1e-12);
    EXPECT_NEAR(e.cost, n.spread(e.position), 1e-15);
  }
}

/// From flat to steep. If it is so shallow that the gradients are almost parallel to the normal, the neighbours'
/// constraints replace them one after the other.
TEST(LindstromTurk, InsideASurfaceFulfilsTheConstraintsInTurn) {
  Random random(12);
  std::array<int, 4> n_by_size{};  // by the number of constraints before the neighbours' ones
  for (int i = 0; i < 1000; ++i) {
    const double height = std::pow(10, random.uniform(-5, 0));
    const Neighbourhood n = rough(random, false).transformed([height](const Vec3& p) -> Vec3 {
      return {p.x(), p.y(), height * p.z()};
    });
    const VolumeSums volume = n.volume();
    PointConstraints constraints;
    constraints.add(volume.normal, volume.offset, 0);
    constraints.add_least(volume.squares);
    ++n_by_size[constraints.size()];
    NeighbourSums sums;
    for (const Vec3& p : n.neighbours) sums.add(p);
    constraints.add_least({SymmetricMatrix::identity(sums.n), -sums.position, 0});
    ASSERT_EQ(constraints.size(), 3U);
    const Vec3 expected = constraints.solve();
    if (expected.norm() > 7) continue;  // the limit is 8
    const PairEvaluation e = n.evaluate();
    expect_near(e.position, expected, 1e-8);
    EXPECT_NEAR(e.cost, n.cost(e.position), 1e-13) << i;
  }
  for (const std::size_t size : {1U, 2U, 3U}) EXPECT_GT(n_by_size[size], 20) << size;
}

TEST(LindstromTurk, DoesNotDependOnPlaceDirectionAndUnit) {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const Neighbourhood here = rough(random, i % 2 == 0);
    const Eigen::AngleAxisd turn(random.uniform(0, 3), random.uniform_vector(-1, 1).normalized());
    const double unit = std::pow(10, random.uniform(-3, 3));
    const Vec3 offset = random.uniform_vector(-2, 2);
    const auto move = [&](const Vec3& p) -> Vec3 { return unit * (turn * p + offset); };
    const Neighbourhood there = here.transformed(move);
    for (const PairConstraint constraint :
         {PairConstraint::none, PairConstraint::first, PairConstraint::second, PairConstraint::either}) {
      const PairEvaluation expected = here.evaluate(constraint);
      const PairEvaluation found = there.evaluate(constraint);
      EXPECT_NEAR(found.cost / std::pow(unit, 6), expected.cost, 1e-11) << i;
      expect_near(found.position / unit, turn * expected.position + offset, 1e-10);
    }
  }
}

TEST(LindstromTurk, PinnedStaysAtTheEndsAllowed) {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const Neighbourhood n = rough(random, i % 2 == 0);
    const double at_first = n.cost(n.first);
    const double at_second = n.cost(n.second);
    EXPECT_EQ(n.evaluate(PairConstraint::first).position, n.first);
    EXPECT_NEAR(n.evaluate(PairConstraint::first).cost, at_first, 1e-14);
    EXPECT_EQ(n.evaluate(PairConstraint::second).position, n.second);
    EXPECT_NEAR(n.evaluate(PairConstraint::second).cost, at_second, 1e-14);
    EXPECT_EQ(n.evaluate(PairConstraint::either).position, at_first < at_second ? n.first : n.second);
  }
}

// Constraints ---------------------------------------------------------------------------------------------------------

/// A unit vector at an angle to x, towards y.
Vec3 turned(double angle_deg) { return {std::cos(angle_deg * degree), std::sin(angle_deg * degree), 0}; }

TEST(PointConstraints, ParallelToOneTakenAreNot) {
  for (const double sign : {1.0, -1.0}) {
    for (const double angle_deg : {0.0, 0.5, 2.0, 90.0}) {
      PointConstraints constraints;
      constraints.add(3 * Vec3::UnitX(), 1, 0);
      constraints.add(5 * sign * turned(angle_deg), 2, 0);
      EXPECT_EQ(constraints.size(), angle_deg > 1 ? 2U : 1U) << angle_deg;
    }
  }
}

TEST(PointConstraints, InThePlaneOfTwoTakenAreNot) {
  for (const double elevation_deg : {0.0, 0.5, 2.0, 90.0}) {
    PointConstraints constraints;
    constraints.add(Vec3::UnitX(), 1, 0);
    constraints.add(turned(10), 2, 0);  // so flat that the cross product is short
    const double elevation = elevation_deg * degree;
    constraints.add(std::cos(elevation) * turned(50) - std::sin(elevation) * Vec3::UnitZ(), 3, 0);
    EXPECT_EQ(constraints.size(), elevation_deg > 1 ? 3U : 2U) << elevation_deg;
  }
}

TEST(PointConstraints, ShorterThanTheNoiseAreNotTaken) {
  PointConstraints constraints;
  constraints.add(1e-12 * Vec3::UnitX(), 1, 1e-11);
  EXPECT_EQ(constraints.size(), 0U);
  constraints.add(Vec3::Zero(), 0, 0);
  EXPECT_EQ(constraints.size(), 0U);
  constraints.add(1e-10 * Vec3::UnitX(), 1, 1e-11);
  EXPECT_EQ(constraints.size(), 1U);
}

TEST(PointConstraints, AreFulfilledByTheSolution) {
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    const Vec3 x = random.uniform_vector(-1, 1);
    PointConstraints constraints;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 row = Vec3::Unit(axis) + 0.3 * random.uniform_vector(-1, 1);
      constraints.add(row, row.dot(x), 0);
    }
    ASSERT_EQ(constraints.size(), 3U);
    expect_near(constraints.solve(), x, 1e-14);
  }
}

TEST(PointConstraints, OfAQuadricGiveItsMinimum) {
  Random random(9);
  for (int i = 0; i < 100; ++i) {
    const Vec3 minimum = random.uniform_vector(-1, 1);
    SymmetricMatrix a = SymmetricMatrix::identity(0.2);
    for (int k = 0; k < 3; ++k) a += SymmetricMatrix::outer(random.uniform_vector(-1, 1), 1);
    PointConstraints constraints;
    constraints.add_least({a, -(a * minimum), 0});
    ASSERT_EQ(constraints.size(), 3U);
    expect_near(constraints.solve(), minimum, 1e-12);
  }
}

// On whole meshes -----------------------------------------------------------------------------------------------------

IndexedMesh decimated(const IndexedMesh& mesh, std::uint64_t n_vertices) {
  DecimateOptions options;
  options.cost = Cost::lindstrom_turk;
  return decimate(mesh, DecimateTarget::vertices(n_vertices), options).mesh;
}

TEST(LindstromTurk, KeepsTheVolumeOfClosedSurfaces) {
  for (const IndexedMesh& mesh : {noisy_sphere(3, 0.05, 1), noisy_torus(24, 12, 1, 0.35, 0.03, 2), blob(3, 3)}) {
    const double volume = signed_volume(mesh);
    for (const std::uint64_t share : {1U, 2U, 4U}) {
      const std::uint64_t target = share == 1 ? mesh.positions.size() - 1 : mesh.positions.size() / share;
      EXPECT_NEAR(signed_volume(decimated(mesh, target)), volume, 1e-12 * volume) << target;
    }
  }
}

/// Σ p × q / 2 over the border edges: the directed area of a planar border.
Vec3 border_area(const IndexedMesh& mesh) {
  Vec3 sum = Vec3::Zero();
  for (const Triangle& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = face[i];
      const Index to = face[(i + 1) % 3];
      const auto has_both = [&](const Triangle& f) {
        return std::ranges::count(f, from) > 0 && std::ranges::count(f, to) > 0;
      };
      if (std::ranges::count_if(mesh.faces, has_both) == 1) {
        sum += 0.5 * mesh.positions[from].cross(mesh.positions[to]);
      }
    }
  }
  return sum;
}

/// Where the surface is rough, the volume constraint comes first, and the area can't be kept as well.
TEST(LindstromTurk, KeepsTheAreaInsideTheBorderOfAPlane) {
  Random random(10);
  IndexedMesh flat = grid(12, 10);
  for (Vec3& p : flat.positions) p += Vec3(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0);
  const IndexedMesh mesh = rotated(flat, 1);
  const Vec3 area = border_area(mesh);
  EXPECT_NEAR(area.norm(), 120, 10);
  for (const std::uint64_t n_vertices : {100U, 60U, 30U}) {
    const IndexedMesh coarse = decimated(mesh, n_vertices);
    EXPECT_EQ(coarse.positions.size(), n_vertices);
    expect_near(border_area(coarse), area, 1e-10);
  }
}

}  // namespace
}  // namespace whittle::test
