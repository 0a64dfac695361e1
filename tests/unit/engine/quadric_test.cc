#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/pair_evaluation.hh"

namespace whittle::test {
namespace {

Vec3 random_vector(Random& random) { return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; }

Eigen::Matrix3d matrix_of(const SymmetricMatrix& m) {
  return (Eigen::Matrix3d() << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz).finished();
}

/// The sum of a few planes through points near the origin, as a quadric about the origin.
Quadric random_quadric(Random& random, int n_planes) {
  Quadric q;
  for (int i = 0; i < n_planes; ++i) {
    const Quadric plane{SymmetricMatrix::outer(random_vector(random).normalized(), random.uniform(0.1, 2)),
                        Vec3::Zero(), 0};
    q += plane.about(random_vector(random));
  }
  return q;
}

/// Garland & Heckbert's 4 × 4 matrix K_p of a plane ax + by + cz + d = 0.
Eigen::Matrix4d plane_matrix(const Vec3& normal, const Vec3& point) {
  const Eigen::Vector4d plane(normal.x(), normal.y(), normal.z(), -normal.dot(point));
  return plane * plane.transpose();
}

PairMinimum<double> minimum_of(const Quadric& q) {
  return pair_minimum(quadric_lanes(PlacedQuadric{Vec3::Zero(), q}), quadric_lanes(PlacedQuadric{Vec3(1, 0, 0), {}}));
}

TEST(PairMinimum, SolvesAsEigenDoes) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    Quadric q = random_quadric(random, 3 + i % 4);
    q.a += SymmetricMatrix::identity(1e-9);
    const PairMinimum<double> minimum = minimum_of(q);
    const Vec3 x(minimum.x, minimum.y, minimum.z);
    // The solve is backward stable: the residual is rounding of |M||x|, however ill-conditioned M is.
    EXPECT_LE((matrix_of(q.a) * x + q.b).norm(), 1e-13 * (1 + matrix_of(q.a).norm() * x.norm())) << "matrix " << i;
    const double largest_term = q.c + matrix_of(q.a).norm() * x.squaredNorm();
    EXPECT_NEAR(minimum.value, std::max(0.0, q(x)), 1e-13 * (1 + largest_term)) << "matrix " << i;
  }
}

TEST(PairMinimum, DoesNotExistAlongFlatDirections) {
  const Vec3 n = Vec3(1, 2, 3).normalized();
  const Vec3 m = Vec3(3, -1, 0.5).normalized();
  const auto exists = [](const SymmetricMatrix& a) { return minimum_of({a, Vec3::Zero(), 0}).is_near; };
  EXPECT_FALSE(exists(SymmetricMatrix{}));
  EXPECT_FALSE(exists(SymmetricMatrix::outer(n, 1)));
  EXPECT_FALSE(exists(SymmetricMatrix::outer(n, 1) + SymmetricMatrix::outer(m, 5)));
  EXPECT_TRUE(exists(SymmetricMatrix::outer(n, 1) + SymmetricMatrix::identity(1e-9)));
}

TEST(Quadric, AboutAnotherOriginIsTheSameFunction) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Quadric q = random_quadric(random, 5);
    const Vec3 t = random_vector(random);
    const Vec3 x = random_vector(random);
    EXPECT_NEAR(q.about(t)(x), q(x + t), 1e-13 * (1 + q(x + t)));
  }
}

/// The cube (±1)³ with uniform weights. Each face at a corner adds the unit plane of one of the corner's three sides.
/// These planes meet at the corner (1, 1, 1)·s.
TEST(CornerQuadric, OfACubesCornerIsTheMatrixByHand) {
  const IndexedMesh mesh = cube();
  const QuadricOptions options{.weights = Weights::uniform, .regularization = 0};
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& corner = mesh.positions[v];
    SymmetricMatrix sum;
    std::array<double, 3> n_sides{};  // triangles of the sides perpendicular to x, y, z here: one or two each
    for (const Triangle& f : mesh.faces) {
      const auto i = std::find(f.begin(), f.end(), v);
      if (i == f.end()) continue;
      const std::array<Vec3, 3> corners{mesh.positions[f[0]], mesh.positions[f[1]], mesh.positions[f[2]]};
      const auto at = static_cast<std::size_t>(i - f.begin());
      sum += corner_quadric(corners[at], corners[(at + 1) % 3], corners[(at + 2) % 3], options);
      for (int axis = 0; axis < 3; ++axis) {
        if (corners[0][axis] == corners[1][axis] && corners[1][axis] == corners[2][axis]) {
          ++n_sides[static_cast<std::size_t>(axis)];
        }
      }
    }
    // About the origin: Σ n_k (x_k − s_k)², that is diag(n), −n_k s_k and Σ n_k.
    const Quadric q = Quadric{sum, Vec3::Zero(), 0}.about(-corner);
    EXPECT_EQ(matrix_of(q.a), Eigen::Matrix3d(Vec3(n_sides[0], n_sides[1], n_sides[2]).asDiagonal())) << "corner " << v;
    EXPECT_EQ(q.b, Vec3(-n_sides[0] * corner.x(), -n_sides[1] * corner.y(), -n_sides[2] * corner.z()));
    EXPECT_EQ(q.c, n_sides[0] + n_sides[1] + n_sides[2]);
  }
}

