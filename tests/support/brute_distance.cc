#include "support/brute_distance.hh"

#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle::test {
namespace {

double distance_to_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double square = (b - a).squaredNorm();
  const double share = square > 0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0;
  return (a + share * (b - a) - p).norm();
}

}  // namespace

Corners corners_of(const IndexedMesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.faces[face];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

double distance_to_triangle(const Corners& t, const Vec3& p) {
  const auto& [a, b, c] = t;
  const double to_sides =
      std::min({distance_to_segment(a, b, p), distance_to_segment(b, c, p), distance_to_segment(c, a, p)});
  const Vec3 normal = (b - a).cross(c - a);
  const auto is_left = [&](const Vec3& from, const Vec3& to) { return normal.dot((to - from).cross(p - from)) > 0; };
  const bool is_over = is_left(a, b) && is_left(b, c) && is_left(c, a);
  return is_over ? std::abs(normal.dot(p - a)) / normal.norm() : to_sides;
}

double distance_to_all(const IndexedMesh& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < mesh.faces.size(); ++f) least = std::min(least, distance_to_triangle(corners_of(mesh, f), p));
  return least;
}

IndexedMesh random_faces(std::size_t n_faces, Random& random) {
  IndexedMesh mesh;
  for (std::size_t i = 0; i < n_faces + 2; ++i) mesh.positions.push_back(random.uniform_vector(-1, 1));
  for (std::size_t f = 0; f < n_faces; ++f) {
    mesh.faces.push_back({static_cast<Index>(random.below(mesh.positions.size())),
                          static_cast<Index>(random.below(mesh.positions.size())),
                          static_cast<Index>(random.below(mesh.positions.size()))});
  }
  return mesh;
}

}  // namespace whittle::test
