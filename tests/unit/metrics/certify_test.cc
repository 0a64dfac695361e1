// Proofs of the largest distance, compared with a search that knows nothing of patches, frames and trees.
#include "whittle/metrics/certify.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/brute_distance.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/proof/linked_faces.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {

using namespace metrics;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The largest distance of a surface's points from another one, or less by `accuracy`: the most promising piece is
/// halved, until it promises little more than was found.
double brute_largest(const IndexedMesh& from, const IndexedMesh& to, double accuracy) {
  struct Piece {
    double at_most;
    Corners corners;
    bool operator<(const Piece& other) const { return at_most < other.at_most; }
  };
  double found = 0;
  std::priority_queue<Piece> pieces;
  const auto add = [&](const Corners& corners) {
    for (const Vec3& p : corners) found = std::max(found, distance_to_all(to, p));
    double at_most = infinity;
    for (Index f = 0; f < to.faces.size(); ++f) {
      double most = 0;
      for (const Vec3& p : corners) most = std::max(most, distance_to_triangle(corners_of(to, f), p));
      at_most = std::min(at_most, most);
    }
    pieces.push({at_most, corners});
  };
  for (Index f = 0; f < from.faces.size(); ++f) add(corners_of(from, f));
  while (pieces.top().at_most > found + accuracy) {
    const Corners c = pieces.top().corners;
    pieces.pop();
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if ((c[(i + 1) % 3] - c[i]).norm() > (c[(longest + 1) % 3] - c[longest]).norm()) longest = i;
    }
    const Vec3 middle = 0.5 * (c[longest] + c[(longest + 1) % 3]);
    add({c[longest], middle, c[(longest + 2) % 3]});
    add({middle, c[(longest + 1) % 3], c[(longest + 2) % 3]});
  }
  return found;
}

/// \param tolerance of the search that it is compared with, over the size
void expect_right(const IndexedMesh& a, const IndexedMesh& b, double accuracy, double tolerance) {
  const LargestDistances found = largest_distances(a, b, accuracy, {.threads = 1});
  const double size = diagonal_of(a.positions) + diagonal_of(b.positions);
  for (const bool is_forward : {true, false}) {
    const LargestDistance& one_way = is_forward ? found.forward : found.backward;
    const IndexedMesh& from = is_forward ? a : b;
    const IndexedMesh& to = is_forward ? b : a;
    const double expected = brute_largest(from, to, tolerance * size);
    EXPECT_LE(expected, one_way.at_most);
    EXPECT_LE(one_way.at_least, expected + tolerance * size);
    EXPECT_LE(one_way.at_most, (1 + accuracy) * one_way.at_least + 2e-9 * size);
    EXPECT_EQ(one_way.where.is_on_first, is_forward);
    EXPECT_NEAR(distance_to_all(to, one_way.where.point), one_way.at_least, 1e-12 * size);
    EXPECT_LE(distance_to_triangle(corners_of(from, one_way.where.face), one_way.where.point), 1e-12 * size);
  }
  const double least = std::max(found.forward.at_least, found.backward.at_least);
  const double most = std::max(found.forward.at_most, found.backward.at_most);
  EXPECT_EQ(certify(a, b, 1.001 * most + 1e-12 * size, {.threads = 1}).verdict, Verdict::proven);
  if (least > 1e-9 * size) {
    const Certification certification = certify(a, b, 0.99 * least, {.threads = 1});
    ASSERT_EQ(certification.verdict, Verdict::refuted);
    const FarPoint& farther = *certification.farther;
    EXPECT_GT(farther.distance, 0.99 * least);
    EXPECT_NEAR(distance_to_all(farther.is_on_first ? b : a, farther.point), farther.distance, 1e-12 * size);
  }
}

/// Any triangles, folded, crossing, degenerate, with edges of any number of faces.
TEST(Certify, IsRightForRandomFaces) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    const IndexedMesh a = random_faces(1 + random.below(6), random);
    IndexedMesh b = a;
    if (i % 3 == 0) b = random_faces(1 + random.below(6), random);
    for (Vec3& p : b.positions) p += random.uniform(0, 0.2) * random.uniform_vector(-1, 1);
    expect_right(a, b, 0.02, 1e-3);
  }
}

TEST(SlowCertify, IsRightForSimplifiedMeshes) {
  for (const IndexedMesh& mesh : {sphere(2), noisy_torus(16, 10, 1, 0.4, 0.02, 1), bracket(4), terrain(12, 3),
                                  open_cylinder(16, 8), tessellated_cube(5), moebius(24, 3), book(3, 4)}) {
    for (const double share : {0.5, 0.15}) {
      const auto n_faces = static_cast<std::uint64_t>(share * static_cast<double>(mesh.faces.size()));
      const Simplification s = simplify(mesh, DecimateTarget::faces(n_faces), Effort::normal);
      if (!s.mesh.faces.empty()) expect_right(mesh, s.mesh, 0.01, 0.01);
    }
  }
}

