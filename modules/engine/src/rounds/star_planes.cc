#include "rounds/star_planes.hh"

#include <array>

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

/// \param four faces at a vertex
WHITTLE_INLINE FacesPlanes planes_of_four(const PointLanes<Double4>& corner, const LinkEdge* four,
                                          const LanePoint* points, const QuadricOptions& options) {
  const auto next = lane_points(points, [&](std::size_t lane) WHITTLE_INLINE_LAMBDA { return four[lane].x; });
  const auto previous = lane_points(points, [&](std::size_t lane) WHITTLE_INLINE_LAMBDA { return four[lane].y; });
  return planes_of_faces(corner, next, previous, options);
}

WHITTLE_INLINE StarPlanes sum_star(Index vertex, std::span<const LinkEdge> faces, const LanePoint* points,
                                   const QuadricOptions& options) {
  const PointLanes<Double4> corner = everywhere(points[vertex]);
  FacesPlanes all;
  std::size_t i = 0;
  for (; i + at_once <= faces.size(); i += at_once) all += planes_of_four(corner, &faces[i], points, options);
  if (i < faces.size()) {
    std::array<LinkEdge, at_once> last;
    for (LinkEdge& face : last) face = i < faces.size() ? faces[i++] : LinkEdge{vertex, vertex};
    all += planes_of_four(corner, last.data(), points, options);
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

StarPlanes planes_of_star(Index vertex, std::span<const LinkEdge> faces, std::span<const LanePoint> points,
                          const QuadricOptions& options) {
  return has_double4 ? sum_star_in_wide_registers(vertex, faces, points.data(), options)
                     : sum_star(vertex, faces, points.data(), options);
}

}  // namespace whittle