TEST(CornerQuadric, IsGarlandAndHeckbertsPlaneMatrix) {
  Random random(3);
  const std::array<Vec3, 3> corners{random_vector(random), random_vector(random), random_vector(random)};
  const Vec3 cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double area = 0.5 * cross.norm();
  for (const Weights weights : {Weights::area, Weights::uniform, Weights::area_angle}) {
    double sum_of_weights = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const SymmetricMatrix share = corner_quadric(corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3],
                                                   {.weights = weights, .regularization = 0});
      const double weight = share.trace();  // the trace is the weight, because n is a unit vector
      sum_of_weights += weight;
      const Quadric q = Quadric{share, Vec3::Zero(), 0}.about(-corners[i]);
      const Eigen::Matrix4d expected = weight * plane_matrix(cross.normalized(), corners[0]);
      EXPECT_TRUE(matrix_of(q.a).isApprox(expected.topLeftCorner<3, 3>(), 1e-14));
      EXPECT_TRUE(q.b.isApprox(expected.topRightCorner<3, 1>(), 1e-13));
      EXPECT_NEAR(q.c, expected(3, 3), 1e-14);
    }
    // The angles of a triangle add up to π.
    EXPECT_NEAR(sum_of_weights, weights == Weights::uniform ? 3 : weights == Weights::area ? 3 * area : area, 1e-14);
  }
}

TEST(BorderQuadric, IsThePlaneThroughTheEdgePerpendicularToTheFace) {
  const QuadricOptions options{.regularization = 0, .boundary_weight = 7};
  // The edge lies along x with length 2; the face lies in the plane z = 0.
  const SymmetricMatrix q = border_quadric({0, 0, 0}, {2, 0, 0}, {0.3, 1.7, 0}, options);
  EXPECT_TRUE(matrix_of(q).isApprox(Eigen::Matrix3d(Vec3(0, 7 * 4, 0).asDiagonal()), 1e-15)) << matrix_of(q);
  EXPECT_TRUE(matrix_of(border_quadric({1, 1, 1}, {1, 1, 1}, {2, 0, 0}, options)).isZero());
  EXPECT_TRUE(matrix_of(border_quadric({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, options)).isZero());
}

TEST(EvaluatePair, FindsTheMinimumOfTheSum) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p0 = random_vector(random);
    const Vec3 p1 = p0 + random_vector(random);
    const Quadric q0 = random_quadric(random, 3 + i % 3);
    const Quadric q1 = random_quadric(random, 3 + i % 3);
    const PairEvaluation e = evaluate_pair({p0, q0}, {p1, q1}, Placement::optimal);
    const auto sum = [&](const Vec3& x) { return q0(x - p0) + q1(x - p1); };
    EXPECT_NEAR(sum(e.position), e.cost, 1e-12 * (1 + sum(p0))) << "pair " << i;
    EXPECT_LE(e.bound, e.cost);
    for (int j = 0; j < 20; ++j) EXPECT_GE(sum(e.position + 0.1 * random_vector(random)), e.bound * (1 - 1e-12));
  }
}

TEST(EvaluatePair, CaresNotButForRoundingWhichVertexIsFirst) {
  Random random(5);
  for (const Placement placement : {Placement::optimal, Placement::midpoint, Placement::endpoint}) {
    for (int i = 0; i < 300; ++i) {
      const Vec3 p0 = random_vector(random);
      const Vec3 p1 = random_vector(random);
      const Quadric q0 = random_quadric(random, 1 + i % 4);
      const Quadric q1 = random_quadric(random, 1 + i % 4);
      const PairEvaluation a = evaluate_pair({p0, q0}, {p1, q1}, placement);
      const PairEvaluation b = evaluate_pair({p1, q1}, {p0, q0}, placement);
      const double rounding = 1e-12 * (1 + a.cost);
      EXPECT_NEAR(a.cost, b.cost, rounding);
      EXPECT_NEAR(a.bound, b.bound, rounding);
    }
  }
}

