// Ear clipping (G. Meisters, "Polygons have ears", 1975): a convex corner is an ear if no reflex corner lies in its
// triangle. The grid brings this down to about n tests for outlines of real parts. The worst case takes n² tests. After
// `tests_per_corner` n tests all corners are clipped untested: a hostile file can't hang the reader.
#include "repair/triangulate.hh"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace whittle::io {

namespace {

constexpr std::uint64_t tests_per_corner = 2000;
constexpr std::size_t most_fan_corners = 16;

Vec3 newell_normal(std::span<const Index> polygon, const std::vector<Vec3>& positions) {
  const Vec3& origin = positions[polygon[0]];  // Far from zero, the products would lose the polygon's shape.
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    normal += (positions[polygon[i]] - origin).cross(positions[polygon[i + 1]] - origin);
  }
  return normal;
}

void make_fan(Index n_corners, std::span<Triangle> out) {
  for (Index i = 0; i + 2 < n_corners; ++i) out[i] = {0, i + 1, i + 2};
}

// A triangle between the ends and the middle of a chain of corners, then both halves of the chain. No corner gets many
// triangles.
void halve(Index first, Index last, std::span<Triangle> out) {
  if (last - first < 2) return;
  const Index middle = first + (last - first + 1) / 2;
  out[0] = {first, middle, last};
  halve(first, middle, out.subspan(1));
  halve(middle, last, out.subspan(middle - first));
}

}  // namespace

void PolygonTriangulator::triangulate(std::span<const Index> polygon, const std::vector<Vec3>& positions,
                                      std::span<Triangle> out) {
  if (polygon.size() == 3) {
    out[0] = {0, 1, 2};
    return;
  }
  if (polygon.size() == 4) {
    split_quad(polygon, positions, out);
    return;
  }
  project(polygon, positions);
  if (is_strictly_convex()) {
    const auto n = static_cast<Index>(polygon.size());
    n <= most_fan_corners ? make_fan(n, out) : halve(0, n - 1, out);
    return;
  }
  clip_ears(out);
}

void PolygonTriangulator::split_quad(std::span<const Index> quad, const std::vector<Vec3>& positions,
                                     std::span<Triangle> out) {
  const Vec3& a = positions[quad[0]];
  const Vec3 b = positions[quad[1]] - a;
  const Vec3 c = positions[quad[2]] - a;
  const Vec3 d = positions[quad[3]] - a;
  // Positive if the two triangles of the split face the same way.
  const double across_ac = b.cross(c).dot(c.cross(d));
  const double across_bd = b.cross(d).dot((c - b).cross(d - b));
  const bool ac_is_good = across_ac > 0;
  const bool bd_is_good = across_bd > 0;
  const bool use_bd = ac_is_good == bd_is_good ? (d - b).squaredNorm() < c.squaredNorm() : bd_is_good;
  if (use_bd) {
    out[0] = {0, 1, 3};
    out[1] = {1, 2, 3};
  } else {
    out[0] = {0, 1, 2};
    out[1] = {0, 2, 3};
  }
}

// Drops the coordinate along which the polygon's normal is longest. Scales to unit size, so that products neither
// overflow nor vanish.
void PolygonTriangulator::project(std::span<const Index> polygon, const std::vector<Vec3>& positions) {
  const Vec3 normal = newell_normal(polygon, positions);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const Eigen::Index u = (axis + (normal[axis] < 0 ? 2 : 1)) % 3;
  const Eigen::Index v = (axis + (normal[axis] < 0 ? 1 : 2)) % 3;
  const Vec3& origin = positions[polygon[0]];
  double extent = 0;
  points_.clear();
  for (const Index corner : polygon) {
    const Vec3 p = positions[corner] - origin;
    points_.push_back({p[u], p[v]});
    extent = std::max({extent, std::abs(p[u]), std::abs(p[v])});
  }
  if (!(extent > 0) || !std::isfinite(extent)) extent = 1;
  for (Point& p : points_) p = {p[0] / extent, p[1] / extent};
}

// Twice the signed area of the triangle, positive if it is counter-clockwise.
double PolygonTriangulator::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  const Point& p = points_[a];
  const Point& q = points_[b];
  const Point& r = points_[c];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

// Also true for a star that goes round twice. A fan is as good for it as any other.
bool PolygonTriangulator::is_strictly_convex() const {
  const auto n = static_cast<std::uint32_t>(points_.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!(turn(i, (i + 1) % n, (i + 2) % n) > 0)) return false;
  }
  return true;
}

