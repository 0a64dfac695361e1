#include "certify/patch.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace whittle::metrics {
namespace {

/// Triangles that are thinner than this are seen too inexactly.
constexpr double least_height = 1e-10;

constexpr std::size_t most_faces = 1 << 16;

using Seen = Vec3;

double cross(const Seen& a, const Seen& b) { return a.x() * b.y() - a.y() * b.x(); }

/// 1 if the point is seen inside of the face, 0 if outside, nothing if it is too near to a side.
std::optional<int> count_over(const std::array<Seen, 3>& face, const Seen& point) {
  bool has_left = false;
  bool has_right = false;
  bool is_unsure = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Seen& from = face[i];
    const Seen way = face[(i + 1) % 3] - from;
    const double side = cross(way, point - from);
    const double unsure = slack * (std::abs(way.x()) + std::abs(way.y()) + std::abs(point.x() - from.x()) +
                                   std::abs(point.y() - from.y()));
    if (std::abs(side) <= unsure) is_unsure = true;
    has_left |= side > unsure;
    has_right |= side < -unsure;
  }
  if (has_left && has_right) return 0;
  if (is_unsure) return std::nullopt;
  return 1;
}

}  // namespace

bool NumberSet::insert(Index number) {
  if (2 * (taken_.size() + 1) > slots_.size()) grow();
  const std::size_t slot = slot_of(number);
  if (slots_[slot] == number) return false;
  slots_[slot] = number;
  taken_.push_back(slot);
  return true;
}

void NumberSet::clear() {
  for (const std::size_t slot : taken_) slots_[slot] = invalid_index;
  taken_.clear();
}

/// Where the number is, or is to go.
std::size_t NumberSet::slot_of(Index number) const {
  std::size_t slot = (number * std::uint64_t{0x9e3779b97f4a7c15U}) >> 32 & (slots_.size() - 1);
  while (slots_[slot] != number && slots_[slot] != invalid_index) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

void NumberSet::grow() {
  const std::vector<Index> before = std::exchange(slots_, std::vector<Index>(2 * slots_.size(), invalid_index));
  for (std::size_t& slot : taken_) {
    const Index number = before[slot];
    slot = slot_of(number);
    slots_[slot] = number;
  }
}

bool Patch::covers(const Corners& triangle, Index seed, double height) {
  if (!set_view(triangle)) return false;
  known_.clear();
  faces_.assign(1, seed);
  known_.insert(seed);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const Index f = faces_[i];
    const std::array<Seen, 3> face = seen(surface_.corners(f));
    if (is_apart(face)) continue;
    if (!is_within(face, height)) return false;
    for (std::size_t slot = 0; slot < 3; ++slot) {
      if (is_apart(face[slot], face[(slot + 1) % 3])) continue;
      const Index other = surface_.beyond(f, slot);
      if (other == invalid_index || faces_.size() == most_faces) return false;
      if (known_.insert(other)) faces_.push_back(other);
    }
  }
  return is_odd_somewhere();
}

/// \return whether the triangle is seen well enough
bool Patch::set_view(const Corners& triangle) {
  origin_ = triangle[0];
  const Vec3 ab = triangle[1] - triangle[0];
  const Vec3 ac = triangle[2] - triangle[0];
  const Vec3 normal = ab.cross(ac);
  const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
  const double length = normal.norm();
  if (!(length > least_height * longest)) return false;
  axes_[2] = normal / length;
  axes_[0] = ab.normalized();
  axes_[1] = axes_[2].cross(axes_[0]);
  triangle_ = seen(triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(triangle_[i].z()) > slack) return false;  // the normal is too inexact
    const Seen way = triangle_[(i + 1) % 3] - triangle_[i];
    sides_[i] = {triangle_[i], Seen(way.y(), -way.x(), 0).normalized()};
  }
  return true;
}

std::array<Patch::Seen, 3> Patch::seen(const Corners& corners) const {
  std::array<Seen, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 offset = corners[i] - origin_;
    result[i] = {axes_[0].dot(offset), axes_[1].dot(offset), axes_[2].dot(offset)};
  }
  return result;
}

/// Whether a face is surely not over the triangle: a line along one of the triangle's sides parts them.
bool Patch::is_apart(const std::array<Seen, 3>& face) const {
  return std::any_of(sides_.begin(), sides_.end(), [&](const Side& side) {
    return std::min({side.distance(face[0]), side.distance(face[1]), side.distance(face[2])}) > slack;
  });
}

/// Whether a segment is surely not over the triangle: a line along a side of the triangle, or along the segment, parts
/// them.
bool Patch::is_apart(const Seen& a, const Seen& b) const {
  for (const Side& side : sides_) {
    if (std::min(side.distance(a), side.distance(b)) > slack) return true;
  }
  const Seen way(b.x() - a.x(), b.y() - a.y(), 0);
  const double length = way.norm();
  if (!(length > 0)) return false;
  const std::array<double, 3> sides{cross(way, triangle_[0] - a), cross(way, triangle_[1] - a),
                                    cross(way, triangle_[2] - a)};
  const auto [low, high] = std::minmax_element(sides.begin(), sides.end());
  return *low > slack * length || *high < -slack * length;
}

/// Whether the part of a face over the triangle is surely not higher, nor lower, than `height`.
bool Patch::is_within(const std::array<Seen, 3>& face, double height) const {
  const double most = height - 2 * slack;  // the triangle itself may be a slack off its plane
  const auto is_low = [most](const Seen& p) { return std::abs(p.z()) <= most; };
  if (std::all_of(face.begin(), face.end(), is_low)) return true;
  std::vector<Seen> part(face.begin(), face.end());
  for (const Side& side : sides_) {
    std::vector<Seen> inside;
    const auto beyond = [&side](const Seen& p) { return side.distance(p) - 2 * slack; };
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Seen& from = part[k];
      const Seen& to = part[(k + 1) % part.size()];
      const double out_from = beyond(from);
      const double out_to = beyond(to);
      if (out_from <= 0) inside.push_back(from);
      if ((out_from <= 0) != (out_to <= 0)) inside.push_back(from + out_from / (out_from - out_to) * (to - from));
    }
    part = std::move(inside);
  }
  return std::all_of(part.begin(), part.end(), is_low);
}

/// Whether an odd number of the faces lies over some point of the triangle.
bool Patch::is_odd_somewhere() const {
  constexpr std::array<std::array<double, 2>, 4> weights{
      {{0.31, 0.36}, {0.23, 0.52}, {0.57, 0.19}, {0.12, 0.17}}};  // in general position
  for (const auto& [second, third] : weights) {
    const Seen point = triangle_[0] + second * (triangle_[1] - triangle_[0]) + third * (triangle_[2] - triangle_[0]);
    int n = 0;
    bool is_sure = true;
    for (const Index f : faces_) {
      const std::optional<int> over = count_over(seen(surface_.corners(f)), point);
      is_sure &= over.has_value();
      n += over.value_or(0);
    }
    if (is_sure) return n % 2 == 1;
  }
  return false;
}

}  // namespace whittle::metrics