/// A slit in a plane: all points of its middle are equally far, so no number of pieces finds the distance exactly.
TEST(Certify, IsLessAccurateWhereItTakesTooManyPieces) {
  constexpr double half_width = 1e-3;
  IndexedMesh whole;
  whole.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  whole.faces = {{0, 1, 2}, {0, 2, 3}};
  IndexedMesh slit = whole;
  for (const double side : {-1, 1}) {
    const double shift = side * half_width * std::hypot(1, 0.05);
    slit.positions.emplace_back(0, 0.37 + shift, 0);
    slit.positions.emplace_back(1, 0.42 + shift, 0);
  }
  slit.faces = {{0, 1, 5}, {0, 5, 4}, {6, 7, 2}, {6, 2, 3}};
  const LargestDistance found = largest_distances(whole, slit, 1e-3).forward;
  EXPECT_NEAR(found.at_least, half_width, 0.02 * half_width);
  EXPECT_GE(found.at_most, half_width);
  EXPECT_LE(found.at_most, 1.1 * half_width);
  const double limit = 1.01 * half_width;
  EXPECT_EQ(certify(whole, slit, limit).verdict, Verdict::undecided) << "else this tests nothing";
  EXPECT_LE(largest_distances(whole, slit, 1e-3, {.limit = 1.2 * half_width}).forward.at_most, 1.2 * half_width);
}

/// A face is missing in a plane: what lies over the hole is not covered, though all around it is.
/// Needles are left where faces are contracted along a line. Rounding must not take the nearest place to another side.
TEST(Certify, MeasuresTheDistanceFromNeedles) {
  for (const double width : {1e-4, 1e-7, 2e-9, 1e-12, 0.0}) {
    const Corners needle{Vec3(1 + width, 0, 1), Vec3(1 + width, 0.425793006, 1), Vec3(1, 0.299808709, 1)};
    for (int i = 0; i <= 1000; ++i) {
      const double height = i % 2 == 0 ? 0 : 0.01;
      const Vec3 point(1, 0.000425793 * i, 1 - height);
      EXPECT_LE(distance_to(needle, point), height + width + 1e-12) << width << ' ' << i;
    }
  }
}

/// Each edge of the common side has four faces, so no patch goes beyond it, and small distances take many pieces there.
TEST(Certify, EndsWhereSurfacesTouch) {
  IndexedMesh right = tessellated_cube(3);
  for (Vec3& p : right.positions) p.x() += 2;
  const IndexedMesh coarse = glued(joined(tessellated_cube(3), right));
  IndexedMesh other = coarse;
  for (Vec3& p : other.positions) p += Vec3(0.3, 0.2, 0.1).cwiseProduct(1e-9 * p);
  std::rotate(other.faces.begin(), other.faces.begin() + 5, other.faces.end());
  for (const IndexedMesh& mesh : {coarse, other}) {
    const LargestDistances largest = largest_distances(coarse, mesh, 1e-3, {.limit = 0.01});
    EXPECT_LE(largest.forward.at_most, 0.01);
    EXPECT_LE(largest.backward.at_most, 0.01);
    EXPECT_LT(largest.forward.at_least, 1e-8);
    EXPECT_LT(largest_distances(coarse, mesh, 1e-3).forward.at_most, 0.01);
  }
}

TEST(Certify, SeesHoles) {
  const IndexedMesh whole = grid(8, 8);
  IndexedMesh pierced = whole;
  pierced.faces.erase(pierced.faces.begin() + 57);
  IndexedMesh large;
  const Box box = bounds_of(whole.positions);
  large.positions = {box.min(), Vec3(box.max().x(), box.min().y(), 0), box.max(),
                     Vec3(box.min().x(), box.max().y(), 0)};
  for (Vec3& p : large.positions) p.z() = whole.positions[0].z();
  large.faces = {{0, 1, 2}, {0, 2, 3}};
  const double size = diagonal_of(box);
  EXPECT_EQ(certify(whole, large, 1e-9 * size).verdict, Verdict::proven);
  EXPECT_EQ(certify(pierced, large, 1e-9 * size).verdict, Verdict::refuted);
  const Corners hole = corners_of(whole, 57);
  const Vec3 ab = hole[1] - hole[0];
  const Vec3 ac = hole[2] - hole[0];
  const double perimeter = ab.norm() + ac.norm() + (ac - ab).norm();
  const double inradius = ab.cross(ac).norm() / perimeter;
  const LargestDistances found = largest_distances(pierced, large, 1e-4);
  EXPECT_NEAR(found.backward.at_least, inradius, 1e-4 * inradius);
  EXPECT_LE(found.forward.at_most, 2e-9 * size);
}

