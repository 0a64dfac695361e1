#include "fit/two_sided_error.hh"

#include <algorithm>

#include "whittle/core/geometry/spread_point.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::polishing {
namespace {

/// The points of a mesh at which distances are measured: at least a thousand. That is enough to tell better from worse,
/// since they are the same points every time.
struct Choice {
  std::size_t per_face;
  std::size_t step;  ///< every so many faces
  std::size_t n;

  explicit Choice(std::size_t n_faces) {
    constexpr std::size_t n_wanted = 1000;
    per_face = (n_wanted + n_faces - 1) / n_faces;
    step = std::max<std::size_t>(1, n_faces / n_wanted);
    n = per_face * ((n_faces + step - 1) / step);
  }
  std::size_t face(std::size_t i) const { return i / per_face * step; }
};

/// The distances from points in faces, weighted by the areas of these faces.
/// \param nearest `nearest(face, point)` is the point of the other surface that is nearest to a point in that face
template <class Nearest>
void add_one_way(std::span<const Triangle> faces, std::span<const Vec3> positions, const Nearest& nearest,
                 Distances& distances, const detail::Workers& workers) {
  const Choice points(faces.size());
  const std::size_t n_before = distances.size();
  distances.resize(n_before + points.n, {0, 0});
  const std::span one_way = std::span(distances).subspan(n_before);
  constexpr std::size_t length = 64;
  for_each_block((points.n + length - 1) / length, workers, [&](std::size_t block) {
    for (std::size_t i = block * length; i < std::min(points.n, (block + 1) * length); ++i) {
      const Triangle& face = faces[points.face(i)];
      const SurfacePoint found = nearest(face, point_at(corners_of(positions, face), spread_point(i)));
      if (found.face != invalid_index) one_way[i] = {found.distance_sq, area_of(positions, face)};
    }
  });
  double sum = 0;
  for (const auto& [square, weight] : one_way) sum += weight;
  for (auto& [square, weight] : one_way) weight *= sum > 0 ? 0.5 / sum : 0;
}

}  // namespace

Distances two_sided_distances(const Origins& origins, const Surface& mesh, const detail::Workers& workers) {
  const OriginalSurface& original = origins.original();
  const auto on_mesh = [&](const Triangle& face, const Vec3& point) {
    NearestVertex start{point};
    for (const Index origin : face) {
      const Index v = origins.mapped(origin);
      if (v != invalid_index) start.look_at(v, mesh.positions[v]);
    }
    return start.vertex == invalid_index ? SurfacePoint{} : walk_to_nearest(mesh, point, start.vertex);
  };
  const auto on_original = [&](const Triangle& face, const Vec3& point) {
    NearestVertex start{point};
    for (const Index v : face) {
      for (const Index origin : origins.of(v)) start.look_at(origin, original.positions()[origin]);
    }
    return start.vertex == invalid_index ? SurfacePoint{} : original.nearest(point, start.vertex);
  };
  Distances distances;
  add_one_way(original.faces(), original.positions(), on_mesh, distances, workers);
  add_one_way(mesh.faces, mesh.positions, on_original, distances, workers);
  return distances;
}

}  // namespace whittle::polishing
