#pragma once

#include <cmath>
#include <cstddef>
#include <utility>

#include "whittle/engine/indexed_mesh.hh"

// Several doubles computed on at once, each getting bit for bit what it would get alone. Which is why functions for
// processors with wider registers can be chosen at run time: `if (has_double4) …`.

namespace whittle {

using Double2 = double __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));

template <class Real>
inline constexpr std::size_t n_lanes = sizeof(Real) / sizeof(double);

/// What comparing them gives: bool, or one all-ones or zero integer an element.
template <class Real>
using LaneMask = decltype(Real{} > Real{});

inline bool any(bool lane) { return lane; }
template <class Mask>
[[gnu::always_inline]] inline bool any(const Mask& mask) {
  auto all = mask[0];
  for (std::size_t lane = 1; lane < sizeof(mask) / sizeof(mask[0]); ++lane) all |= mask[lane];
  return all != 0;
}

/// {at(0), at(1), …}
template <class Real, class At>
[[gnu::always_inline]] inline void fill_lanes(Real& real, const At& at) {
  [&]<std::size_t... lane>(std::index_sequence<lane...>) __attribute__((always_inline)) { real = Real{at(lane)...}; }
  (std::make_index_sequence<n_lanes<Real>>());
}

template <class Real>
[[gnu::always_inline]] inline double lane(const Real& real, std::size_t i) {
  if constexpr (n_lanes<Real> == 1) {
    return real;
  } else {
    return real[i];
  }
}

/// Each of x by itself.
template <class Real>
[[gnu::always_inline]] inline void take_square_roots(Real& x) {
  fill_lanes(x, [x](std::size_t i) { return std::sqrt(lane(x, i)); });
}

template <class Real>
struct PointLanes {
  Real x, y, z;

  [[gnu::always_inline]] friend PointLanes operator-(const PointLanes& a, const PointLanes& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  [[gnu::always_inline]] PointLanes cross(const PointLanes& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
  [[gnu::always_inline]] Real dot(const PointLanes& o) const { return x * o.x + y * o.y + z * o.z; }
};

/// \param at gives the point of a lane
template <class Real, class At>
[[gnu::always_inline]] inline PointLanes<Real> point_lanes(const At& at) {
  PointLanes<Real> point;
  fill_lanes(point.x, [&](std::size_t lane) { return at(lane).x(); });
  fill_lanes(point.y, [&](std::size_t lane) { return at(lane).y(); });
  fill_lanes(point.z, [&](std::size_t lane) { return at(lane).z(); });
  return point;
}

inline PointLanes<double> point_lanes(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Functions marked so may use Double4, and may only be called where `has_double4`. What they call with one must be
/// inlined.
#ifdef __x86_64__
#define WHITTLE_DOUBLE4 [[gnu::target("avx2")]]
inline const bool has_double4 = __builtin_cpu_supports("avx2") != 0;
#else
#define WHITTLE_DOUBLE4
inline const bool has_double4 = false;
#endif

}  // namespace whittle