void PolygonTriangulator::build_grid() {
  const auto n = static_cast<std::uint32_t>(points_.size());
  cells_ = static_cast<std::uint32_t>(std::clamp(std::sqrt(static_cast<double>(n)), 1.0, 1024.0));
  cell_begin_.assign(std::size_t{cells_} * cells_ + 1, 0);
  const auto cell_of = [&](std::uint32_t corner) {
    const auto along = [&](double x) {
      return static_cast<std::uint32_t>(std::clamp((x + 1) / 2 * cells_, 0.0, static_cast<double>(cells_ - 1)));
    };
    return std::size_t{along(points_[corner][1])} * cells_ + along(points_[corner][0]);
  };
  for (std::uint32_t i = 0; i < n; ++i) cell_begin_[cell_of(i) + 1] += is_reflex_[i] != 0;
  for (std::size_t c = 1; c < cell_begin_.size(); ++c) cell_begin_[c] += cell_begin_[c - 1];
  cell_corners_.resize(cell_begin_.back());
  std::vector<std::uint32_t> fill(cell_begin_.begin(), cell_begin_.end() - 1);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (is_reflex_[i]) cell_corners_[fill[cell_of(i)]++] = i;
  }
}

bool PolygonTriangulator::is_ear(std::uint32_t corner) {
  const std::uint32_t a = previous_[corner];
  const std::uint32_t c = next_[corner];
  if (!(turn(a, corner, c) > 0)) return false;
  const auto [low_x, high_x] = std::minmax({points_[a][0], points_[corner][0], points_[c][0]});
  const auto [low_y, high_y] = std::minmax({points_[a][1], points_[corner][1], points_[c][1]});
  const auto along = [&](double x) {
    return static_cast<std::uint32_t>(std::clamp((x + 1) / 2 * cells_, 0.0, static_cast<double>(cells_ - 1)));
  };
  for (std::uint32_t y = along(low_y); y <= along(high_y); ++y) {
    const std::size_t row = std::size_t{y} * cells_;
    const std::uint32_t first = cell_begin_[row + along(low_x)];
    const std::uint32_t last = cell_begin_[row + along(high_x) + 1];
    tests_left_ -= std::min<std::uint64_t>(tests_left_, 1 + (last - first));
    for (std::uint32_t k = first; k < last; ++k) {
      const std::uint32_t p = cell_corners_[k];
      if (!is_reflex_[p] || p == a || p == c || p == corner) continue;
      // A corner at the same position as one of the triangle's (a bridge to a hole) doesn't lie inside.
      if (points_[p] == points_[a] || points_[p] == points_[corner] || points_[p] == points_[c]) continue;
      if (turn(a, corner, p) >= 0 && turn(corner, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
  }
  return true;
}

void PolygonTriangulator::clip_ears(std::span<Triangle> out) {
  const auto n = static_cast<std::uint32_t>(points_.size());
  next_.resize(n);
  previous_.resize(n);
  is_reflex_.assign(n, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    next_[i] = (i + 1) % n;
    previous_[i] = (i + n - 1) % n;
  }
  for (std::uint32_t i = 0; i < n; ++i) is_reflex_[i] = !(turn(previous_[i], i, next_[i]) > 0);
  build_grid();
  tests_left_ = tests_per_corner * n;

  std::uint32_t left = n;
  std::uint32_t corner = 0;
  std::uint32_t failures = 0;  // Successive. A full round without an ear means that the polygon isn't simple.
  std::size_t written = 0;
  while (left > 3) {
    const bool forced = failures >= left || tests_left_ == 0;
    if (!forced && !is_ear(corner)) {
      corner = next_[corner];
      ++failures;
      continue;
    }
    const std::uint32_t a = previous_[corner];
    const std::uint32_t c = next_[corner];
    out[written++] = {a, corner, c};
    next_[a] = c;
    previous_[c] = a;
    is_reflex_[corner] = 0;
    for (const std::uint32_t end : {a, c}) {
      if (is_reflex_[end] && turn(previous_[end], end, next_[end]) > 0) is_reflex_[end] = 0;
    }
    --left;
    failures = 0;
    corner = next_[c];  // One further on, so that not all ears meet in one corner.
  }
  out[written] = {previous_[corner], corner, next_[corner]};
}

}  // namespace whittle::io
