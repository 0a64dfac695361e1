#include "whittle/core/float32_positions.hh"

#include <algorithm>
#include <limits>

#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle {
namespace {

/// The number goes through memory: GCC 12 with -O2 leaves out the rounding of two numbers at once.
double rounded(double x) {
  const volatile float single = static_cast<float>(x);
  return static_cast<double>(single);
}

}  // namespace

Vec3 rounded_to_float32(const Vec3& point, const Vec3& origin) {
  const Vec3 beside = point - origin;
  return Vec3(rounded(beside.x()), rounded(beside.y()), rounded(beside.z())) + origin;
}

bool fit_float32(std::span<const Vec3> points) {
  return std::all_of(points.begin(), points.end(), [](const Vec3& p) {
    return p.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max() && rounded_to_float32(p) == p;
  });
}

double float32_error(std::span<const Vec3> points) {
  double farthest = 0;
  for (const Vec3& p : points) farthest = std::max(farthest, (p - rounded_to_float32(p)).stableNorm());
  return farthest;
}

Vec3 float32_origin(std::span<const Vec3> points) {
  constexpr double near = 16;
  const Box box = bounds_of(points);
  const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (farthest <= near * diagonal_of(box)) return Vec3::Zero();
  return rounded_to_float32(Frame::of_box(box).center);
}

}  // namespace whittle
