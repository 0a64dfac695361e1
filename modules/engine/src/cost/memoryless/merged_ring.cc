#include "whittle/engine/formula/merged_ring.hh"

#include <algorithm>
#include <cstring>
#include <limits>

#include "whittle/core/geometry/nearest_on_triangle.hh"

namespace whittle {
namespace {

using Four = std::array<double, 4>;
WHITTLE_INLINE Double4 load(const Four& from) { return load_lanes<Double4>(from.data()); }
WHITTLE_INLINE PointLanes<Double4> load(const std::array<Four, 3>& from) {
  return {load(from[0]), load(from[1]), load(from[2])};
}
WHITTLE_INLINE void store(const Double4& lanes, Four& to) { std::memcpy(&to, &lanes, sizeof(lanes)); }
WHITTLE_INLINE void store(const PointLanes<Double4>& lanes, std::array<Four, 3>& to) {
  store(lanes.x, to[0]);
  store(lanes.y, to[1]);
  store(lanes.z, to[2]);
}

WHITTLE_INLINE double sum(const Double4& x) { return (x[0] + x[1]) + (x[2] + x[3]); }

WHITTLE_INLINE PointLanes<Double4> everywhere(const Vec3& p) {
  return {Double4{} + p.x(), Double4{} + p.y(), Double4{} + p.z()};
}

/// To four times eight doubles: xx, xy, xz, yy, yz, zz and two zeros of each.
WHITTLE_INLINE void store_transposed(const SymmetricLanes<Double4>& m, double* to) {
  const Double4 low01 = shuffled<0, 4, 2, 6>(m.xx, m.xy);
  const Double4 high01 = shuffled<1, 5, 3, 7>(m.xx, m.xy);
  const Double4 low23 = shuffled<0, 4, 2, 6>(m.xz, m.yy);
  const Double4 high23 = shuffled<1, 5, 3, 7>(m.xz, m.yy);
  const Double4 low45 = shuffled<0, 4, 2, 6>(m.yz, m.zz);
  const Double4 high45 = shuffled<1, 5, 3, 7>(m.yz, m.zz);
  const Double4 zero{};
  const std::array<Double4, 8> rows{shuffled<0, 1, 4, 5>(low01, low23),   shuffled<0, 1, 4, 5>(low45, zero),
                                    shuffled<0, 1, 4, 5>(high01, high23), shuffled<0, 1, 4, 5>(high45, zero),
                                    shuffled<2, 3, 6, 7>(low01, low23),   shuffled<2, 3, 6, 7>(low45, zero),
                                    shuffled<2, 3, 6, 7>(high01, high23), shuffled<2, 3, 6, 7>(high45, zero)};
  std::memcpy(to, rows.data(), sizeof(rows));
}

}  // namespace

/// What is done with four faces at a time.
struct MergedRing::Kernels {
  MergedRing& ring;

  WHITTLE_INLINE PointLanes<Double4> neighbours_from(std::size_t i) const {
    const auto& [x, y, z] = ring.neighbours_;
    return {load_lanes<Double4>(&x[i]), load_lanes<Double4>(&y[i]), load_lanes<Double4>(&z[i])};
  }

  /// The ends at which four faces are.
  WHITTLE_INLINE PointLanes<Double4> ends_of(std::size_t i) const {
    const Double4 place = Double4{0, 1, 2, 3} + static_cast<double>(i);
    const auto is_first = place < static_cast<double>(ring.n_first_);
    const auto choose = [&](double a, double b)
                            WHITTLE_INLINE_LAMBDA { return select_lanes(is_first, Double4{} + a, Double4{} + b); };
    const Vec3& first = ring.first_;
    const Vec3& second = ring.second_;
    return {choose(first.x(), second.x()), choose(first.y(), second.y()), choose(first.z(), second.z())};
  }

  /// The normals of the two faces at both ends, as the first end has them, and of two without area.
  WHITTLE_INLINE PointLanes<Double4> common_normals() const {
    const Vec3& first = ring.first_;
    const Vec3& second = ring.second_;
    const std::array next{second, ring.neighbour(ring.n_first_), first, first};
    const std::array previous{ring.neighbour(0), second, first, first};
    const auto arms = [&first](const std::array<Vec3, 4>& points) WHITTLE_INLINE_LAMBDA {
      return point_lanes<Double4>([&points](std::size_t lane) -> const Vec3& { return points[lane]; }) -
             everywhere(first);
    };
    return arms(next).cross(arms(previous));
  }

