#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

// Tests of proofs: points near a triangle, and faces over a triangle. A test with NaN must fail.

namespace whittle::verify {

/// Margin of each test. Lengths are about 1, so a computed length is wrong by 1e-15. The corner of a piece is wrong by
/// up to 3.1e-15: halving adds 5e-17, two thirds of which add up from one depth to the next.
inline constexpr double slack = 0.5e-14;
struct Vec {
  double x, y, z;
};
inline Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(double s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double norm_sq(const Vec& a) { return dot(a, a); }
inline double norm(const Vec& a) { return std::sqrt(dot(a, a)); }
inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The cross product in x and y: positive if b is to the left of a.
inline double cross_xy(const Vec& a, const Vec& b) { return a.x * b.y - a.y * b.x; }
using Corners = std::array<Vec, 3>;

inline double distance_sq_to_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec ab = b - a;
  const double length_sq = norm_sq(ab);
  const double t = length_sq > 0 ? std::clamp(dot(p - a, ab) / length_sq, 0.0, 1.0) : 0;
  return norm_sq(p - a - t * ab);
}

/// Whether some point of the face is that near. It looks at the point below p if that is inside, and at the sides.
inline bool is_near(const Vec& p, const Corners& face, double distance) {
  if (!(distance > 0)) return false;
  const double most = distance * distance;
  const auto& [a, b, c] = face;
  const Vec ab = b - a;
  const Vec ac = c - a;
  const Vec ap = p - a;
  // ac and p along ab and perpendicular to it: exact for thin faces, too.
  const double length_sq = norm_sq(ab);
  const double ac_along = dot(ac, ab) / length_sq;
  const double ap_along = dot(ap, ab) / length_sq;
  const Vec height = ac - ac_along * ab;
  const double to_c = dot(ap - ap_along * ab, height) / norm_sq(height);
  const double to_b = ap_along - to_c * ac_along;
  if (to_b >= 0 && to_c >= 0 && to_b + to_c <= 1 && norm_sq(ap - to_b * ab - to_c * ac) <= most) return true;
  return distance_sq_to_segment(p, a, b) <= most || distance_sq_to_segment(p, b, c) <= most ||
         distance_sq_to_segment(p, c, a) <= most;
}

/// A vertex as it is seen along a triangle's normal: z is the height over its plane.
struct Seen {
  unsigned outside;  ///< a bit for each side of the triangle: surely outside of that
  Vec at;
};

/// A triangle as it is seen along its normal, made a little smaller.
class View {
 public:
  /// \return why it can't, or null
  const char* look_at(const Corners& triangle) {
    const auto& [a, b, c] = triangle;
    const double ab = norm(b - a);
    const double bc = norm(c - b);
    const double ca = norm(a - c);
    origin_ = a;
    axes_[0] = (1 / ab) * (b - a);
    Vec height = c - a - dot(axes_[0], c - a) * axes_[0];
    height = height - dot(axes_[0], height) * axes_[0];  // again: of thin triangles rounding left some
    const double area = ab * norm(height);               // twice that, as in all that follows
    if (!(area > least_height * std::max({ab, bc, ca}))) return "it is too thin for a patch";
    axes_[1] = (1 / norm(height)) * height;
    axes_[2] = cross(axes_[0], axes_[1]);
    corners_ = {project(a), project(b), project(c)};
    const double perimeter = ab + bc + ca;
    const Vec center = (1 / perimeter) * (bc * corners_[0] + ca * corners_[1] + ab * corners_[2]);
    margin_ = 0;
    for (Vec& corner : corners_) {  // to the center of the inscribed circle, whose radius is area / perimeter
      const Vec move = inset * perimeter / area * (corner - center);
      corner = corner - move;
      margin_ = std::max(margin_, norm(move));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec way = corners_[(i + 1) % 3] - corners_[i];
      const Vec right{way.y, -way.x, 0};
      outward_[i] = (1 / norm(right)) * right;
    }
    const bool is_flat = std::abs(corners_[1].z) <= 2e-15 && std::abs(corners_[2].z) <= 2e-15;
    const bool is_left = cross_xy(corners_[1] - corners_[0], corners_[2] - corners_[0]) > 0.5 * area;
    return is_flat && is_left ? nullptr : "its normal is too inexact for a patch";
  }

