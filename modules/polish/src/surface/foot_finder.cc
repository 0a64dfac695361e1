#include "surface/foot_finder.hh"

#include <algorithm>
#include <cmath>

#include "whittle/core/detail/compiler.hh"
#include "whittle/core/detail/lanes.hh"

namespace whittle::polishing {
namespace {

constexpr float least_normal_agreement = 0.5;  ///< cosine between the normals of a point and of its face
constexpr float inside_slack = 1e-4F;          ///< how far outside a face is still inside, in barycentric coordinates
constexpr std::int32_t nowhere = 0x7fffffff;

WHITTLE_INLINE Float8 dot(const std::array<EightFloats, 3>& lanes, const Eigen::Vector3f& v) {
  return load(lanes[0]) * v.x() + load(lanes[1]) * v.y() + load(lanes[2]) * v.z();
}

/// The least of eight lanes.
WHITTLE_INLINE std::int32_t least(Int8 x) {
  const auto min = [](const Int8& a, const Int8& b) WHITTLE_INLINE_LAMBDA { return select_lanes(a < b, a, b); };
  x = min(x, shuffled<4, 5, 6, 7, 0, 1, 2, 3>(x, x));
  x = min(x, shuffled<2, 3, 0, 1, 6, 7, 4, 5>(x, x));
  x = min(x, shuffled<1, 0, 3, 2, 5, 4, 7, 6>(x, x));
  return x[0];
}

/// \param next, last barycentric coordinates of the two corners after this one
Foot foot(const Corner& corner, float next, float last, float distance) {
  const std::array<float, 3> weights{1 - next - last, next, last};  // of the corners from this one on
  constexpr std::array<std::size_t, 3> second{1, 0, 2};
  constexpr std::array<std::size_t, 3> third{2, 1, 0};
  return {corner.face, weights[second[corner.slot]], weights[third[corner.slot]], distance};
}

}  // namespace

/// The search in eight faces at a time, compiled for registers of either width.
class FootFinder::Lanes {
 public:
  WHITTLE_INLINE static void find(const FootFinder& finder, std::span<const Query> queries, std::span<Foot> feet) {
    constexpr std::size_t ahead = 8;  // some hundred nanoseconds
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (i + ahead < queries.size()) finder.prefetch(queries[i + ahead].start);
      feet[i] = queries[i].start == invalid_index ? no_foot : find(finder, queries[i]);
    }
  }
  WHITTLE_AVX2 static void find_in_wide_registers(const FootFinder& finder, std::span<const Query> queries,
                                                  std::span<Foot> feet) {
    find(finder, queries, feet);
  }

 private:
  WHITTLE_INLINE static Foot find(const FootFinder& finder, const Query& query) {
    const Index v = query.start;
    const Eigen::Vector3f offset = (query.position - finder.positions_[v]).cast<float>();
    const float least_along = least_normal_agreement * std::sqrt(length_sq(query.normal));
    std::int32_t nearest = nowhere;
    Foot found = no_foot;
    for (Index i = finder.first_octet_[v]; i < finder.first_octet_[v + 1]; ++i) {
      const Octet& octet = finder.octets_[i];
      const Float8 next = dot(octet.next, offset);
      const Float8 last = dot(octet.last, offset);
      const Float8 first = 1.0F - next - last;
      const Float8 distance = dot(octet.normal, offset);
      const auto holds = (first >= -inside_slack) & (next >= -inside_slack) & (last >= -inside_slack) &
                         (dot(octet.normal, query.normal) > least_along);
      // The bits of a float without its sign are ordered as its values. The last three are replaced by the lane.
      const Int8 key = (load_lanes<Int8>(&distance) & 0x7ffffff8) | Int8{0, 1, 2, 3, 4, 5, 6, 7};
      const std::int32_t here = least((holds & key) | (~holds & nowhere));
      if (here >= nearest) continue;
      nearest = here;
      const auto lane = static_cast<std::size_t>(here & 7);
      const Corner& corner = finder.corners_.of(v)[8 * (i - finder.first_octet_[v]) + lane];
      found = foot(corner, next[lane], last[lane], distance[lane]);
    }
    return found;
  }
};

FootFinder::FootFinder(const std::vector<Triangle>& faces, const VertexCorners& corners)
    : faces_(faces), corners_(corners), first_octet_(corners.size() + 1) {
  for (Index v = 0; v < corners.size(); ++v) {
    first_octet_[v + 1] = first_octet_[v] + static_cast<Index>((corners.of(v).size() + 7) / 8);
  }
  octets_.resize(first_octet_.back());
}

void FootFinder::look_at(std::span<const Vec3> positions, const detail::Workers& workers) {
  positions_ = positions;
  for_each_range(positions.size(), workers, [this](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) fill_octets(v);
  });
}

void FootFinder::fill_octets(Index v) {
  std::fill(octets_.begin() + first_octet_[v], octets_.begin() + first_octet_[v + 1], Octet{});
  const std::span<const Corner> corners = corners_.of(v);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [f, slot] = corners[i];
    const Vec3 next = positions_[corner_after(faces_[f], slot, 1)] - positions_[v];
    const Vec3 last = positions_[corner_after(faces_[f], slot, 2)] - positions_[v];
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

void FootFinder::prefetch(Index start) const {
  if (start == invalid_index) return;
  const auto* octet = reinterpret_cast<const char*>(&octets_[first_octet_[start]]);
  for (std::size_t i = 0; i < sizeof(Octet); i += 64) prefetch_line(octet + i);
  prefetch_line(corners_.of(start).data());
}

void FootFinder::find(std::span<const Query> queries, std::span<Foot> feet) const {
  has_double4 ? Lanes::find_in_wide_registers(*this, queries, feet) : Lanes::find(*this, queries, feet);
}

}  // namespace whittle::polishing