  WHITTLE_INLINE void look_at_faces() const {
    PointLanes<Double4> normals{};
    Double4 offset{};
    Double4 length{};
    Double4 farthest_sq{};
    const auto add = [&](const auto& apex, const auto& normal, const auto& size) WHITTLE_INLINE_LAMBDA {
      normals = {normals.x + normal.x, normals.y + normal.y, normals.z + normal.z};
      offset += normal.dot(apex);
      length += size;
    };
    for (std::size_t i = 0; i < ring.size(); i += at_once) {
      const PointLanes<Double4> apex = ends_of(i);
      const PointLanes<Double4> x = neighbours_from(i);
      const PointLanes<Double4> y = neighbours_from(i + 1);
      const PointLanes<Double4> normal = (x - apex).cross(y - apex);
      const FacePlanes<Double4> planes = face_planes(normal);
      add(apex, normal, planes.length);
      const Double4 distance_sq = x.dot(x);
      farthest_sq = select_lanes(distance_sq > farthest_sq, distance_sq, farthest_sq);
      FourFaces& faces = ring.faces_[i / at_once];
      store(planes.normal, faces.normal);
      store(planes.length, faces.length);
      const auto had_area = FlipLimit::has_area(normal.dot(normal), x - apex, y - x);
      store(select_lanes(had_area, Double4{1, 1, 1, 1}, Double4{}), faces.had_area);
    }
    const PointLanes<Double4> common = common_normals();
    const FacePlanes<Double4> vanishing = face_planes(common);
    add(everywhere(ring.first_), common, vanishing.length);
    store(vanishing.normal, ring.common_.normal);
    store(vanishing.length, ring.common_.length);
    ring.volume_ = {{sum(normals.x), sum(normals.y), sum(normals.z)},
                    sum(offset),
                    sum(length),
                    std::max(std::max(farthest_sq[0], farthest_sq[1]), std::max(farthest_sq[2], farthest_sq[3]))};
  }

  WHITTLE_INLINE void move_to(const Vec3& to, const QuadricOptions& options) const {
    const PointLanes<Double4> apex = everywhere(to);
    SymmetricLanes<Double4> all;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Double4 least_cosine = Double4{} + infinity;
    for (std::size_t i = 0; i < ring.size(); i += at_once) {
      const PointLanes<Double4> x = neighbours_from(i);
      const PointLanes<Double4> y = neighbours_from(i + 1);
      const PointLanes<Double4> normal = (x - apex).cross(y - apex);
      const FacePlanes<Double4> planes = face_planes(normal);
      const FourFaces& faces = ring.faces_[i / at_once];
      const FacePlanes<Double4> planes_before{load(faces.normal), load(faces.length)};
      const auto keeps_area = FlipLimit::has_area(normal.dot(normal), x - apex, y - x);
      const Double4 cosine = select_lanes(keeps_area, planes.normal.dot(planes_before.normal), Double4{} - infinity);
      const Double4 flip = select_lanes(load(faces.had_area) > 0, cosine, Double4{} + infinity);
      least_cosine = select_lanes(flip < least_cosine, flip, least_cosine);
      const SymmetricLanes<Double4> after = plane_quadric(planes.normal, 0.5 * planes.length, options);
      const SymmetricLanes<Double4> before = plane_quadric(planes_before.normal, 0.5 * planes_before.length, options);
      all += after;
      store_transposed({after.xx - before.xx, after.xy - before.xy, after.xz - before.xz, after.yy - before.yy,
                        after.yz - before.yz, after.zz - before.zz},
                       &ring.changes_[i].planes.xx);
    }
    const SymmetricLanes<Double4> vanishing =
        plane_quadric(load(ring.common_.normal), 0.5 * load(ring.common_.length), options);
    store_transposed(vanishing, &ring.vanished_[0].planes.xx);
    ring.planes_ = {sum(all.xx), sum(all.xy), sum(all.xz), sum(all.yy), sum(all.yz), sum(all.zz)};
    ring.least_cosine_ =
        std::min(std::min(least_cosine[0], least_cosine[1]), std::min(least_cosine[2], least_cosine[3]));
  }

  WHITTLE_AVX2 void look_at_faces_in_wide_registers() const { look_at_faces(); }
  WHITTLE_AVX2 void move_to_in_wide_registers(const Vec3& to, const QuadricOptions& options) const {
    move_to(to, options);
  }
};

void MergedRing::look_at_faces() {
  const Kernels kernels{*this};
  has_double4 ? kernels.look_at_faces_in_wide_registers() : kernels.look_at_faces();
}

double MergedRing::displacement_sq(const Vec3& position) const {
  const Vec3 apex = position - origin_;
  struct Nearest {
    Vec3 point;
    double distance_sq = std::numeric_limits<double>::infinity();
    void look_at(const Vec3& a, const Vec3& b, const Vec3& c) {
      distance_sq = std::min(distance_sq, distance_sq_to_triangle(a - point, b - point, c - point));
    }
  };
  Nearest from_first{first_};
  Nearest from_second{second_};
  Nearest from_apex{apex};
  for (std::size_t i = 0; i < size(); ++i) {
    const Vec3 x = neighbour(i);
    const Vec3 y = neighbour(i + 1);
    from_first.look_at(apex, x, y);
    from_second.look_at(apex, x, y);
    from_apex.look_at(i < n_first_ ? first_ : second_, x, y);
  }
  from_apex.look_at(first_, second_, neighbour(0));
  from_apex.look_at(first_, neighbour(n_first_), second_);
  return std::max({from_first.distance_sq, from_second.distance_sq, from_apex.distance_sq});
}

void MergedRing::move_to(const Vec3& position, const QuadricOptions& options) {
  moved_to_ = position;
  const Vec3 apex = position - origin_;
  const Kernels kernels{*this};
  has_double4 ? kernels.move_to_in_wide_registers(apex, options) : kernels.move_to(apex, options);
}

}  // namespace whittle
