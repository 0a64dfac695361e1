#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "whittle/engine/quadric.hh"

// Garland–Heckbert cost of contracting a pair (v0, v1) to v̄:
//
//   cost = E₀(v̄) + E₁(v̄),   E_v(x) = Σ_faces w (nᵀ(x − p))² + Σ_borders w' (mᵀ(x − p))² + ε W |x − p|²
//
// summed over the planes of all vertices merged so far, each plane through the vertex p it was made for. n is the unit
// normal of a face, m the unit normal of the plane through a border edge perpendicular to its face, w their weight,
// W = Σ w. Unit: distance² · area, or distance² with uniform weights.
// \cite garland_1997_surface (sections 4 and 6), \cite garland_1999_thesis (section 3.4: area weights)

namespace whittle {

/// How much a face's plane counts at each of its three vertices.
enum class Weights {
  area,       ///< the area of the face
  uniform,    ///< 1 \cite garland_1997_surface
  area_angle  ///< area · corner angle / π, the same for any triangulation of a plane \cite garland_1999_thesis
};

/// Where the merged vertex goes.
enum class Placement {
  optimal,   ///< the minimum of the cost; where there is none nearby, the best of both ends and the midpoint
  midpoint,  ///< the middle of the pair
  endpoint   ///< the better of both ends
};

struct QuadricOptions {
  Weights weights = Weights::area;
  Placement placement = Placement::optimal;

  /// ε, times the weight of a vertex's planes, times squared distance to the vertex: keeps the minimum unique and near
  /// on flat and straight neighbourhoods. [0, inf). Measured: 1e-9 … 1e-7 best; 1e-5 costs 60 % error on CAD; 0 lets
  /// rounding decide on flat ground.
  double regularization = 1e-9;

  /// Weight of the planes through border edges, times the squared edge length (times 1 with uniform weights).
  /// [0, inf); 0 = borders are free.
  double boundary_weight = 10;
};

/// Which end of a pair may not move.
enum class Pinned { none, first, second };

struct PairEvaluation {
  double bound;   ///< min over all x of E₀ + E₁: never falls when either end merges with others, so an old one is a
                  ///< lower bound of every later cost. At least 0.
  double cost;    ///< E₀ + E₁ at `position`; at least `bound`.
  Vec3 position;  ///< v̄
};

/// Farthest an optimal placement may lie from the middle of the pair, in lengths of the pair. The planes of a long,
/// slightly conical surface all but meet at its distant tip: without a limit a contraction there makes a spike.
/// Elsewhere it hardly matters: the mean error over six scans and CAD parts at 10 % and 1 % of the faces, as a share of
/// ModQuadric's, was 0.6515, 0.6509 and 0.6509 for a reach of 2, 8 and 1000.
inline constexpr double max_placement_reach = 8;

/// Cost and placement of contracting two vertices at p0 and p1 with quadrics q0, q1 about their own positions.
/// Swapping the vertices gives the same bits, but where both ends cost the same: there the first one's position wins,
/// so callers pass the vertex of the lower original number first.
inline PairEvaluation evaluate_pair(const Quadric& q0, const Vec3& p0, const Quadric& q1, const Vec3& p1,
                                    Placement placement, Pinned pinned = Pinned::none) {
  // Both about the midpoint: x = 0 there, −h at p0, +h at p1.
  const Vec3 h = 0.5 * (p1 - p0);
  const Vec3 a0_h = q0.a * h;
  const Vec3 a1_h = q1.a * h;
  const SymmetricMatrix a = q0.a + q1.a;
  const Vec3 b = (q0.b + q1.b) + (a0_h - a1_h);
  const double c = (q0.c + q1.c) + h.dot(2 * (q0.b - q1.b) + (a0_h + a1_h));
  const Vec3 middle = 0.5 * (p0 + p1);
  const auto cost_at = [&](const Vec3& x) { return std::max(0.0, c + x.dot(2 * b + a * x)); };

  const std::optional<Vec3> minimum = a.solve(-b);
  const double bound = minimum ? std::max(0.0, c + minimum->dot(b)) : 0.0;
  const auto at_cost = [bound](double cost, const Vec3& position) {
    return PairEvaluation{bound, std::max(bound, cost), position};
  };

  if (pinned == Pinned::first) return at_cost(cost_at(-h), p0);
  if (pinned == Pinned::second) return at_cost(cost_at(h), p1);
  if (placement == Placement::midpoint) return at_cost(cost_at(Vec3::Zero()), middle);
  if (placement == Placement::optimal && minimum &&
      minimum->squaredNorm() <= 4 * max_placement_reach * max_placement_reach * h.squaredNorm()) {
    return {bound, bound, middle + *minimum};
  }
  const double cost0 = cost_at(-h);
  const double cost1 = cost_at(h);
  if (placement == Placement::optimal) {
    const double cost_middle = cost_at(Vec3::Zero());
    if (cost_middle <= std::min(cost0, cost1)) return at_cost(cost_middle, middle);
  }
  return cost0 <= cost1 ? at_cost(cost0, p0) : at_cost(cost1, p1);
}

/// The quadric of the merged vertex about its position.
inline Quadric merged_quadric(const Quadric& q0, const Vec3& p0, const Quadric& q1, const Vec3& p1,
                              const Vec3& position) {
  Quadric q = q0.about(position - p0);
  q += q1.about(position - p1);
  q.c = std::max(0.0, q.c);
  return q;
}

/// The quadric of a plane through its vertex, about that vertex, where it is a matrix alone: w n nᵀ + ε w I.
/// \param normal √w n: perpendicular to the plane, its squared length the weight.
inline SymmetricMatrix plane_quadric(const Vec3& normal, const QuadricOptions& options) {
  return SymmetricMatrix::outer(normal, 1) + SymmetricMatrix::identity(options.regularization * normal.squaredNorm());
}

/// √w n of a face with its normal n and its weight w at each corner, `area` or `uniform`; zero for a face without area.
/// \param corners counter-clockwise
inline Vec3 weighted_normal(const std::array<Vec3, 3>& corners, Weights weights) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double length = normal.norm();  // twice the area
  if (!(length > 0)) return Vec3::Zero();
  return normal / (weights == Weights::uniform ? length : std::sqrt(2 * length));
}

