#include "two_sided_error.hh"

#include <algorithm>
#include <cmath>

#include "whittle/engine/nearest_on_triangle.hh"
#include "whittle/engine/parallel.hh"

namespace whittle {
namespace {

/// Points on each side, at least: enough to tell better from worse, as they are the same every time.
constexpr std::size_t n_wanted = 3000;

/// The i-th of places that fill a triangle evenly. \cite roberts_2018_quasirandom
Barycentric spread_place(std::size_t i) {
  const double u = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(i), 1.0);
  const double v = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(i), 1.0);
  return u + v <= 1 ? Barycentric{u, v} : Barycentric{1 - u, 1 - v};
}

/// Walks to whatever is nearest, however it lies.
constexpr double any_direction = -1;

/// The mean over points in faces of `from`, weighted by their area, of the squared distance to `to`.
/// \param start gives a vertex of `to` near a point in a face, or `invalid_index`
template <class Start>
double directed_mean_square(const Surface& from, const Surface& to, const Start& start, unsigned threads) {
  const std::size_t n_faces = from.faces.size();
  const std::size_t per_face = (n_wanted + n_faces - 1) / n_faces;
  const std::size_t step = std::max<std::size_t>(1, n_faces / n_wanted);
  const std::size_t n = per_face * ((n_faces + step - 1) / step);
  struct Part {
    double squares = 0;
    double area = 0;
  };
  std::vector<Part> parts(n);
  for_each_range(n, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Triangle& face = from.faces[i / per_face * step];
      const Vec3& a = from.positions[face[0]];
      const Vec3 ab = from.positions[face[1]] - a;
      const Vec3 ac = from.positions[face[2]] - a;
      const auto [second, third] = spread_place(i);
      const Vec3 point = a + second * ab + third * ac;
      const Index near = start(face, point);
      if (near == invalid_index) continue;
      const NearestPoint nearest = walk_to_nearest(to, {point, Vec3::Zero(), near}, any_direction);
      if (nearest.corner == nullptr) continue;
      const double area = ab.cross(ac).norm();
      parts[i] = {area * nearest.distance_sq, area};
    }
  });
  Part all;
  for (const Part& part : parts) {
    all.squares += part.squares;
    all.area += part.area;
  }
  return all.area > 0 ? all.squares / all.area : 0;
}

}  // namespace

TwoSidedError::TwoSidedError(const Surface& original, std::span<const Index> vertex_map, std::size_t n_mesh_vertices)
    : original_(original), vertex_map_(vertex_map), origins_(n_mesh_vertices, [vertex_map](const auto& add) {
        for (Index v = 0; v < vertex_map.size(); ++v) {
          if (vertex_map[v] != invalid_index) add(vertex_map[v], v);
        }
      }) {}

double TwoSidedError::mean_square(const Surface& mesh, unsigned threads) const {
  const auto nearest = [](std::span<const Vec3> positions, const Vec3& point, Index& best, Index v) {
    if (best == invalid_index || (positions[v] - point).squaredNorm() < (positions[best] - point).squaredNorm())
      best = v;
  };
  const auto in_mesh = [&](const Triangle& face, const Vec3& point) {
    Index best = invalid_index;
    for (const Index v : face) {
      if (vertex_map_[v] != invalid_index) nearest(mesh.positions, point, best, vertex_map_[v]);
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
  return 0.5 * (directed_mean_square(original_, mesh, in_mesh, threads) +
                directed_mean_square(mesh, original_, in_original, threads));
}

}  // namespace whittle