  /// A point of the smaller triangle.
  Vec point(double to_b, double to_c) const {
    return corners_[0] + to_b * (corners_[1] - corners_[0]) + to_c * (corners_[2] - corners_[0]);
  }
  Seen see(const Vec& position) const {
    Seen seen{0, project(position)};
    for (unsigned i = 0; i < 3; ++i) seen.outside |= unsigned{beyond_side(i, seen.at) > slack} << i;
    return seen;
  }

  /// Whether a line surely parts the segment from the triangle: one along a side of the triangle, or along the segment.
  bool is_apart(const Seen& a, const Seen& b) const {
    if ((a.outside & b.outside) != 0) return true;
    if (a.outside == 0 || b.outside == 0) return false;
    const Vec way{b.at.x - a.at.x, b.at.y - a.at.y, 0};
    const auto left = [&](const Vec& corner) { return cross_xy(way, corner - a.at); };
    const auto [least, most] = std::minmax({left(corners_[0]), left(corners_[1]), left(corners_[2])});
    return least > slack * norm(way) || most < -slack * norm(way);
  }

  /// Whether each point of the triangle below or above a face is within the limit of it.
  bool is_within(const Corners& face, double limit) {
    const double most = limit - margin_ - 2 * slack;
    const auto is_low = [most](const Vec& p) { return std::abs(p.z) <= most; };
    if (std::all_of(face.begin(), face.end(), is_low)) return true;
    part_.assign(face.begin(), face.end());
    for (std::size_t side = 0; side < 3; ++side) clip_part(side);
    return std::all_of(part_.begin(), part_.end(), is_low);
  }

 private:
  static constexpr double least_height = 0.5e-10;
  static constexpr double inset = 4e-14;

  Vec project(const Vec& point) const {
    const Vec offset = point - origin_;
    return {dot(axes_[0], offset), dot(axes_[1], offset), dot(axes_[2], offset)};
  }
  double beyond_side(std::size_t side, const Vec& p) const {
    return outward_[side].x * (p.x - corners_[side].x) + outward_[side].y * (p.y - corners_[side].y);
  }
  /// Clips `part_` to the inside of a side, with a margin.
  void clip_part(std::size_t side) {
    whole_.swap(part_);
    part_.clear();
    for (std::size_t i = 0; i < whole_.size(); ++i) {
      const Vec& from = whole_[i];
      const Vec& to = whole_[i + 1 < whole_.size() ? i + 1 : 0];
      const double beyond_from = beyond_side(side, from) - 2 * slack;
      const double beyond_to = beyond_side(side, to) - 2 * slack;
      if (beyond_from <= 0) part_.push_back(from);
      if ((beyond_from <= 0) == (beyond_to <= 0)) continue;
      part_.push_back(from + beyond_from / (beyond_from - beyond_to) * (to - from));
    }
  }

  Vec origin_{};
  Corners axes_{};
  Corners corners_{};       ///< of the smaller triangle
  Corners outward_{};       ///< from each side, perpendicular to it, of length 1
  double margin_ = 0;       ///< each point of the triangle is so near to the smaller one
  std::vector<Vec> part_;   ///< of a face
  std::vector<Vec> whole_;  ///< the part before it was clipped
};

/// Whether a point is seen inside of a face; nothing if it is too near to a side to tell.
inline std::optional<bool> is_over(const Corners& face, const Vec& point) {
  constexpr double least_product = std::numeric_limits<double>::min();  // smaller ones are less exact
  int n_left = 0;
  int n_right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec way = face[(i + 1) % 3] - face[i];
    const Vec offset = point - face[i];
    const double left = cross_xy(way, offset);
    const double unsure = 1e-15 * (std::abs(way.x * offset.y) + std::abs(way.y * offset.x)) + least_product;
    n_left += int{left > unsure};
    n_right += int{left < -unsure};
  }
  if (n_left > 0 && n_right > 0) return false;
  return n_left == 3 || n_right == 3 ? std::optional(true) : std::nullopt;
}

}  // namespace whittle::verify
