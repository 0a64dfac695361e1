#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "whittle/core/detail/portable_math.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Internal coordinates, so that neither the unit nor the position of a mesh changes a result. They are scaled by a
/// power of two to a size between 1/2 and 1, and centred along axes where the mesh is far from the origin.
///
/// Both conversions are exact for the positions the frame was made for: a vertex that doesn't move keeps every bit.
struct Frame {
  Vec3 center = Vec3::Zero();
  double scale = 1;    ///< frame units per model unit, a power of two
  double unscale = 1;  ///< 1 / scale

  Vec3 to_frame(const Vec3& p) const { return (p - center) * scale; }
  Corners to_frame(const Corners& c) const { return {to_frame(c[0]), to_frame(c[1]), to_frame(c[2])}; }
  Vec3 to_model(const Vec3& x) const { return x * unscale + center; }

  /// Converts a cost from the frame to model units, and back. \param dimension power of length in the cost's unit
  double cost_to_model(double cost, double dimension) const { return CostUnit(unscale, dimension).times(cost); }
  double cost_to_frame(double cost, double dimension) const { return CostUnit(scale, dimension).times(cost); }

  /// A power of a factor, to multiply many costs by. It multiplies twice by half the power: with a huge unit the whole
  /// power may be out of range, though the product isn't.
  class CostUnit {
   public:
    CostUnit(double factor, double dimension) : half_(detail::power(factor, 0.5 * dimension)) {}
    /// 0 stays 0 in any unit.
    double times(double cost) const { return cost == 0 ? 0 : cost * half_ * half_; }

   private:
    double half_;
  };

  static Frame of_points(std::span<const Vec3> points) { return of_box(bounds_of(points)); }

  /// \param box finite, not empty
  static Frame of_box(const Box& box) {
    Frame frame;
    double extent = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = box.min()[axis];
      const double b = box.max()[axis];
      extent = std::max(extent, 0.5 * b - 0.5 * a);
      // Differences to the center are exact between half and twice the center (Sterbenz). Elsewhere the
      // mesh is near enough to the origin.
      if ((a > 0 && b / 3 <= a) || (b < 0 && a / 3 >= b)) frame.center[axis] = 0.5 * a + 0.5 * b;
    }
    if (extent > 0) {
      const int exponent = std::clamp(std::ilogb(extent) + 2, -1000, 1000);
      frame.scale = std::ldexp(1.0, -exponent);
      frame.unscale = std::ldexp(1.0, exponent);
    }
    return frame;
  }
};

}  // namespace whittle