TEST(EvaluatePair, NeverGetsCheaperBoundsByMerging) {
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    std::array<Vec3, 3> p{random_vector(random), random_vector(random), random_vector(random)};
    std::array<Quadric, 3> q{random_quadric(random, 3), random_quadric(random, 4), random_quadric(random, 2)};
    const double before = evaluate_pair({p[0], q[0]}, {p[1], q[1]}, Placement::optimal).bound;
    const PairEvaluation merge = evaluate_pair({p[1], q[1]}, {p[2], q[2]}, Placement::optimal);
    const PlacedQuadric both = merged({p[1], q[1]}, {p[2], q[2]}, merge.position, merge.is_minimum);
    EXPECT_NEAR(both.quadric.c, merge.cost, 1e-12 * (1 + merge.cost));
    EXPECT_GE(evaluate_pair({p[0], q[0]}, both, Placement::optimal).bound, before * (1 - 1e-12));
  }
}

TEST(EvaluatePair, HonoursThePlacement) {
  Random random(7);
  const Vec3 p0(0, 0, 0);
  const Vec3 p1(1, 0, 0);
  const Quadric q0 = random_quadric(random, 4);
  const Quadric q1 = random_quadric(random, 4);
  const auto sum = [&](const Vec3& x) { return q0(x - p0) + q1(x - p1); };
  const PairEvaluation midpoint = evaluate_pair({p0, q0}, {p1, q1}, Placement::midpoint);
  EXPECT_EQ(midpoint.position, Vec3(0.5, 0, 0));
  EXPECT_NEAR(midpoint.cost, sum(midpoint.position), 1e-13);
  const PairEvaluation endpoint = evaluate_pair({p0, q0}, {p1, q1}, Placement::endpoint);
  EXPECT_EQ(endpoint.position, sum(p0) < sum(p1) ? p0 : p1);
  EXPECT_NEAR(endpoint.cost, std::min(sum(p0), sum(p1)), 1e-13);
  EXPECT_EQ(evaluate_pair({p0, q0}, {p1, q1}, Placement::optimal, PairConstraint::first).position, p0);
  EXPECT_EQ(evaluate_pair({p0, q0}, {p1, q1}, Placement::optimal, PairConstraint::second).position, p1);
}

/// All planes are those of a long cone. They meet at its tip, 1000 pair lengths away.
TEST(EvaluatePair, MakesNoSpikeTowardsADistantMinimum) {
  const Vec3 tip(0, 0, 1000);
  Quadric q;
  for (const double angle : {0.0, 0.3, -0.3}) {
    const Vec3 on_side(std::cos(angle), std::sin(angle), 0);
    const Vec3 along = tip - on_side;
    const Vec3 around(-std::sin(angle), std::cos(angle), 0);
    q += Quadric{SymmetricMatrix::outer(along.cross(around).normalized(), 1), Vec3::Zero(), 0}.about(Vec3(1, 0, 0) -
                                                                                                     on_side);
  }
  const PairEvaluation e = evaluate_pair({Vec3(1, 0, 0), q}, {Vec3(1, 0, 1), q}, Placement::optimal);
  EXPECT_LE((e.position - Vec3(1, 0, 0.5)).norm(), max_placement_reach);
  EXPECT_GE(e.cost, e.bound);
}

TEST(Decimate, GivesTheQuadricsOfWhatIsLeftIfAsked) {
  const IndexedMesh mesh = moved(terrain(20, 3), Vec3(30, -7, 900));
  DecimateOptions options;
  EXPECT_TRUE(decimate(mesh, DecimateTarget::faces(200), options).quadrics.empty());
  options.keep_quadrics = true;
  const Decimation all = decimate(mesh, DecimateTarget::faces(mesh.faces.size()), options);
  const Decimation few = decimate(mesh, DecimateTarget::faces(200), options);
  const auto sum_of_traces = [](const Decimation& decimation) {
    double sum = 0;
    for (const PlacedQuadric& vertex : decimation.quadrics) sum += vertex.quadric.a.trace();
    return sum;
  };
  EXPECT_GT(sum_of_traces(all), 0);
  EXPECT_NEAR(sum_of_traces(few), sum_of_traces(all), 1e-12 * sum_of_traces(all)) << "merged vertices add theirs";

  const Frame frame = Frame::of_points(mesh.positions);
  ASSERT_EQ(few.quadrics.size(), few.mesh.positions.size());
  for (std::size_t v = 0; v < few.quadrics.size(); ++v) {
    EXPECT_EQ(frame.to_model(few.quadrics[v].position), few.mesh.positions[v]) << v;
  }
}

}  // namespace
}  // namespace whittle::test
