#include "whittle/core/geometry/proof/patch.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace whittle {
namespace {

/// Triangles that are thinner than this are seen too inexactly.
constexpr double least_height = 1e-10;

constexpr std::size_t most_faces = 1 << 16;

using Seen = Vec3;

double cross(const Seen& a, const Seen& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether the point is surely beside the box around a face.
bool is_beside(const Seen& a, const Seen& b, const Seen& c, const Seen& point) {
  constexpr double spare = 4 * distance_slack;
  return std::max({a.x(), b.x(), c.x()}) < point.x() - spare || std::min({a.x(), b.x(), c.x()}) > point.x() + spare ||
         std::max({a.y(), b.y(), c.y()}) < point.y() - spare || std::min({a.y(), b.y(), c.y()}) > point.y() + spare;
}

/// 1 if the point is seen inside of the face, 0 if outside, nothing if it is too near to a side.
std::optional<int> count_over(const Seen& a, const Seen& b, const Seen& c, const Seen& point) {
  const std::array<const Seen*, 4> around{&a, &b, &c, &a};
  bool has_left = false;
  bool has_right = false;
  bool is_unsure = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Seen& from = *around[i];
    const Seen way = *around[i + 1] - from;
    const double side = cross(way, point - from);
    const double unsure = distance_slack * (std::abs(way.x()) + std::abs(way.y()) + std::abs(point.x() - from.x()) +
                                            std::abs(point.y() - from.y()));
    if (std::abs(side) <= unsure) is_unsure = true;
    has_left |= side > unsure;
    has_right |= side < -unsure;
  }
  if (has_left && has_right) return 0;
  if (is_unsure) return std::nullopt;
  return 1;
}

/// A convex polygon, but for rounding, with room for the corners that clipping a triangle at three lines may give it.
struct Polygon {
  std::array<Seen, 12> corners;
  std::size_t size;

  /// The part where `beyond` is not positive.
  template <class Beyond>
  Polygon clipped(const Beyond& beyond) const {
    Polygon part{{}, 0};
    for (std::size_t k = 0; k < size; ++k) {
      const Seen& from = corners[k];
      const Seen& to = corners[k + 1 < size ? k + 1 : 0];
      const double out_from = beyond(from);
      const double out_to = beyond(to);
      if (out_from <= 0) part.corners[part.size++] = from;
      if ((out_from <= 0) != (out_to <= 0)) {
        part.corners[part.size++] = from + out_from / (out_from - out_to) * (to - from);
      }
    }
    return part;
  }
};

}  // namespace

void NumberSet::clear() {
  size_ = 0;
  if (++turn_ == 0) {
    slots_.assign(slots_.size(), {});
    turn_ = 1;
  }
}

void NumberSet::grow() {
  const std::vector<Slot> before = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
  for (const Slot& slot : before) {
    if (slot.turn == turn_) slot_of(slot.number) = slot;
  }
}

Index Patch::look_from(const LinkedFaces& surface, const Corners& triangle, Index from) {
  surface_ = surface;
  obstacle_.reset();
  seed_ = set_view(triangle) ? face_over_center(from) : invalid_index;
  return seed_;
}

bool Patch::covers(double height) {
  height -= margin_;
  known_.clear();
  over_.clear();
  faces_over_.clear();
  faces_.assign(1, seed_);
  known_.insert(seed_);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Index f = faces_[i];
    const SeenFace face = corners(f);
    if ((seen_[face[0]].outside & seen_[face[1]].outside & seen_[face[2]].outside) != 0) continue;
    if (!is_within(f, face, height)) return false;
    over_.push_back(face);
    faces_over_.push_back(f);
    for (std::size_t slot = 0; slot < 3; ++slot) {
      if (is_apart(seen_[face[slot]], seen_[face[(slot + 1) % 3]])) continue;
      const Index other = surface_.beyond[f][slot];
      if (other == invalid_index || faces_.size() == most_faces) return false;
      if (known_.insert(other)) faces_.push_back(other);
    }
  }
  return is_odd_somewhere();
}

Index Patch::face_over_center(Index face) {
  constexpr int most_steps = 64;
  const Seen center = (triangle_[0] + triangle_[1] + triangle_[2]) / 3;
  Index before = invalid_index;
  for (int step = 0; step < most_steps; ++step) {
    const SeenFace corners = this->corners(face);
    const std::array<Seen, 3> at{seen_[corners[0]].at, seen_[corners[1]].at, seen_[corners[2]].at};
    const double area = cross(at[1] - at[0], at[2] - at[0]);
    Index next = invalid_index;
    for (std::size_t slot = 0; slot < 3 && next == invalid_index; ++slot) {
      const double side = cross(at[(slot + 1) % 3] - at[slot], center - at[slot]);
      const Index beyond = surface_.beyond[face][slot];
      if (side * area < 0 && beyond != before) next = beyond;
    }
    if (next == invalid_index) return face;
    before = std::exchange(face, next);
  }
  return face;
}

/// \return whether the triangle is seen well enough
bool Patch::set_view(const Corners& triangle) {
  if (++turn_ == 0) cache_.assign(cache_size, {});
  seen_.clear();
  origin_ = triangle[0];
  const Vec3 ab = triangle[1] - triangle[0];
  const Vec3 ac = triangle[2] - triangle[0];
  const Vec3 normal = ab.cross(ac);
  const double longest = std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()}));
  const double length = normal.norm();
  if (!(length > least_height * longest)) return false;
  axes_[2] = normal / length;
  axes_[0] = ab.normalized();
  axes_[1] = axes_[2].cross(axes_[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    triangle_[i] = seen(triangle[i]);
    if (std::abs(triangle_[i].z()) > distance_slack) return false;  // the normal is too inexact
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Seen way = triangle_[(i + 1) % 3] - triangle_[i];
    sides_[i] = {triangle_[i], Seen(way.y(), -way.x(), 0).normalized()};
  }
  shrink();
  return true;
}

