#include "original/closest_point_finder.hh"

#include <algorithm>
#include <cmath>

#include "whittle/core/detail/lanes.hh"

namespace whittle::polishing {

using detail::EightFloats;
using detail::Float8;
using detail::Int8;
namespace {

constexpr float least_normal_agreement = 0.5;  ///< cosine between the normals of a point and of its face
constexpr float inside_slack = 1e-4F;          ///< tolerance of the test for inside, in barycentric coordinates
constexpr std::int32_t nowhere = 0x7fffffff;

WHITTLE_INLINE Float8 dot(const std::array<EightFloats, 3>& lanes, const Eigen::Vector3f& v) {
  return detail::load(lanes[0]) * v.x() + detail::load(lanes[1]) * v.y() + detail::load(lanes[2]) * v.z();
}

/// The least of eight lanes.
WHITTLE_INLINE std::int32_t least(Int8 x) {
  const auto min = [](const Int8& a, const Int8& b) WHITTLE_INLINE_LAMBDA { return select_lanes(a < b, a, b); };
  x = min(x, shuffled<4, 5, 6, 7, 0, 1, 2, 3>(x, x));
  x = min(x, shuffled<2, 3, 0, 1, 6, 7, 4, 5>(x, x));
  x = min(x, shuffled<1, 0, 3, 2, 5, 4, 7, 6>(x, x));
  return x[0];
}

/// \param number of the corner at its vertex \param next, last barycentric coordinates of the two corners after this
/// one
WHITTLE_INLINE ClosestFacePoint closest_point(const Corner& corner, std::size_t number, float next, float last,
                                              float distance) {
  const std::array<float, 3> weights{1 - next - last, next, last};  // of the corners from this one on
  constexpr std::array<std::size_t, 3> second{1, 0, 2};
  constexpr std::array<std::size_t, 3> third{2, 1, 0};
  return {corner.face, static_cast<Index>(number), weights[second[corner.slot]], weights[third[corner.slot]], distance};
}

}  // namespace

/// The search in eight faces at a time, compiled for registers of either width.
class ClosestPointFinder::Lanes {
 public:
  WHITTLE_INLINE static void find(const ClosestPointFinder& finder, Index v, std::span<const Point> points,
                                  std::span<ClosestFacePoint> closest_points) {
    for (std::size_t i = 0; i < points.size(); ++i) closest_points[i] = find(finder, v, points[i]);
  }
  WHITTLE_AVX2 static void find_in_wide_registers(const ClosestPointFinder& finder, Index v,
                                                  std::span<const Point> points,
                                                  std::span<ClosestFacePoint> closest_points) {
    find(finder, v, points, closest_points);
  }

 private:
  WHITTLE_INLINE static ClosestFacePoint find(const ClosestPointFinder& finder, Index v, const Point& point) {
    const Eigen::Vector3f offset = (point.position - finder.mesh_.positions[v]).cast<float>();
    const float least_along = least_normal_agreement * std::sqrt(length_sq(point.normal));
    std::int32_t nearest = nowhere;
    ClosestFacePoint found = no_closest_point;
    for (std::size_t i = 0; i < finder.octets_.size(); ++i) {
      const Octet& octet = finder.octets_[i];
      const Float8 next = dot(octet.next, offset);
      const Float8 last = dot(octet.last, offset);
      const Float8 first = 1.0F - next - last;
      const Float8 distance = dot(octet.normal, offset);
      const auto holds = (first >= -inside_slack) & (next >= -inside_slack) & (last >= -inside_slack) &
                         (dot(octet.normal, point.normal) > least_along);
      // The bits of a float without its sign are ordered as its values. The last three are replaced by the lane.
      const Int8 key = (load_lanes<Int8>(&distance) & 0x7ffffff8) | Int8{0, 1, 2, 3, 4, 5, 6, 7};
      const std::int32_t here = least((holds & key) | (~holds & nowhere));
      if (here >= nearest) continue;
      nearest = here;
      const auto lane = static_cast<std::size_t>(here & 7);
      const std::size_t corner = 8 * i + lane;
      found = closest_point(finder.mesh_.corners.of(v)[corner], corner, next[lane], last[lane], distance[lane]);
    }
    return found;
  }
};

void ClosestPointFinder::fill_octets(Index v) {
  const auto& [faces, vertex_corners, positions] = mesh_;
  const std::span<const Corner> corners = vertex_corners.of(v);
  octets_.assign((corners.size() + 7) / 8, {});
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [f, slot] = corners[i];
    const Vec3 next = positions[corner_after(faces[f], slot, 1)] - positions[v];
    const Vec3 last = positions[corner_after(faces[f], slot, 2)] - positions[v];
    const Vec3 normal = next.cross(last);
    const double square = normal.squaredNorm();
    if (!(square > 0)) continue;
    Octet& octet = octets_[i / 8];
    const auto store = [i](std::array<EightFloats, 3>& lanes, const Vec3& x) {
      for (std::size_t axis = 0; axis < 3; ++axis) lanes[axis][i % 8] = static_cast<float>(x[Eigen::Index(axis)]);
    };
    store(octet.normal, normal / std::sqrt(square));
    store(octet.next, last.cross(normal) / square);
    store(octet.last, normal.cross(next) / square);
  }
}

void ClosestPointFinder::find(Index v, std::span<const Point> points, std::span<ClosestFacePoint> closest_points) {
  if (points.empty()) return;
  fill_octets(v);
  has_double4 ? Lanes::find_in_wide_registers(*this, v, points, closest_points)
              : Lanes::find(*this, v, points, closest_points);
}

}  // namespace whittle::polishing