TEST(Certify, CountsFacesThatAreNearlyAsFar) {
  const IndexedMesh low = grid(8, 8);
  IndexedMesh high = low;
  high.positions[40].z() += 1;
  high.positions[44].z() += 0.95;
  high.positions[10].z() += 0.5;
  std::size_t expected = 0;
  for (const Triangle& face : high.faces) {
    expected +=
        static_cast<std::size_t>(std::any_of(face.begin(), face.end(), [](Index v) { return v == 40 || v == 44; }));
  }
  EXPECT_EQ(largest_distances(low, high, 0.01).backward.n_far_faces, expected);
}

TEST(Certify, IsUndecidedWherePointsAreAsFarAsAllowed) {
  const IndexedMesh low = grid(4, 4);
  IndexedMesh high = low;
  for (Vec3& p : high.positions) p.z() += 0.25;
  EXPECT_EQ(certify(low, high, 0.25).verdict, Verdict::undecided);
  EXPECT_EQ(certify(low, high, 0.25 * (1 + 1e-9)).verdict, Verdict::proven);
  EXPECT_EQ(certify(low, high, 0.25 * (1 - 1e-9)).verdict, Verdict::refuted);
  EXPECT_EQ(certify(low, low, 0).verdict, Verdict::undecided);
  EXPECT_EQ(certify(low, low, 1e-9).verdict, Verdict::proven);
  EXPECT_LE(largest_distances(low, low, 0.01).forward.at_most, 1e-8);
}

TEST(Certify, DoesNotDependOnThreadsUnitsAndPlace) {
  const IndexedMesh mesh = noisy_torus(120, 60, 1, 0.4, 0.01, 5);
  const Simplification s = simplify(mesh, DecimateTarget::faces(1000), Effort::normal);
  const LargestDistances expected = largest_distances(mesh, s.mesh, 1e-3, {.threads = 1});
  const double least = std::max(expected.forward.at_least, expected.backward.at_least);
  const Certification refuted = certify(mesh, s.mesh, 0.9 * least, {.threads = 1});
  ASSERT_TRUE(refuted.farther);
  for (const unsigned threads : {2U, 5U}) {
    const LargestDistances found = largest_distances(mesh, s.mesh, 1e-3, {.threads = threads});
    EXPECT_EQ(found.forward.at_least, expected.forward.at_least);
    EXPECT_EQ(found.backward.where.point, expected.backward.where.point);
    const Certification again = certify(mesh, s.mesh, 0.9 * least, {.threads = threads});
    ASSERT_TRUE(again.farther);
    EXPECT_EQ(again.farther->point, refuted.farther->point);
    EXPECT_EQ(again.farther->face, refuted.farther->face);
  }
  for (const double unit : {1e-100, 1e-6, 1e9, 1e100}) {
    IndexedMesh a = mesh;
    IndexedMesh b = s.mesh;
    for (IndexedMesh* moved : {&a, &b}) {
      for (Vec3& p : moved->positions) p *= unit;
    }
    const LargestDistances found = largest_distances(a, b, 1e-3);
    EXPECT_NEAR(found.forward.at_least / unit, expected.forward.at_least, 1e-3 * expected.forward.at_least) << unit;
    EXPECT_EQ(certify(a, b, 1.01 * least * unit).verdict, Verdict::proven) << unit;
  }
}

TEST(Certify, StopsWhenCancelled) {
  const IndexedMesh mesh = noisy_torus(120, 60, 1, 0.4, 0.01, 5);
  const IndexedMesh other = noisy_torus(120, 60, 1, 0.4, 0.01, 6);
  std::vector<std::string> stages;
  const auto tell = [&](const TaskProgress& progress) {
    stages.emplace_back(progress.stage);
    return true;
  };
  EXPECT_GT(largest_distances(mesh, other, 0.01, {.progress = tell}).forward.at_least, 0);
  EXPECT_EQ(stages.front(), "preparing");
  EXPECT_EQ(stages.back(), "measuring, backward");
  for (int last_call = 0; last_call < 3; ++last_call) {
    int n_calls = 0;
    const LargestDistanceOptions options{.progress = [&](const TaskProgress&) { return n_calls++ < last_call; }};
    EXPECT_THROW(largest_distances(mesh, other, 0.01, options), Cancelled) << last_call;
  }
  EXPECT_THROW(certify(mesh, other, 1, {.progress = [](const TaskProgress&) { return false; }}), Cancelled);
}