/// The share of a corner's angle in π, by which `area_angle` weights a face at its corner i.
inline double angle_share(const std::array<Vec3, 3>& corners, std::size_t i) {
  const Vec3 u = corners[(i + 1) % 3] - corners[i];
  const Vec3 v = corners[(i + 2) % 3] - corners[i];
  return std::atan2(u.cross(v).norm(), u.dot(v)) / std::numbers::pi;
}

/// Share of one face in the quadrics of its corners, each about its own corner.
inline std::array<SymmetricMatrix, 3> face_quadrics(const std::array<Vec3, 3>& corners, const QuadricOptions& options) {
  const Vec3 normal = weighted_normal(corners, options.weights);
  if (options.weights != Weights::area_angle) {
    const SymmetricMatrix share = plane_quadric(normal, options);
    return {share, share, share};
  }
  std::array<SymmetricMatrix, 3> shares;
  for (std::size_t i = 0; i < 3; ++i) shares[i] = plane_quadric(normal * std::sqrt(angle_share(corners, i)), options);
  return shares;
}

/// Share of a border edge in the quadrics of both its ends, each about itself: the plane through the edge perpendicular
/// to its face, whose third corner is `opposite`. Zero for an edge or a face without extent.
inline SymmetricMatrix border_quadric(const Vec3& from, const Vec3& to, const Vec3& opposite,
                                      const QuadricOptions& options) {
  const Vec3 edge = to - from;
  const Vec3 inward = edge.cross(opposite - from).cross(edge);
  const double length = inward.norm();
  if (!(length > 0)) return {};
  const double unit_weight = options.weights == Weights::uniform ? 1 : edge.squaredNorm();
  return plane_quadric(inward * (std::sqrt(options.boundary_weight * unit_weight) / length), options);
}

}  // namespace whittle
