#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "charts.hh"
#include "whittle/core/detail/portable_math.hh"
#include "whittle/core/geometry/overlapping_boxes.hh"

namespace whittle::bake {

namespace {

using detail::ImageTriangle;
using detail::Vec2;

/// Whether a side of `a` has all of `b` behind it, up to rounding. \pre both turn the same way
bool separates(const ImageTriangle& a, const ImageTriangle& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 side = a[(i + 1) % 3] - a[i];
    const double limit = tolerance * side.norm();
    if (std::all_of(b.begin(), b.end(), [&](const Vec2& p) { return detail::cross(side, p - a[i]) <= limit; })) {
      return true;
    }
  }
  return false;
}

/// The two directions of the plane across an axis, so that right × up is the axis.
struct Plane {
  Vec3 right, up;
  explicit Plane(const Vec3& axis) : right(axis.unitOrthogonal()), up(axis.cross(right)) {}
};

/// Turned by an angle, as seen against the axis.
Plane turned(const Plane& plane, double cosine, double sine) {
  Plane other = plane;
  other.right = cosine * plane.right + sine * plane.up;
  other.up = cosine * plane.up - sine * plane.right;
  return other;
}

/// Upwards, as on a sheet of paper.
std::vector<ImageTriangle> projected(const std::vector<Vec3>& positions, const std::vector<Triangle>& faces,
                                     const std::vector<Index>& chosen, const Plane& plane) {
  std::vector<ImageTriangle> triangles(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = positions[faces[chosen[i]][k]];
      triangles[i][k] = Vec2(plane.right.dot(p), plane.up.dot(p));
    }
  }
  return triangles;
}

Eigen::AlignedBox2d box_of(const std::vector<ImageTriangle>& triangles) {
  Eigen::AlignedBox2d box;
  for (const ImageTriangle& triangle : triangles) {
    for (const Vec2& p : triangle) box.extend(p);
  }
  return box;
}

/// Turns the plane so that the rectangle around the chart is small, and not higher than wide.
Plane best_plane(const std::vector<Vec3>& positions, const std::vector<Triangle>& faces, const Chart& chart) {
  constexpr double step_deg = 5;
  const Plane any(chart.axis);
  Plane best = any;
  double least = std::numeric_limits<double>::infinity();
  for (double angle = 0; angle < 90; angle += step_deg) {
    const Plane plane = turned(any, detail::cosine_of_deg(angle), detail::cosine_of_deg(90 - angle));
    const Vec2 extent = box_of(projected(positions, faces, chart.faces, plane)).sizes();
    if (!(extent.prod() < least)) continue;
    least = extent.prod();
    best = extent.y() > extent.x() ? turned(plane, 0, 1) : plane;
  }
  return best;
}

/// Per face, 1 if it lies over one before it that stays.
std::vector<std::uint8_t> find_covering(const std::vector<ImageTriangle>& triangles) {
  const Eigen::AlignedBox2d around = box_of(triangles);
  const double tolerance = 1e-9 * around.sizes().norm();
  const auto covers = [&](Index i, Index j) {
    const ImageTriangle &a = triangles[i], &b = triangles[j];
    const auto has_area = [&](const ImageTriangle& t) { return detail::area_on_image(t[0], t[1], t[2]) > 0; };
    return has_area(a) && has_area(b) && !separates(a, b, tolerance) && !separates(b, a, tolerance);
  };
  std::vector<FloatBox> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const Vec2& p : triangles[i]) {
      boxes[i].extend(Eigen::Vector3f(static_cast<float>(p.x()), static_cast<float>(p.y()), 0));
    }
  }
  std::vector<std::uint8_t> is_over(triangles.size(), 0);
  constexpr unsigned one_thread = 1;
  for (const auto& [i, j] : overlapping_boxes(boxes, covers, one_thread)) {
    if (is_over[i] == 0) is_over[j] = 1;
  }
  return is_over;
}

/// Moves the faces that cover others into a chart of their own.
Chart split_off(Chart& chart, const std::vector<std::uint8_t>& is_over) {
  Chart rest{chart.axis, {}};
  std::vector<Index> kept;
  for (std::size_t i = 0; i < chart.faces.size(); ++i) {
    (is_over[i] != 0 ? rest.faces : kept).push_back(chart.faces[i]);
  }
  chart.faces = std::move(kept);
  return rest;
}

FlatChart placed(const std::vector<Vec3>& positions, const std::vector<Triangle>& faces, Chart chart) {
  const Plane plane = best_plane(positions, faces, chart);
  FlatChart flat{plane.right, std::move(chart.faces), {}, {}};
  flat.triangles = projected(positions, faces, flat.faces, plane);
  const Eigen::AlignedBox2d box = box_of(flat.triangles);
  flat.extent = box.sizes();
  for (ImageTriangle& triangle : flat.triangles) {
    for (Vec2& p : triangle) p = Vec2(p.x() - box.min().x(), box.max().y() - p.y());
  }
  return flat;
}

}  // namespace

std::vector<FlatChart> lay_flat(const std::vector<Vec3>& positions, const std::vector<Triangle>& faces, Chart chart) {
  std::vector<FlatChart> flat;
  while (!chart.faces.empty()) {
    Chart rest = split_off(chart, find_covering(projected(positions, faces, chart.faces, Plane(chart.axis))));
    flat.push_back(placed(positions, faces, std::move(chart)));
    chart = std::move(rest);
  }
  return flat;
}

}  // namespace whittle::bake