/// A border is compared with the border, not with the surface that it may lie on.
TEST(Certify, ComparesBorders) {
  const IndexedMesh large = grid(8, 8);
  IndexedMesh small = grid(6, 6);  // of the same squares, so 2 of them are missing on two sides
  const double unit = (large.positions[1] - large.positions[0]).norm();
  ASSERT_NEAR((small.positions[1] - small.positions[0]).norm(), unit, 1e-12);
  const std::optional<LargestDistances> found = largest_border_distances(large, small, 1e-3);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->forward.at_least, std::sqrt(8) * unit, 1e-9);
  EXPECT_NEAR(found->backward.at_least, 2 * unit, 1e-9);
  EXPECT_LE(found->backward.at_most, 2.003 * unit);
  EXPECT_LE(distance_to_triangle(corners_of(small, found->backward.where.face), found->backward.where.point), 1e-12);
  EXPECT_LE(distance_to_triangle(corners_of(large, found->forward.where.face), found->forward.where.point), 1e-12);
  EXPECT_EQ(certify_borders(large, small, 2.9 * unit).verdict, Verdict::proven);
  EXPECT_EQ(certify_borders(large, small, 2.8 * unit).verdict, Verdict::refuted);
  EXPECT_EQ(certify_borders(small, large, 2.8 * unit).verdict, Verdict::refuted);
}

TEST(Certify, FindsLostBordersInfinitelyFar) {
  const IndexedMesh closed = sphere(2);
  IndexedMesh open = closed;
  open.faces.pop_back();
  EXPECT_EQ(certify_borders(closed, closed, 0).verdict, Verdict::proven);
  EXPECT_FALSE(largest_border_distances(closed, closed, 0.1));
  const Certification lost = certify_borders(closed, open, 100);
  ASSERT_EQ(lost.verdict, Verdict::refuted);
  EXPECT_FALSE(lost.farther->is_on_first);
  EXPECT_EQ(lost.farther->distance, infinity);
  EXPECT_EQ(largest_border_distances(open, closed, 0.1)->forward.at_most, infinity);
  EXPECT_EQ(largest_border_distances(open, closed, 0.1)->backward.at_most, 0);
}

/// A map of vertices only says where to begin, even a wrong one.
TEST(Certify, IsTheSameWithAMapOfVertices) {
  const IndexedMesh mesh = noisy_torus(40, 20, 1, 0.4, 0.02, 1);
  const Simplification result = simplify(mesh, DecimateTarget::faces(200));
  const LargestDistances largest = largest_distances(mesh, result.mesh, 1e-3);
  const double distance = std::max(largest.forward.at_most, largest.backward.at_most);
  std::vector<Index> wrong(mesh.positions.size());
  for (std::size_t v = 0; v < wrong.size(); ++v) wrong[v] = static_cast<Index>(v % result.mesh.positions.size());
  std::vector<Index> unknown(mesh.positions.size(), invalid_index);
  for (const std::vector<Index>& map : {result.vertex_map, wrong, unknown}) {
    EXPECT_EQ(certify(mesh, result.mesh, 1.001 * distance, {.vertex_map = map}).verdict, Verdict::proven);
    EXPECT_EQ(certify(mesh, result.mesh, 0.99 * distance, {.vertex_map = map}).verdict, Verdict::refuted);
  }
  unknown[0] = static_cast<Index>(result.mesh.positions.size());
  EXPECT_THROW(certify(mesh, result.mesh, 1, {.vertex_map = unknown}), std::invalid_argument);
  wrong.pop_back();
  EXPECT_THROW(certify(mesh, result.mesh, 1, {.vertex_map = wrong}), std::invalid_argument);
}

TEST(Certify, RefusesWhatHasNoAnswer) {
  const IndexedMesh mesh = cube();
  EXPECT_THROW(certify(mesh, {}, 1), std::invalid_argument);
  EXPECT_THROW(certify({}, mesh, 1), std::invalid_argument);
  EXPECT_THROW(certify(mesh, mesh, -1), std::invalid_argument);
  EXPECT_THROW(certify(mesh, mesh, std::nan("")), std::invalid_argument);
  EXPECT_THROW(largest_distances(mesh, mesh, 1e-9), std::invalid_argument);
  EXPECT_THROW(largest_distances(mesh, mesh, 2), std::invalid_argument);
  IndexedMesh broken = mesh;
  broken.positions[0].x() = infinity;
  EXPECT_THROW(certify(mesh, broken, 1), std::invalid_argument);
  EXPECT_EQ(certify(mesh, mesh, infinity).verdict, Verdict::proven);
}

}  // namespace
}  // namespace whittle::test
