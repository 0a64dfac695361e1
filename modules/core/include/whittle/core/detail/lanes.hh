#pragma once

#include <cmath>
#include <cstddef>
#include <utility>

#include "whittle/core/indexed_mesh.hh"

// Computing on several doubles at once. Each gets bit for bit the result that it would get alone. So functions for
// processors with wider registers may be chosen at run time: `if (has_double4) …`.

namespace whittle {

using Double2 = double __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));

template <class Real>
inline constexpr std::size_t n_lanes = sizeof(Real) / sizeof(double);

/// The result of a comparison: bool, or for each element an integer that is all ones or zero.
template <class Real>
using LaneMask = decltype(Real{} > Real{});

/// Whether a mask is set in some lane.
inline bool any_lane(bool lane) { return lane; }
template <class Mask>
[[gnu::always_inline]] inline bool any_lane(const Mask& mask) {
  auto all = mask[0];
  for (std::size_t lane = 1; lane < sizeof(mask) / sizeof(mask[0]); ++lane) all |= mask[lane];
  return all != 0;
}

/// real = {at(0), at(1), …}
template <class Real, class At>
[[gnu::always_inline]] inline void fill_lanes(Real& real, const At& at) {
  [&]<std::size_t... lane>(std::index_sequence<lane...>) __attribute__((always_inline)) { real = Real{at(lane)...}; }
  (std::make_index_sequence<n_lanes<Real>>());
}

template <class Real>
struct FourLanes {
  Real first, second, third, fourth;
};

/// Transposes four elements of each lane's array: {at(0)[i], at(1)[i], …} for i = 0 … 3.
/// \param at `at(lane)` points to the first of the four
template <class Real, class At>
[[gnu::always_inline]] inline FourLanes<Real> transposed_lanes(const At& at) {
  FourLanes<Real> columns;
  if constexpr (n_lanes<Real> == 4) {
    using Row = double __attribute__((vector_size(32), may_alias, aligned(8)));
    const Real row0 = *reinterpret_cast<const Row*>(at(0));
    const Real row1 = *reinterpret_cast<const Row*>(at(1));
    const Real row2 = *reinterpret_cast<const Row*>(at(2));
    const Real row3 = *reinterpret_cast<const Row*>(at(3));
    const Real even01 = __builtin_shufflevector(row0, row1, 0, 4, 2, 6);
    const Real odd01 = __builtin_shufflevector(row0, row1, 1, 5, 3, 7);
    const Real even23 = __builtin_shufflevector(row2, row3, 0, 4, 2, 6);
    const Real odd23 = __builtin_shufflevector(row2, row3, 1, 5, 3, 7);
    columns.first = __builtin_shufflevector(even01, even23, 0, 1, 4, 5);
    columns.second = __builtin_shufflevector(odd01, odd23, 0, 1, 4, 5);
    columns.third = __builtin_shufflevector(even01, even23, 2, 3, 6, 7);
    columns.fourth = __builtin_shufflevector(odd01, odd23, 2, 3, 6, 7);
  } else {
    fill_lanes(columns.first, [&](std::size_t lane) { return at(lane)[0]; });
    fill_lanes(columns.second, [&](std::size_t lane) { return at(lane)[1]; });
    fill_lanes(columns.third, [&](std::size_t lane) { return at(lane)[2]; });
    fill_lanes(columns.fourth, [&](std::size_t lane) { return at(lane)[3]; });
  }
  return columns;
}

template <class Real>
[[gnu::always_inline]] inline double lane_of(const Real& real, std::size_t i) {
  if constexpr (n_lanes<Real> == 1) {
    return real;
  } else {
    return real[i];
  }
}

/// The square root of each lane.
template <class Real>
[[gnu::always_inline]] inline void take_square_roots(Real& x) {
  fill_lanes(x, [x](std::size_t i) { return std::sqrt(lane_of(x, i)); });
}

template <class Real>
struct PointLanes {
  Real x, y, z;

  [[gnu::always_inline]] friend PointLanes operator+(const PointLanes& a, const PointLanes& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  [[gnu::always_inline]] friend PointLanes operator-(const PointLanes& a, const PointLanes& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  [[gnu::always_inline]] PointLanes cross(const PointLanes& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
  [[gnu::always_inline]] Real dot(const PointLanes& o) const { return x * o.x + y * o.y + z * o.z; }
};

/// \param at `at(lane)` is the point of a lane
template <class Real, class At>
[[gnu::always_inline]] inline PointLanes<Real> point_lanes(const At& at) {
  PointLanes<Real> point;
  fill_lanes(point.x, [&](std::size_t lane) { return at(lane).x(); });
  fill_lanes(point.y, [&](std::size_t lane) { return at(lane).y(); });
  fill_lanes(point.z, [&](std::size_t lane) { return at(lane).z(); });
  return point;
}

inline PointLanes<double> point_lanes(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Marks functions that may use Double4. Call them only if `has_double4`. Functions to which they pass a Double4 must
/// be inlined.
#ifdef __x86_64__
#define WHITTLE_DOUBLE4 [[gnu::target("avx2")]]
inline const bool has_double4 = __builtin_cpu_supports("avx2") != 0;
#else
#define WHITTLE_DOUBLE4
inline const bool has_double4 = false;
#endif

}  // namespace whittle
