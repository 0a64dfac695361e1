#include "whittle/core/geometry/triangle_intersection.hh"

#include <algorithm>

namespace whittle::detail {
namespace {

/// Limits for projections of two triangles onto an axis, relative to the sizes of axis and triangles.
constexpr double most_overlap = 1e-12;  ///< with this overlap or less they only touch
constexpr double least_extent = 1e-9;   ///< a smaller projection is rounding error

/// Whether one triangle is entirely ahead of the other along the direction between their centres. A common corner is
/// allowed. Holds for most neighbours on a surface.
bool are_apart(const Corners& s, const Corners& t) {
  const Vec3 way = (t[0] - s[0]) + (t[1] - s[1]) + (t[2] - s[2]);
  const auto along = [&](const Vec3& corner) { return way.dot(corner - s[0]); };
  const double s_high = std::max({0.0, along(s[1]), along(s[2])});
  const auto [t_low, t_high] = std::minmax({along(t[0]), along(t[1]), along(t[2])});
  return t_low >= s_high && t_high > 0;
}

bool has_area(const Corners& c) { return !reliable_normal(c[0], c[1], c[2]).isZero(0); }

/// They intersect if no axis separates their projections. \cite ericson_2005_collision (section 5.2.1)
bool do_overlap(const Corners& s, const Corners& t) {
  if (are_apart(s, t)) return false;
  const Corners s_offsets{Vec3::Zero(), s[1] - s[0], s[2] - s[0]};
  const Corners t_offsets{t[0] - s[0], t[1] - s[0], t[2] - s[0]};
  double size = 0;
  for (const Vec3& x : {s_offsets[1], s_offsets[2], t_offsets[0], t_offsets[1], t_offsets[2]}) {
    size = std::max(size, x.lpNorm<Eigen::Infinity>());
  }
  const auto separates = [&](const Vec3& axis) {
    const auto range = [&axis](const Corners& corners) {
      return std::minmax({axis.dot(corners[0]), axis.dot(corners[1]), axis.dot(corners[2])});
    };
    const auto [s_low, s_high] = range(s_offsets);
    const auto [t_low, t_high] = range(t_offsets);
    const double unit = axis.lpNorm<1>() * size;
    return std::max(t_low - s_high, s_low - t_high) >= -most_overlap * unit &&
           std::max(s_high, t_high) - std::min(s_low, t_low) > least_extent * unit;
  };
  const auto sides = [](const Corners& c) { return Corners{c[1] - c[0], c[2] - c[1], c[0] - c[2]}; };
  const Corners s_sides = sides(s_offsets);
  const Corners t_sides = sides(t_offsets);
  const Vec3 s_normal = s_sides[0].cross(s_sides[1]);
  const Vec3 t_normal = t_sides[0].cross(t_sides[1]);
  const auto separates_inside = [&](const Vec3& normal, const Corners& along) {
    return std::any_of(along.begin(), along.end(), [&](const Vec3& side) { return separates(normal.cross(side)); });
  };
  if (separates(s_normal) || separates(t_normal)) return false;
  if (separates_inside(s_normal, s_sides) || separates_inside(t_normal, t_sides)) return false;
  return std::none_of(s_sides.begin(), s_sides.end(),
                      [&](const Vec3& side) { return separates_inside(side, t_sides); });
}

}  // namespace

bool intersect(const Corners& s, const Corners& t) { return do_overlap(s, t) && has_area(s) && has_area(t); }

}  // namespace whittle::detail
