#include "foot_finder.hh"

#include <algorithm>
#include <bit>
#include <cstring>

#include "whittle/engine/lanes.hh"
#include "whittle/engine/parallel.hh"

namespace whittle {
namespace {

using Float8 = float __attribute__((vector_size(32)));
using Int8 = std::int32_t __attribute__((vector_size(32)));

constexpr float least_agreement = 0.5;  ///< cosine between the normals of a point and of its face
constexpr float inside_slack = 1e-4F;   ///< how far outside a face is still inside, in barycentric coordinates
constexpr std::int32_t nowhere = 0x7fffffff;
constexpr std::size_t most_steps = 16;

[[gnu::always_inline]] inline Float8 load(const std::array<float, 8>& from) {
  Float8 lanes;
  std::memcpy(&lanes, from.data(), sizeof(lanes));
  return lanes;
}
[[gnu::always_inline]] inline Float8 dot(const std::array<std::array<float, 8>, 3>& lanes, const Eigen::Vector3f& v) {
  return load(lanes[0]) * v.x() + load(lanes[1]) * v.y() + load(lanes[2]) * v.z();
}

/// The least of eight, in all of them.
[[gnu::always_inline]] inline std::int32_t least(Int8 x) {
  const auto min = [](const Int8& a, const Int8& b) __attribute__((always_inline)) { return a < b ? a : b; };
  x = min(x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
  x = min(x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5));
  x = min(x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6));
  return x[0];
}

Foot foot(const Corner& corner, double next, double last, double distance) {
  const std::array<double, 3> weights{1 - next - last, next, last};  // of the corners from this one on
  return {corner.face, static_cast<float>(weights[(1 + 3 - corner.place) % 3]),
          static_cast<float>(weights[(2 + 3 - corner.place) % 3]), static_cast<float>(distance)};
}

/// Barycentric coordinates.
struct Place {
  double second, third;
};

/// The point of the triangle nearest to the origin. \cite ericson_2005_collision (section 5.1.5)
Place nearest_to_origin(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = -ab.dot(a);
  const double d2 = -ac.dot(a);
  if (d1 <= 0 && d2 <= 0) return {0, 0};
  const double d3 = -ab.dot(b);
  const double d4 = -ac.dot(b);
  if (d3 >= 0 && d4 <= d3) return {1, 0};
  const double over_c = d1 * d4 - d3 * d2;
  if (over_c <= 0 && d1 >= 0 && d3 <= 0) return {d1 / (d1 - d3), 0};
  const double d5 = -ab.dot(c);
  const double d6 = -ac.dot(c);
  if (d6 >= 0 && d5 <= d6) return {0, 1};
  const double over_b = d5 * d2 - d1 * d6;
  if (over_b <= 0 && d2 >= 0 && d6 <= 0) return {0, d2 / (d2 - d6)};
  const double over_a = d3 * d6 - d5 * d4;
  if (over_a <= 0 && d4 >= d3 && d5 >= d6) {
    const double third = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {1 - third, third};
  }
  const double sum = over_a + over_b + over_c;
  return {over_b / sum, over_c / sum};
}

}  // namespace

/// What the search in eight faces at a time does, for registers of any width.
class FootFinder::Lanes {
 public:
  [[gnu::always_inline]] static Foot find(const FootFinder& finder, const Sample& sample) {
    const Index v = sample.start;
    const Eigen::Vector3f offset = (sample.position - finder.positions_[v]).cast<float>();
    const Eigen::Vector3f normal = sample.normal.cast<float>();
    std::int32_t nearest = nowhere;
    Index nearest_octet = 0;
    for (Index i = finder.first_octet_[v]; i < finder.first_octet_[v + 1]; ++i) {
      const std::int32_t found = look(finder.octets_[i], offset, normal);
      if (found >= nearest) continue;
      nearest = found;
      nearest_octet = i;
    }
    if (nearest == nowhere) return {};
    const Octet& octet = finder.octets_[nearest_octet];
    const auto lane = static_cast<std::size_t>(nearest & 7);
    const auto along = [&](const std::array<EightFloats, 3>& lanes) {
      return lanes[0][lane] * offset.x() + lanes[1][lane] * offset.y() + lanes[2][lane] * offset.z();
    };
    const std::size_t place = 8 * (nearest_octet - finder.first_octet_[v]) + lane;
    return foot(finder.corners_.of(v)[place], along(octet.next), along(octet.last), along(octet.normal));
  }
  WHITTLE_DOUBLE4 static Foot find_in_wide_registers(const FootFinder& finder, const Sample& sample) {
    return find(finder, sample);
  }

