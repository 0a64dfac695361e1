#include "foot_finder.hh"

#include <algorithm>
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

Foot FootFinder::walk(const Sample& sample) const {
  const NearestPoint nearest = walk_to_nearest({faces_, corners_, positions_}, sample, least_agreement);
  if (nearest.corner == nullptr) return {};
  const Triangle& face = faces_[nearest.corner->face];
  const Vec3& a = positions_[face[0]];
  const Vec3 normal = (positions_[face[1]] - a).cross(positions_[face[2]] - a).normalized();
  return foot(*nearest.corner, nearest.next, nearest.last, normal.dot(sample.position - a));
}

}  // namespace whittle
