#include "rounds/star_planes.hh"

#include <algorithm>

#include "rounds/lane_points.hh"

namespace whittle {
namespace {

constexpr std::size_t at_once = n_lanes<Double4>;

/// The sums of four faces, or over them, side by side.
struct FacesPlanes {
  SymmetricLanes<Double4> matrix;
  PointLanes<Double4> normal{};
  Double4 length{};

  WHITTLE_INLINE FacesPlanes& operator+=(const FacesPlanes& o) {
    matrix += o.matrix;
    normal = normal + o.normal;
    length += o.length;
    return *this;
  }
  /// `use(i, lanes)` for the i-th four numbers of `StarPlanes::sums`, a row of four for each face.
  template <class Use>
  WHITTLE_INLINE void for_each_column(const Use& use) const {
    use(0, transposed<Double4>({matrix.xx, matrix.xy, matrix.xz, matrix.yy}));
    use(1, transposed<Double4>({matrix.yz, matrix.zz, normal.x, normal.y}));
    use(2, transposed<Double4>({normal.z, length, Double4{}, Double4{}}));
  }
};

/// \param corner, next, previous of four faces
WHITTLE_INLINE FacesPlanes planes_of_faces(const PointLanes<Double4>& corner, const PointLanes<Double4>& next,
                                           const PointLanes<Double4>& previous, const QuadricOptions& options) {
  const PointLanes<Double4> normal = (next - corner).cross(previous - corner);
  const FacePlanes<Double4> planes = face_planes(normal);
  return {plane_quadric(planes.normal, 0.5 * planes.length, options), normal, planes.length};
}

WHITTLE_INLINE void add(const Double4& lanes, double* to) { store_lanes(load_lanes<Double4>(to) + lanes, to); }

/// \param faces four \param n how many of them count
WHITTLE_INLINE void add_four(const Triangle* faces, std::size_t n, const LanePoint* points,
                             const QuadricOptions& options, StarPlanes* stars) {
  const auto corners = [&](std::size_t k) WHITTLE_INLINE_LAMBDA {
    return lane_points(points, [&](std::size_t lane) WHITTLE_INLINE_LAMBDA { return faces[lane][k]; });
  };
  planes_of_faces(corners(0), corners(1), corners(2), options)
      .for_each_column([&](std::size_t column, const FourLanes<Double4>& rows) WHITTLE_INLINE_LAMBDA {
        const std::array row{rows.first, rows.second, rows.third, rows.fourth};
        for (std::size_t i = 0; i < n; ++i) {
          for (const Index v : faces[i]) add(row[i], &stars[v].sums[4 * column]);
        }
      });
}

WHITTLE_INLINE void add_all(std::span<const Triangle> faces, const LanePoint* points, const QuadricOptions& options,
                            StarPlanes* stars) {
  std::size_t f = 0;
  for (; f + at_once <= faces.size(); f += at_once) add_four(&faces[f], at_once, points, options, stars);
  if (f == faces.size()) return;
  std::array<Triangle, at_once> last;
  for (std::size_t i = 0; i < at_once; ++i) last[i] = faces[std::min(f + i, faces.size() - 1)];
  add_four(last.data(), faces.size() - f, points, options, stars);
}

WHITTLE_AVX2 void add_all_in_wide_registers(std::span<const Triangle> faces, const LanePoint* points,
                                            const QuadricOptions& options, StarPlanes* stars) {
  add_all(faces, points, options, stars);
}

WHITTLE_INLINE StarPlanes sum_star(Index vertex, std::span<const LinkEdge> faces, const LanePoint* points,
                                   const QuadricOptions& options) {
  const PointLanes<Double4> corner = everywhere(points[vertex]);
  FacesPlanes all;
  for (std::size_t i = 0; i < faces.size(); i += at_once) {
    const LinkEdge* const four = &faces[i];
    const auto next = lane_points(points, [&](std::size_t lane) WHITTLE_INLINE_LAMBDA { return four[lane].x; });
    const auto previous = lane_points(points, [&](std::size_t lane) WHITTLE_INLINE_LAMBDA { return four[lane].y; });
    all += planes_of_faces(corner, next, previous, options);
  }
  StarPlanes star;
  all.for_each_column([&](std::size_t column, const FourLanes<Double4>& rows) WHITTLE_INLINE_LAMBDA {
    store_lanes((rows.first + rows.second) + (rows.third + rows.fourth), &star.sums[4 * column]);
  });
  return star;
}

WHITTLE_AVX2 StarPlanes sum_star_in_wide_registers(Index vertex, std::span<const LinkEdge> faces,
                                                   const LanePoint* points, const QuadricOptions& options) {
  return sum_star(vertex, faces, points, options);
}

}  // namespace

void add_faces(std::span<const Triangle> faces, std::span<const LanePoint> points, const QuadricOptions& options,
               std::span<StarPlanes> stars) {
  has_double4 ? add_all_in_wide_registers(faces, points.data(), options, stars.data())
              : add_all(faces, points.data(), options, stars.data());
}

StarPlanes planes_of_star(Index vertex, std::span<const LinkEdge> faces, std::span<const LanePoint> points,
                          const QuadricOptions& options) {
  return has_double4 ? sum_star_in_wide_registers(vertex, faces, points.data(), options)
                     : sum_star(vertex, faces, points.data(), options);
}

}  // namespace whittle