 private:
  /// The bits of the distance from the nearest face that holds the foot, which are in order, its number the last three.
  [[gnu::always_inline]] static std::int32_t look(const Octet& octet, const Eigen::Vector3f& offset,
                                                  const Eigen::Vector3f& normal) {
    const Float8 next = dot(octet.next, offset);
    const Float8 last = dot(octet.last, offset);
    const Float8 first = 1.0F - next - last;
    const Float8 distance = dot(octet.normal, offset);
    const auto holds = (first >= -inside_slack) & (next >= -inside_slack) & (last >= -inside_slack) &
                       (dot(octet.normal, normal) > least_agreement);
    const Int8 size = reinterpret_cast<Int8>(distance) & 0x7ffffff8;
    const Int8 key = size | Int8{0, 1, 2, 3, 4, 5, 6, 7};
    return least((holds & key) | (~holds & nowhere));
  }
};

FootFinder::FootFinder(const std::vector<Triangle>& faces, const VertexCorners& corners)
    : faces_(faces), corners_(corners), first_octet_(corners.n_vertices() + 1) {
  for (Index v = 0; v < corners.n_vertices(); ++v) {
    first_octet_[v + 1] = first_octet_[v] + static_cast<Index>((corners.of(v).size() + 7) / 8);
  }
  octets_.resize(first_octet_.back());
}

void FootFinder::look_at(std::span<const Vec3> positions, unsigned threads) {
  positions_ = positions;
  for_each_range(positions.size(), threads, [this](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) fill_octets(v);
  });
}

void FootFinder::fill_octets(Index v) {
  std::fill(octets_.begin() + first_octet_[v], octets_.begin() + first_octet_[v + 1], Octet{});
  const std::span<const Corner> corners = corners_.of(v);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [f, place] = corners[i];
    const Vec3 next = positions_[corner_after(faces_[f], place, 1)] - positions_[v];
    const Vec3 last = positions_[corner_after(faces_[f], place, 2)] - positions_[v];
    const Vec3 normal = next.cross(last);
    const double square = normal.squaredNorm();
    if (!(square > 0)) continue;
    Octet& octet = octets_[first_octet_[v] + i / 8];
    const auto store = [i](std::array<EightFloats, 3>& lanes, const Vec3& x) {
      for (std::size_t axis = 0; axis < 3; ++axis) lanes[axis][i % 8] = static_cast<float>(x[Eigen::Index(axis)]);
    };
    store(octet.normal, normal / std::sqrt(square));
    store(octet.next, last.cross(normal) / square);
    store(octet.last, normal.cross(next) / square);
  }
}

Foot FootFinder::find(const Sample& sample) const {
  const Foot found = has_double4 ? Lanes::find_in_wide_registers(*this, sample) : Lanes::find(*this, sample);
  return found.face != invalid_index ? found : walk(sample);
}

/// From the nearest face so far to the faces at that corner of it which has most of the foot and was not looked at yet.
Foot FootFinder::walk(const Sample& sample) const {
  std::array<Index, most_steps> seen;
  std::size_t n_seen = 0;
  double least_sq = std::numeric_limits<double>::infinity();
  const Corner* nearest = nullptr;
  Place place{};
  double distance = 0;
  for (Index v = sample.start; v != invalid_index && n_seen < most_steps;) {
    seen[n_seen++] = v;
    const Vec3 a = positions_[v] - sample.position;
    for (const Corner& corner : corners_.of(v)) {
      const Vec3 b = positions_[corner_after(faces_[corner.face], corner.place, 1)] - sample.position;
      const Vec3 c = positions_[corner_after(faces_[corner.face], corner.place, 2)] - sample.position;
      const Vec3 normal = (b - a).cross(c - a);
      const double length = normal.norm();
      if (!(normal.dot(sample.normal) > least_agreement * length)) continue;
      const Place at = nearest_to_origin(a, b, c);
      const double sq = (a + at.second * (b - a) + at.third * (c - a)).squaredNorm();
      if (!(sq < least_sq)) continue;
      least_sq = sq;
      nearest = &corner;
      place = at;
      distance = -a.dot(normal) / length;
    }
    v = invalid_index;
    if (nearest == nullptr) break;
    const std::array<double, 3> weights{1 - place.second - place.third, place.second, place.third};
    double most = 0;
    for (Index i = 0; i < 3; ++i) {
      const Index u = corner_after(faces_[nearest->face], nearest->place, i);
      if (!(weights[i] > most) || std::find(seen.begin(), seen.begin() + n_seen, u) != seen.begin() + n_seen) continue;
      most = weights[i];
      v = u;
    }
  }
  return nearest == nullptr ? Foot{} : foot(*nearest, place.second, place.third, distance);
}

}  // namespace whittle
