#include <gtest/gtest.h>

#include "support/random.hh"
#include "whittle/core/geometry/radius_ratio.hh"
#include "whittle/engine/formula/edge_length_term.hh"
#include "whittle/engine/formula/valence_term.hh"

// What costs and guards give for a single pair or a single triangle.

namespace whittle::test {
namespace {

PlacedQuadric random_vertex(Random& random) {
  PlacedQuadric vertex{random.uniform_vector(-1, 1), {}};
  for (int i = 0; i < 4; ++i) vertex.quadric.a += SymmetricMatrix::outer(random.uniform_vector(-1, 1), 1);
  return vertex;
}

/// A cost in another unit: areas times squared distances, like area-weighted quadrics.
PlacedQuadric in_unit(const PlacedQuadric& vertex, double unit) {
  const auto& [a, b, c] = vertex.quadric;
  const double area = unit * unit;
  return {unit * vertex.position,
          {{area * a.xx, area * a.xy, area * a.xz, area * a.yy, area * a.yz, area * a.zz},
           area * unit * b,
           area * area * c}};
}

// Edge length ---------------------------------------------------------------------------------------------------------

TEST(Midpoint, CostsTheLength) {
  const Vec3 first(1, 2, 3);
  const Vec3 second(1, 5, 7);
  for (const PairConstraint constraint :
       {PairConstraint::none, PairConstraint::first, PairConstraint::second, PairConstraint::either}) {
    EXPECT_EQ(evaluate_midpoint(first, second, constraint).cost, 5);
    EXPECT_EQ(evaluate_midpoint(first, second, constraint).bound, 5);
  }
  EXPECT_EQ(evaluate_midpoint(first, second, PairConstraint::none).position, Vec3(1, 3.5, 5));
  EXPECT_EQ(evaluate_midpoint(first, second, PairConstraint::first).position, first);
  EXPECT_EQ(evaluate_midpoint(first, second, PairConstraint::either).position, first);
  EXPECT_EQ(evaluate_midpoint(first, second, PairConstraint::second).position, second);
}

TEST(Isotropic, AtZeroIsTheQuadric) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const PlacedQuadric v0 = random_vertex(random);
    const PlacedQuadric v1 = random_vertex(random);
    for (const PairConstraint constraint :
         {PairConstraint::none, PairConstraint::first, PairConstraint::second, PairConstraint::either}) {
      const PairEvaluation expected = evaluate_pair(v0, v1, Placement::optimal, constraint);
      const PairEvaluation found = evaluate_isotropic(v0, v1, 0, Placement::optimal, constraint);
      EXPECT_EQ(found.position, expected.position);
      EXPECT_NEAR(found.cost, expected.cost, 1e-13 * (1 + expected.cost));
    }
  }
}

TEST(Isotropic, AtOneIsTheLengthToTheMiddle) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const PlacedQuadric v0 = random_vertex(random);
    const PlacedQuadric v1 = random_vertex(random);
    const PairEvaluation e = evaluate_isotropic(v0, v1, 1, Placement::optimal, PairConstraint::none);
    EXPECT_EQ(e.position, 0.5 * (v0.position + v1.position));
    EXPECT_DOUBLE_EQ(e.cost, (v1.position - v0.position).squaredNorm());
    EXPECT_EQ(evaluate_isotropic(v0, v1, 1, Placement::optimal, PairConstraint::second).position, v1.position);
  }
}

TEST(Isotropic, AtOneGoesToTheBetterEndIfToEither) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const PlacedQuadric v0 = random_vertex(random);
    const PlacedQuadric v1 = random_vertex(random);
    const Vec3 found = evaluate_isotropic(v0, v1, 1, Placement::endpoint, PairConstraint::none).position;
    EXPECT_EQ(found, evaluate_pair(v0, v1, Placement::endpoint).position);
    EXPECT_TRUE(found == v0.position || found == v1.position);
  }
}

TEST(Isotropic, BetweenIsAsItsFormulasSay) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const PlacedQuadric v0 = random_vertex(random);
    const PlacedQuadric v1 = random_vertex(random);
    const double w = random.uniform(0.05, 0.95);
    const PairEvaluation e = evaluate_isotropic(v0, v1, w, Placement::optimal, PairConstraint::none);
    const auto error = [&](const Vec3& x) { return v0.quadric(x - v0.position) + v1.quadric(x - v1.position); };
    const double length_sq = (v1.position - v0.position).squaredNorm();
    EXPECT_NEAR(e.cost, std::pow(error(e.position), 1 - w) * std::pow(length_sq, w), 1e-12);
    const double mu = w / (1 - w) / 1000 * (v0.quadric.a.trace() + v1.quadric.a.trace());
    const Vec3 to0 = e.position - v0.position;
    const Vec3 to1 = e.position - v1.position;
    const Vec3 half_slope = v0.quadric.a * to0 + v1.quadric.a * to1 + mu * (to0 + to1);
    EXPECT_LE(half_slope.norm(), 1e-12 * (1 + mu));
  }
}

TEST(Isotropic, HasTheUnitItSays) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const PlacedQuadric v0 = random_vertex(random);
    const PlacedQuadric v1 = random_vertex(random);
    const double unit = std::pow(10, random.uniform(-3, 3));
    for (const double w : {0.0, 0.3, 0.7, 1.0}) {
      const PairEvaluation here = evaluate_isotropic(v0, v1, w, Placement::optimal, PairConstraint::none);
      const PairEvaluation there =
          evaluate_isotropic(in_unit(v0, unit), in_unit(v1, unit), w, Placement::optimal, PairConstraint::none);
      EXPECT_LE((there.position / unit - here.position).norm(), 1e-10);
      EXPECT_NEAR(there.cost / std::pow(unit, isotropic_dimension(4, w)), here.cost, 1e-10 * here.cost);
    }
  }
}

