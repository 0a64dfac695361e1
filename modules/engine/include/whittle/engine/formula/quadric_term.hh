#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "whittle/core/detail/lanes.hh"
#include "whittle/core/detail/portable_math.hh"
#include "whittle/engine/formula/quadric.hh"

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
  /// on flat and straight neighbourhoods. [0, inf). Measured: 1e-9 … 1e-7 best for the error; 0 lets rounding decide on
  /// flat ground. Greater ones make rounder triangles and cost error, 4e-3 some 10 % on scans, but 90 % on CAD, where
  /// flat sides don't stay flat (docs/dev/decisions.md).
  double regularization = 1e-9;

  /// Weight of the planes through border edges, times the squared edge length (times 1 with uniform weights).
  /// [0, inf); 0 = borders are free.
  double boundary_weight = 20;

  /// w of the point quadrics that hold a vertex once a threshold pair has joined it to another: w W |x − p|²
  /// for each vertex merged, W the weight of its faces' planes, p where it was. [0, inf).
  double point_weight = 1e-3;
};

/// Symmetric 3x3 matrices side by side, their upper triangles.
template <class Real>
struct SymmetricLanes {
  Real xx{}, xy{}, xz{}, yy{}, yz{}, zz{};

  WHITTLE_INLINE SymmetricLanes& operator+=(const SymmetricLanes& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    return *this;
  }
};

inline SymmetricMatrix matrix(const SymmetricLanes<double>& m) { return {m.xx, m.xy, m.xz, m.yy, m.yz, m.zz}; }

/// The quadric of a plane through its vertex, about that vertex, where it is a matrix alone: w n nᵀ + ε w I.
/// \param normal n, of unit length
template <class Real>
WHITTLE_INLINE SymmetricLanes<Real> plane_quadric(const PointLanes<Real>& normal, const Real& weight,
                                                  const QuadricOptions& options) {
  const auto [x, y, z] = normal;
  const PointLanes<Real> w{weight * x, weight * y, weight * z};
  const Real diagonal = options.regularization * weight;
  return {w.x * x + diagonal, w.x * y, w.x * z, w.y * y + diagonal, w.y * z, w.z * z + diagonal};
}

/// Faces side by side, each by its plane.
template <class Real>
struct FacePlanes {
  PointLanes<Real> normal;  ///< of unit length; zero if it has no area
  Real length;              ///< twice the area
};

/// \param normal (next − corner) × (previous − corner)
template <class Real>
WHITTLE_INLINE FacePlanes<Real> face_planes(const PointLanes<Real>& normal) {
  Real length = normal.dot(normal);
  take_square_roots(length);
  const Real inverse = select_lanes(length > 0, 1 / length, Real{});
  return {{normal.x * inverse, normal.y * inverse, normal.z * inverse}, length};
}

/// Shares of faces (corner, next, previous) in the quadrics of their first corners, about those. Zero for a face
/// without area.
template <class Real>
WHITTLE_INLINE SymmetricLanes<Real> corner_quadrics(const PointLanes<Real>& corner, const PointLanes<Real>& next,
                                                    const PointLanes<Real>& previous, const QuadricOptions& options) {
  const auto to_next = next - corner;
  const auto to_previous = previous - corner;
  const FacePlanes<Real> plane = face_planes(to_next.cross(to_previous));
  const Real& length = plane.length;
  Real weight = select_lanes(length > 0, Real{} + 1, Real{});
  if (options.weights != Weights::uniform) weight = 0.5 * length;
  if (options.weights == Weights::area_angle) {
    const Real cosine = to_next.dot(to_previous);
    Real angle;
    fill_lanes(angle, [&](std::size_t i) { return detail::angle_of(lane_of(length, i), lane_of(cosine, i)); });
    weight *= angle / std::numbers::pi;
  }
  return plane_quadric(plane.normal, weight, options);
}

inline SymmetricMatrix corner_quadric(const Vec3& corner, const Vec3& next, const Vec3& previous,
                                      const QuadricOptions& options) {
  return matrix(corner_quadrics(point_lanes(corner), point_lanes(next), point_lanes(previous), options));
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
  return matrix(plane_quadric(point_lanes(inward * (1 / length)), options.boundary_weight * unit_weight, options));
}

}  // namespace whittle
