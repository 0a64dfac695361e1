#include "fit/two_sided_error.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "whittle/core/geometry/nearest_on_triangle.hh"
#include "whittle/core/geometry/spread_point.hh"

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

/// The distances from points in faces of `from`, weighted by the areas of these faces, to `to`.
/// \param start `start(face, point)` is a vertex of `to` near that point, or `invalid_index`
template <class Start>
std::vector<TwoSidedError::Distance> one_sided(const Surface& from, const Surface& to, const Start& start,
                                               const detail::Workers& workers) {
  const Choice points(from.faces.size());
  std::vector<TwoSidedError::Distance> distances(points.n, {0, 0});
  constexpr std::size_t length = 64;
  for_each_block((points.n + length - 1) / length, workers, [&](std::size_t block) {
    for (std::size_t i = block * length; i < std::min(points.n, (block + 1) * length); ++i) {
      const Triangle& face = from.faces[points.face(i)];
      const Vec3& a = from.positions[face[0]];
      const Vec3 ab = from.positions[face[1]] - a;
      const Vec3 ac = from.positions[face[2]] - a;
      const auto [second, third] = spread_point(i);
      const Vec3 point = a + second * ab + third * ac;
      const Index near = start(face, point);
      if (near == invalid_index) continue;
      const NearestPoint nearest = walk_to_nearest(to, point, near);
      if (nearest.corner == nullptr) continue;
      distances[i] = {nearest.distance_sq, ab.cross(ac).norm()};
    }
  });
  double sum = 0;
  for (const auto& [square, weight] : distances) sum += weight;
  for (auto& [square, weight] : distances) weight *= sum > 0 ? 0.5 / sum : 0;
  return distances;
}

}  // namespace

TwoSidedError::TwoSidedError(const SimplifiedSurface& original, std::span<const Triangle> mesh_faces,
                             std::size_t n_mesh_vertices, const detail::Workers& workers)
    : original_(original) {
  workers.update(0);
  const std::span<const Index> vertex_map = original.vertex_map;
  std::vector<std::uint8_t> is_asked(n_mesh_vertices);
  const Choice points(mesh_faces.size());
  for (std::size_t i = 0; i < points.n; i += points.per_face) {
    for (const Index v : mesh_faces[points.face(i)]) is_asked[v] = 1;
  }
  std::vector<std::uint8_t> is_near(vertex_map.size());
  for_each_range(vertex_map.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      is_near[v] = static_cast<std::uint8_t>(vertex_map[v] != invalid_index && is_asked[vertex_map[v]] != 0);
    }
  });
  origins_ = {n_mesh_vertices, [&](const auto& add) {
                for (Index v = 0; v < vertex_map.size(); ++v) {
                  if (is_near[v] != 0) add(vertex_map[v], v);
                }
              }};
  original_corners_ = corners_by_vertex(original.faces, is_near, workers);
}

std::vector<TwoSidedError::Distance> TwoSidedError::distances(const Surface& mesh,
                                                              const detail::Workers& workers) const {
  const auto nearest = [](std::span<const Vec3> positions, const Vec3& point, Index& best, Index v) {
    if (best == invalid_index || (positions[v] - point).squaredNorm() < (positions[best] - point).squaredNorm())
      best = v;
  };
  const auto in_mesh = [&](const Triangle& face, const Vec3& point) {
    Index best = invalid_index;
    for (const Index v : face) {
      if (original_.vertex_map[v] != invalid_index) nearest(mesh.positions, point, best, original_.vertex_map[v]);
    }
    return best;
  };
  const auto in_original = [&](const Triangle& face, const Vec3& point) {
    Index best = invalid_index;
    for (const Index v : face) {
      for (const Index origin : origins_.of(v)) nearest(original_.positions, point, best, origin);
    }
    return best;
  };
  const Surface original{original_.faces, original_corners_, original_.positions};
  std::vector<Distance> all = one_sided(original, mesh, in_mesh, workers);
  const std::vector<Distance> back = one_sided(mesh, original, in_original, workers);
  all.insert(all.end(), back.begin(), back.end());
  return all;
}

}  // namespace whittle::polishing
