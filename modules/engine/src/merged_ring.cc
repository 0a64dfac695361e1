#include "whittle/engine/merged_ring.hh"

#include <algorithm>
#include <cstring>
#include <limits>

#include "whittle/engine/nearest_on_triangle.hh"

namespace whittle {
namespace {

[[gnu::always_inline]] inline Double4 load(const double* from) {
  Double4 lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}

[[gnu::always_inline]] inline double sum(const Double4& x) { return (x[0] + x[1]) + (x[2] + x[3]); }

[[gnu::always_inline]] inline PointLanes<Double4> everywhere(const Vec3& p) {
  return {Double4{} + p.x(), Double4{} + p.y(), Double4{} + p.z()};
}

/// To four times eight doubles: xx, xy, xz, yy, yz, zz and two zeros of each.
[[gnu::always_inline]] inline void store_transposed(const SymmetricLanes<Double4>& m, double* to) {
  const Double4 low01 = __builtin_shufflevector(m.xx, m.xy, 0, 4, 2, 6);
  const Double4 high01 = __builtin_shufflevector(m.xx, m.xy, 1, 5, 3, 7);
  const Double4 low23 = __builtin_shufflevector(m.xz, m.yy, 0, 4, 2, 6);
  const Double4 high23 = __builtin_shufflevector(m.xz, m.yy, 1, 5, 3, 7);
  const Double4 low45 = __builtin_shufflevector(m.yz, m.zz, 0, 4, 2, 6);
  const Double4 high45 = __builtin_shufflevector(m.yz, m.zz, 1, 5, 3, 7);
  const Double4 zero{};
  const std::array<Double4, 8> rows{
      __builtin_shufflevector(low01, low23, 0, 1, 4, 5),   __builtin_shufflevector(low45, zero, 0, 1, 4, 5),
      __builtin_shufflevector(high01, high23, 0, 1, 4, 5), __builtin_shufflevector(high45, zero, 0, 1, 4, 5),
      __builtin_shufflevector(low01, low23, 2, 3, 6, 7),   __builtin_shufflevector(low45, zero, 2, 3, 6, 7),
      __builtin_shufflevector(high01, high23, 2, 3, 6, 7), __builtin_shufflevector(high45, zero, 2, 3, 6, 7)};
  std::memcpy(to, rows.data(), sizeof(rows));
}

}  // namespace

/// What the sums look at.
struct MergedRing::Shape {
  std::array<const double*, 3> neighbours;
  std::size_t n;
  std::size_t n_first;
  Vec3 first, second;

  [[gnu::always_inline]] PointLanes<Double4> neighbours_from(std::size_t i) const {
    return {load(neighbours[0] + i), load(neighbours[1] + i), load(neighbours[2] + i)};
  }
  Vec3 neighbour(std::size_t i) const { return {neighbours[0][i], neighbours[1][i], neighbours[2][i]}; }

  /// The ends at which four faces are.
  [[gnu::always_inline]] PointLanes<Double4> ends_of(std::size_t i) const {
    const Double4 place = Double4{0, 1, 2, 3} + static_cast<double>(i);
    const auto is_first = place < static_cast<double>(n_first);
    const auto choose = [&](double a, double b) __attribute__((always_inline)) {
      return is_first ? Double4{} + a : Double4{} + b;
    };
    return {choose(first.x(), second.x()), choose(first.y(), second.y()), choose(first.z(), second.z())};
  }

