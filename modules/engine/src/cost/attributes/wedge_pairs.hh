#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "whittle/core/detail/lanes.hh"
#include "whittle/engine/formula/pair_minimum.hh"

// The quadric of two wedges as one (wedge_quadrics.hh), for one pair or several at once: `Real` is float or Float4.

namespace whittle {

/// Each number in double precision, and each rounded to single precision.
WHITTLE_INLINE Double4 widened(const Float4& lanes) { return Double4{lanes[0], lanes[1], lanes[2], lanes[3]}; }
WHITTLE_INLINE Float4 rounded(const Double4& lanes) {
  return Float4{static_cast<float>(lanes[0]), static_cast<float>(lanes[1]), static_cast<float>(lanes[2]),
                static_cast<float>(lanes[3])};
}

/// How the numbers of a wedge lie: the weight; the quadric, ten numbers; then for each four components the slopes along
/// x, along y, along z, and the values at the origin.
struct WedgeLayout {
  static constexpr std::size_t weight = 0;
  static constexpr std::size_t spread = 1;
  static constexpr std::size_t functions = 12;
  static constexpr std::size_t functions_length = 16;
};

/// Loads four numbers of one wedge.
struct OneWedge {
  const float* numbers;

  WHITTLE_INLINE std::array<float, 4> operator()(std::size_t i) const {
    return {numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3]};
  }
};

/// Loads four numbers of four wedges: the first ones side by side, then the second ones, …
struct FourWedges {
  std::array<const float*, 4> numbers;

  WHITTLE_INLINE std::array<Float4, 4> operator()(std::size_t i) const {
    const auto row = [&](std::size_t wedge) WHITTLE_INLINE_LAMBDA { return load_lanes<Float4>(numbers[wedge] + i); };
    const auto [first, second, third, fourth] = transposed<Float4>({row(0), row(1), row(2), row(3)});
    return {first, second, third, fourth};
  }
};

/// The quadric of a wedge, whose last two numbers are those of something else.
template <class Real, class Load>
WHITTLE_INLINE QuadricSumLanes<Real> wedge_spread(const Load& load) {
  const auto [xx, xy, xz, yy] = load(WedgeLayout::spread);
  const auto [yz, zz, bx, by] = load(WedgeLayout::spread + 4);
  const auto [bz, c, unused, also_unused] = load(WedgeLayout::spread + 8);
  return {xx, xy, xz, yy, yz, zz, bx, by, bz, c};
}

/// W₁ W₂ / W
template <class Real>
WHITTLE_INLINE Real reduced_weight(const Real& first, const Real& second) {
  const Real both = first + second;
  return select_lanes(both > 0, first * (second / both), Real{});
}

/// \param first, second load numbers of the wedges \param b_to_a the way from the origin of the second to the first's
/// \return about the origin of the first
template <class Real, class Load>
WHITTLE_INLINE QuadricSumLanes<Real> quadric_of_both(const Load& first, const Load& second, std::size_t n_components,
                                                     const PointLanes<Real>& b_to_a) {
  QuadricSumLanes<Real> squares{};
  auto& [xx, xy, xz, yy, yz, zz, bx, by, bz, c] = squares;
  for (std::size_t group = 0; 4 * group < n_components; ++group) {
    const std::size_t at = WedgeLayout::functions + group * WedgeLayout::functions_length;
    const auto x1 = first(at), y1 = first(at + 4), z1 = first(at + 8), value1 = first(at + 12);
    const auto x2 = second(at), y2 = second(at + 4), z2 = second(at + 8), value2 = second(at + 12);
    const std::size_t n = std::min<std::size_t>(4, n_components - 4 * group);
    for (std::size_t j = 0; j < n; ++j) {
      const Real x = x1[j] - x2[j];
      const Real y = y1[j] - y2[j];
      const Real z = z1[j] - z2[j];
      const Real value = value1[j] - (value2[j] + (x2[j] * b_to_a.x + y2[j] * b_to_a.y + z2[j] * b_to_a.z));
      xx += x * x, xy += x * y, xz += x * z, yy += y * y, yz += y * z, zz += z * z;
      bx += x * value, by += y * value, bz += z * value, c += value * value;
    }
  }
  const Real weight = reduced_weight<Real>(first(WedgeLayout::weight)[0], second(WedgeLayout::weight)[0]);
  const QuadricSumLanes<Real> q1 = wedge_spread<Real>(first);
  const QuadricSumLanes<Real> q2 = wedge_spread<Real>(second);
  const auto& [tx, ty, tz] = b_to_a;
  const Real ax = q2.xx * tx + q2.xy * ty + q2.xz * tz;
  const Real ay = q2.xy * tx + q2.yy * ty + q2.yz * tz;
  const Real az = q2.xz * tx + q2.yz * ty + q2.zz * tz;
  const Real moved_c = q2.c + (tx * (q2.bx + q2.bx + ax) + ty * (q2.by + q2.by + ay) + tz * (q2.bz + q2.bz + az));
  return {q1.xx + q2.xx + weight * xx,        q1.xy + q2.xy + weight * xy,        q1.xz + q2.xz + weight * xz,
          q1.yy + q2.yy + weight * yy,        q1.yz + q2.yz + weight * yz,        q1.zz + q2.zz + weight * zz,
          q1.bx + (q2.bx + ax) + weight * bx, q1.by + (q2.by + ay) + weight * by, q1.bz + (q2.bz + az) + weight * bz,
          q1.c + moved_c + weight * c};
}

}  // namespace whittle