/// Moves the corners a little towards the center of the inscribed circle, and so the sides inward. Then faces that
/// share a side with the triangle are apart from it. Each point of the original triangle is within `margin_` of the
/// shrunk one. (Not along the sides' normals: the normals of a needle cancel out.)
void Patch::shrink() {
  constexpr double inset = 4 * distance_slack;
  const std::array<double, 3> opposite{(triangle_[2] - triangle_[1]).norm(), (triangle_[0] - triangle_[2]).norm(),
                                       (triangle_[1] - triangle_[0]).norm()};
  const double perimeter = opposite[0] + opposite[1] + opposite[2];
  const double twice_area = cross(triangle_[1] - triangle_[0], triangle_[2] - triangle_[0]);
  const Seen center =
      (opposite[0] * triangle_[0] + opposite[1] * triangle_[1] + opposite[2] * triangle_[2]) / perimeter;
  margin_ = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Seen move = inset * perimeter / twice_area * (triangle_[i] - center);
    triangle_[i] -= move;
    margin_ = std::max(margin_, move.norm());
  }
  for (std::size_t i = 0; i < 3; ++i) sides_[i].from = triangle_[i];
}

Patch::Seen Patch::seen(const Vec3& point) const {
  const Vec3 offset = point - origin_;
  return {axes_[0].dot(offset), axes_[1].dot(offset), axes_[2].dot(offset)};
}

Index Patch::see(Index vertex) {
  CacheSlot& slot = cache_[vertex % cache_size];
  slot = {vertex, turn_, static_cast<Index>(seen_.size())};
  const Seen at = seen(surface_.positions[vertex]);
  unsigned outside = 0;
  for (unsigned side = 0; side < 3; ++side) {
    outside |= static_cast<unsigned>(sides_[side].distance(at) > distance_slack) << side;
  }
  seen_.push_back({at, outside});
  return slot.seen;
}

/// Whether a segment is surely not over the triangle: a line along a side of the triangle, or along the segment, parts
/// them.
bool Patch::is_apart(const SeenCorner& a, const SeenCorner& b) const {
  if ((a.outside & b.outside) != 0) return true;
  if (a.outside == 0 || b.outside == 0) return false;
  const Seen way(b.at.x() - a.at.x(), b.at.y() - a.at.y(), 0);
  const double length = way.norm();
  if (!(length > 0)) return false;
  const std::array<double, 3> sides{cross(way, triangle_[0] - a.at), cross(way, triangle_[1] - a.at),
                                    cross(way, triangle_[2] - a.at)};
  const auto [low, high] = std::minmax({sides[0], sides[1], sides[2]});
  return low > distance_slack * length || high < -distance_slack * length;
}

/// Whether the part of a face over the triangle is surely not higher, nor lower, than `height`.
bool Patch::is_within(Index face, const SeenFace& corners, double height) {
  const double most =
      height - surface_.offset(face) - 2 * distance_slack;  // the triangle itself may be a distance_slack off its plane
  const auto is_low = [&](Index corner) { return std::abs(seen_[corner].at.z()) <= most; };
  return (is_low(corners[0]) && is_low(corners[1]) && is_low(corners[2])) || is_part_within(face, corners, most);
}

/// The same by the part of the face alone.
bool Patch::is_part_within(Index face, const SeenFace& corners, double most) {
  Polygon part{{seen_[corners[0]].at, seen_[corners[1]].at, seen_[corners[2]].at}, 3};
  for (const Side& side : sides_) {
    part = part.clipped([&side](const Seen& p) { return side.distance(p) - 2 * distance_slack; });
  }
  const auto end = part.corners.begin() + part.size;
  const auto highest = std::max_element(part.corners.begin(), end,
                                        [](const Seen& p, const Seen& q) { return std::abs(p.z()) < std::abs(q.z()); });
  if (highest == end || std::abs(highest->z()) <= most) return true;
  obstacle_ = {face, origin_ + highest->x() * axes_[0] + highest->y() * axes_[1]};
  return false;
}

/// Whether an odd number of the faces lies over some point of the triangle.
bool Patch::is_odd_somewhere() const {
  constexpr std::array<std::array<double, 2>, 4> weights{
      {{0.31, 0.36}, {0.23, 0.52}, {0.57, 0.19}, {0.12, 0.17}}};  // in general position
  for (const auto& [second, third] : weights) {
    const Seen point = triangle_[0] + second * (triangle_[1] - triangle_[0]) + third * (triangle_[2] - triangle_[0]);
    int n = 0;
    bool is_sure = true;
    for (const auto& [a, b, c] : over_) {
      const Seen& at_a = seen_[a].at;
      const Seen& at_b = seen_[b].at;
      const Seen& at_c = seen_[c].at;
      if (is_beside(at_a, at_b, at_c, point)) continue;
      const std::optional<int> count = count_over(at_a, at_b, at_c, point);
      is_sure &= count.has_value();
      n += count.value_or(0);
    }
    if (is_sure) return n % 2 == 1;
  }
  return false;
}

}  // namespace whittle