  /// The other corners of the two faces at both ends, as the first end has them, and of two without area.
  struct OtherCorners {
    PointLanes<Double4> next, previous;
  };
  [[gnu::always_inline]] OtherCorners common_faces() const {
    const std::array next{second, neighbour(n_first), first, first};
    const std::array previous{neighbour(0), second, first, first};
    const auto at = [](const std::array<Vec3, 4>& points) __attribute__((always_inline)) {
      return [&points](std::size_t lane) -> const Vec3& { return points[lane]; };
    };
    return {point_lanes<Double4>(at(next)), point_lanes<Double4>(at(previous))};
  }
};

[[gnu::always_inline]] inline StarVolume MergedRing::sum_volume(const Shape& shape) {
  PointLanes<Double4> normals{};
  Double4 offset{};
  Double4 length{};
  Double4 farthest_sq{};
  const auto add = [&](const auto& apex, const auto& x, const auto& y) __attribute__((always_inline)) {
    const PointLanes<Double4> normal = (x - apex).cross(y - apex);
    normals = {normals.x + normal.x, normals.y + normal.y, normals.z + normal.z};
    offset += normal.dot(apex);
    Double4 size = normal.dot(normal);
    take_square_roots(size);
    length += size;
  };
  for (std::size_t i = 0; i < shape.n; i += at_once) {
    const PointLanes<Double4> x = shape.neighbours_from(i);
    add(shape.ends_of(i), x, shape.neighbours_from(i + 1));
    const Double4 distance_sq = x.dot(x);
    farthest_sq = distance_sq > farthest_sq ? distance_sq : farthest_sq;
  }
  const auto [next, previous] = shape.common_faces();
  add(everywhere(shape.first), next, previous);
  return {{sum(normals.x), sum(normals.y), sum(normals.z)},
          sum(offset),
          sum(length),
          std::max(std::max(farthest_sq[0], farthest_sq[1]), std::max(farthest_sq[2], farthest_sq[3]))};
}
WHITTLE_DOUBLE4 StarVolume MergedRing::sum_volume_in_wide_registers(const Shape& shape) { return sum_volume(shape); }

[[gnu::always_inline]] inline SymmetricMatrix MergedRing::sum_planes(const Shape& shape, const Vec3& apex,
                                                                     const QuadricOptions& options, MergedRing& ring) {
  const PointLanes<Double4> moved = everywhere(apex);
  SymmetricLanes<Double4> all;
  for (std::size_t i = 0; i < shape.n; i += at_once) {
    const PointLanes<Double4> x = shape.neighbours_from(i);
    const PointLanes<Double4> y = shape.neighbours_from(i + 1);
    const SymmetricLanes<Double4> after = corner_quadrics(moved, x, y, options);
    const SymmetricLanes<Double4> before = corner_quadrics(shape.ends_of(i), x, y, options);
    all += after;
    store_transposed({after.xx - before.xx, after.xy - before.xy, after.xz - before.xz, after.yy - before.yy,
                      after.yz - before.yz, after.zz - before.zz},
                     &ring.changes_[i].planes.xx);
  }
  const auto [next, previous] = shape.common_faces();
  store_transposed(corner_quadrics(everywhere(shape.first), next, previous, options), &ring.vanished_[0].planes.xx);
  return {sum(all.xx), sum(all.xy), sum(all.xz), sum(all.yy), sum(all.yz), sum(all.zz)};
}
WHITTLE_DOUBLE4 SymmetricMatrix MergedRing::sum_planes_in_wide_registers(const Shape& shape, const Vec3& apex,
                                                                         const QuadricOptions& options,
                                                                         MergedRing& ring) {
  return sum_planes(shape, apex, options, ring);
}

void MergedRing::assign(const TriangleComplex& complex, const Pair& pair, const PairStar& star, const Vec3& origin) {
  const std::span<const Spoke> first = star.first.spokes();
  const std::span<const Spoke> others = star.second.spokes().subspan(1, star.second.size() - 1);
  n_first_ = first.size() - 1;
  first_ = complex.position(pair.a) - origin;
  second_ = complex.position(pair.b) - origin;
  vertices_.resize(first.size() + others.size());
  const auto vertex_of = [](const Spoke& spoke) { return spoke.vertex; };
  std::transform(others.begin(), others.end(), std::transform(first.begin(), first.end(), vertices_.begin(), vertex_of),
                 vertex_of);
  load_neighbours(origin, [&complex](Index v) -> const Vec3& { return complex.position(v); });
}

MergedRing::Shape MergedRing::shape() const {
  return {{neighbours_[0].data(), neighbours_[1].data(), neighbours_[2].data()}, size(), n_first_, first_, second_};
}

StarVolume MergedRing::volume() const {
  return has_double4 ? sum_volume_in_wide_registers(shape()) : sum_volume(shape());
}

double MergedRing::displacement_sq(const Vec3& apex) const {
  struct Nearest {
    Vec3 point;
    double distance_sq = std::numeric_limits<double>::infinity();
    void look_at(const Vec3& a, const Vec3& b, const Vec3& c) {
      distance_sq = std::min(distance_sq, distance_sq_to_triangle(a - point, b - point, c - point));
    }
  };
  const Shape ring = shape();
  Nearest from_first{first_};
  Nearest from_second{second_};
  Nearest from_apex{apex};
  for (std::size_t i = 0; i < ring.n; ++i) {
    const Vec3 x = ring.neighbour(i);
    const Vec3 y = ring.neighbour(i + 1);
    from_first.look_at(apex, x, y);
    from_second.look_at(apex, x, y);
    from_apex.look_at(i < n_first_ ? first_ : second_, x, y);
  }
  from_apex.look_at(first_, second_, ring.neighbour(0));
  from_apex.look_at(first_, ring.neighbour(n_first_), second_);
  return std::max({from_first.distance_sq, from_second.distance_sq, from_apex.distance_sq});
}

SymmetricMatrix MergedRing::move_to(const Vec3& apex, const QuadricOptions& options) {
  return has_double4 ? sum_planes_in_wide_registers(shape(), apex, options, *this)
                     : sum_planes(shape(), apex, options, *this);
}

}  // namespace whittle