// Valences ------------------------------------------------------------------------------------------------------------

/// The valences of an inner edge's ends and wings, before and after.
ValenceChange inner_edge(int a, int b, int wing, int other_wing) {
  ValenceChange change;
  for (const int valence : {a, b, wing, other_wing}) change.add_before(valence, false);
  for (const int valence : {a + b - 4, wing - 1, other_wing - 1}) change.add_after(valence, false);
  return change;
}

TEST(ValenceChange, FiveToSevenAreAsGoodAsSix) {
  EXPECT_EQ(inner_edge(5, 5, 6, 7).penalize(3, 10), 3);
  EXPECT_EQ(inner_edge(6, 5, 6, 7).penalize(3, 10), 3);
}

TEST(ValenceChange, CostsWhatIrregularityItAdds) {
  EXPECT_EQ(inner_edge(6, 6, 6, 6).penalize(3, 0.5), 3 * 1.5);  // merged vertex of 8 edges: irregular by 1
  EXPECT_EQ(inner_edge(7, 7, 6, 6).penalize(3, 0.5), 3 * 2.5);  // 10 edges: irregular by 3
  EXPECT_EQ(inner_edge(6, 6, 5, 5).penalize(3, 0.5), 3 * 2.5);  // 8 edges, and two wings of 4
}

TEST(ValenceChange, IsPaidForWhatIrregularityItTakesAway) {
  EXPECT_EQ(inner_edge(5, 5, 8, 6).penalize(3, 0.5), 3 / 1.5);
  EXPECT_EQ(inner_edge(4, 5, 8, 9).penalize(3, 0.5), 3 / 2.5);  // irregular by 1 + 0 + 1 + 2; then 5, 7 and 8
}

TEST(ValenceChange, OfNoWeightChangesNothing) { EXPECT_EQ(inner_edge(9, 9, 6, 6).penalize(3, 0), 3); }

TEST(ValenceChange, OnABorderFourIsRegular) {
  ValenceChange change;
  for (const int valence : {3, 4, 5}) change.add_before(valence, true);
  EXPECT_EQ(change.penalize(3, 1), 3);
  change.add_after(6, true);  // irregular by 1
  EXPECT_EQ(change.penalize(3, 1), 6);
  change.add_before(1, true);  // irregular by 2
  EXPECT_EQ(change.penalize(3, 1), 1.5);
}

TEST(ValenceChange, ToThreeEdgesInsideComesLast) {
  const ValenceChange change = inner_edge(6, 6, 4, 6);
  EXPECT_LT(inner_edge(6, 6, 5, 6).penalize(3, 0.5), 3 * 10);
  EXPECT_GT(change.penalize(0, 0.5), inner_edge(6, 6, 6, 6).penalize(1, 100));
  EXPECT_LT(change.penalize(0.1, 0.5), change.penalize(0.2, 0.5));
  ValenceChange on_border;
  on_border.add_after(3, true);
  EXPECT_EQ(on_border.penalize(3, 0.5), 3);
}

// Shape ---------------------------------------------------------------------------------------------------------------

TEST(RadiusRatio, OfAnEquilateralTriangleIsOne) {
  EXPECT_NEAR(radius_ratio(Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)), 1, 1e-15);
  EXPECT_NEAR(radius_ratio(Vec3(1e-9, 0, 0), Vec3(0, 1e-9, 0), Vec3(0, 0, 1e-9)), 1, 1e-15);
}

TEST(RadiusRatio, OfARightTriangleIsThatByHand) {
  // Edges 3, 4, 5: the inscribed circle has the radius 1, the circumscribed one 5/2.
  EXPECT_NEAR(radius_ratio(Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 4, 0)), 0.8, 1e-15);
  EXPECT_NEAR(radius_ratio(Vec3(0, 4, 0), Vec3(0, 0, 0), Vec3(3, 0, 0)), 0.8, 1e-15);
  EXPECT_NEAR(radius_ratio(Vec3(0, 4, 0), Vec3(3, 0, 0), Vec3(0, 0, 0)), 0.8, 1e-15);
}

TEST(RadiusRatio, WithoutAreaIsZero) {
  EXPECT_EQ(radius_ratio(Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, 3)), 0);
  EXPECT_EQ(radius_ratio(Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 2, 3)), 0);
  EXPECT_EQ(radius_ratio(Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)), 0);
}

TEST(RadiusRatio, IsTwiceTheInnerOverTheOuterRadius) {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Vec3 a = random.uniform_vector(-1, 1);
    const Vec3 b = random.uniform_vector(-1, 1);
    const Vec3 c = random.uniform_vector(-1, 1);
    const double area = 0.5 * (b - a).cross(c - a).norm();
    const double perimeter = (b - a).norm() + (c - b).norm() + (a - c).norm();
    const double inner = 2 * area / perimeter;
    const double outer = (b - a).norm() * (c - b).norm() * (a - c).norm() / (4 * area);
    EXPECT_NEAR(radius_ratio(a, b, c), 2 * inner / outer, 1e-14);
  }
}

}  // namespace
}  // namespace whittle::test
