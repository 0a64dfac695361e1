#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

#include "whittle/core/detail/compiler.hh"
#include "whittle/core/indexed_mesh.hh"

#ifndef WHITTLE_HAS_LANES
#include "whittle/core/detail/lane_array.hh"
#endif

// Computing on several numbers at once. Each number gets the same result as alone, bit for bit. So functions for
// processors with wider registers may be chosen at run time: `if (has_double4) …`. If the compiler has no vectors,
// arrays with the same operators replace them. Vectors have `?:` but arrays can't, hence `select_lanes`.

namespace whittle {

namespace detail {
#ifdef WHITTLE_HAS_LANES
template <class T, int n>
using Lanes = typename LaneVector<T, n>::Type;
#else
template <class T, int n>
using Lanes = LaneArray<T, n>;
#endif
}  // namespace detail

using Double2 = detail::Lanes<double, 2>;
using Double4 = detail::Lanes<double, 4>;
/// Vectors in registers that every processor has.
using Float4 = detail::Lanes<float, 4>;

template <class Real>
inline constexpr std::size_t n_lanes = sizeof(Real) / sizeof(double);

/// The result of a comparison: bool, or per element an integer of all ones or zero.
template <class Real>
using LaneMask = decltype(Real{} > Real{});

/// Whether a mask is set in some lane.
inline bool any_lane(bool lane) { return lane; }
template <class Mask>
WHITTLE_INLINE bool any_lane(const Mask& mask) {
  auto all = mask[0];
  for (std::size_t lane = 1; lane < sizeof(mask) / sizeof(mask[0]); ++lane) all |= mask[lane];
  return all != 0;
}

/// `yes` in lanes where the condition holds, else `no`. (lane_array.hh has this for arrays.)
template <class Real>
WHITTLE_INLINE Real select_lanes(const LaneMask<Real>& condition, const Real& yes, const Real& no) {
  return condition ? yes : no;
}

/// The numbers at `from`, which may be unaligned.
template <class Vector, class Number>
WHITTLE_INLINE Vector load_lanes(const Number* from) {
  Vector lanes;
  std::memcpy(static_cast<void*>(&lanes), from, sizeof(lanes));
  return lanes;
}

template <class Vector, class Number>
WHITTLE_INLINE void store_lanes(const Vector& lanes, Number* to) {
  std::memcpy(static_cast<void*>(to), &lanes, sizeof(lanes));
}

/// real = {at(0), at(1), …}
template <class Real, class At>
WHITTLE_INLINE void fill_lanes(Real& real, const At& at) {
  [&]<std::size_t... lane>(std::index_sequence<lane...>) WHITTLE_INLINE_LAMBDA { real = Real{at(lane)...}; }
  (std::make_index_sequence<n_lanes<Real>>());
}

template <class Real>
struct FourLanes {
  Real first, second, third, fourth;
};

/// Four lanes of four as a matrix, its rows for its columns.
template <class Real>
WHITTLE_INLINE FourLanes<Real> transposed(const FourLanes<Real>& rows) {
  static_assert(sizeof(Real) == 4 * sizeof(Real{}[0]));
  const Real even01 = shuffled<0, 4, 2, 6>(rows.first, rows.second);
  const Real odd01 = shuffled<1, 5, 3, 7>(rows.first, rows.second);
  const Real even23 = shuffled<0, 4, 2, 6>(rows.third, rows.fourth);
  const Real odd23 = shuffled<1, 5, 3, 7>(rows.third, rows.fourth);
  return {shuffled<0, 1, 4, 5>(even01, even23), shuffled<0, 1, 4, 5>(odd01, odd23),
          shuffled<2, 3, 6, 7>(even01, even23), shuffled<2, 3, 6, 7>(odd01, odd23)};
}

/// Transposes four elements of each lane's array: {at(0)[i], at(1)[i], …} for i = 0 … 3.
/// \param at `at(lane)` points to the first of the four
template <class Real, class At>
WHITTLE_INLINE FourLanes<Real> transposed_lanes(const At& at) {
  if constexpr (n_lanes<Real> == 4) {
    return transposed<Real>(
        {load_lanes<Real>(at(0)), load_lanes<Real>(at(1)), load_lanes<Real>(at(2)), load_lanes<Real>(at(3))});
  } else {
    FourLanes<Real> columns;
    fill_lanes(columns.first, [&](std::size_t lane) { return at(lane)[0]; });
    fill_lanes(columns.second, [&](std::size_t lane) { return at(lane)[1]; });
    fill_lanes(columns.third, [&](std::size_t lane) { return at(lane)[2]; });
    fill_lanes(columns.fourth, [&](std::size_t lane) { return at(lane)[3]; });
    return columns;
  }
}

template <class Real>
WHITTLE_INLINE double lane_of(const Real& real, std::size_t i) {
  if constexpr (n_lanes<Real> == 1) {
    return real;
  } else {
    return real[i];
  }
}

/// The square root of each lane.
template <class Real>
WHITTLE_INLINE void take_square_roots(Real& x) {
  fill_lanes(x, [x](std::size_t i) { return std::sqrt(lane_of(x, i)); });
}

template <class Real>
struct PointLanes {
  Real x, y, z;

  WHITTLE_INLINE friend PointLanes operator+(const PointLanes& a, const PointLanes& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  WHITTLE_INLINE friend PointLanes operator-(const PointLanes& a, const PointLanes& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  WHITTLE_INLINE PointLanes cross(const PointLanes& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
  WHITTLE_INLINE Real dot(const PointLanes& o) const { return x * o.x + y * o.y + z * o.z; }
};

/// \param at `at(lane)` is the point of a lane
template <class Real, class At>
WHITTLE_INLINE PointLanes<Real> point_lanes(const At& at) {
  PointLanes<Real> point;
  fill_lanes(point.x, [&](std::size_t lane) { return at(lane).x(); });
  fill_lanes(point.y, [&](std::size_t lane) { return at(lane).y(); });
  fill_lanes(point.z, [&](std::size_t lane) { return at(lane).z(); });
  return point;
}

inline PointLanes<double> point_lanes(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Whether functions marked WHITTLE_AVX2 may be called. Functions to which they pass a Double4 must be inlined.
inline const bool has_double4 = has_avx2();

}  // namespace whittle
