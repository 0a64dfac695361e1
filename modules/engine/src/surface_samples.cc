#include "surface_samples.hh"

#include <algorithm>
#include <array>
#include <cmath>

#include "whittle/engine/parallel.hh"

namespace whittle {

SurfaceSamples::SurfaceSamples(const IndexedMesh& surface, std::span<const Index> vertex_map, const Frame& frame,
                               std::size_t per_face, unsigned threads)
    : faces_(surface.faces),
      vertex_map_(vertex_map),
      per_face_(per_face),
      positions_(surface.positions.size()),
      normals_and_areas_(surface.positions.size(), Eigen::Vector4f::Zero()),
      face_areas_(surface.faces.size()) {
  for_each_range(positions_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) positions_[v] = frame.to_frame(surface.positions[v]);
  });
  measure();
  feet_.resize(positions_.size() + per_face * faces_.size());
}

Eigen::Vector3f SurfaceSamples::normal(const Triangle& face) const {
  const Vec3& corner = positions_[face[0]];
  const Eigen::Vector3f to_second = (positions_[face[1]] - corner).cast<float>();
  return to_second.cross((positions_[face[2]] - corner).cast<float>());
}

void SurfaceSamples::measure() {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    Eigen::Vector4f sum;
    sum.head<3>() = normal(faces_[f]);
    face_areas_[f] = 0.5F * std::sqrt(sum.head<3>().squaredNorm());
    sum.w() = face_areas_[f] / 3;
    for (const Index v : faces_[f]) normals_and_areas_[v] += sum;
  }
}

void SurfaceSamples::find_feet(const FootFinder& finder, unsigned threads) {
  constexpr std::size_t at_once = 128;  // stay in the nearest cache
  for_each_range(size(), threads, [&](std::size_t begin, std::size_t end) {
    std::array<FootFinder::Query, at_once> queries;
    for (; begin < end; begin += at_once) {
      const std::size_t n = std::min(at_once, end - begin);
      for (std::size_t i = 0; i < n; ++i) queries[i] = query(begin + i);
      finder.find(std::span(queries).first(n), std::span(feet_).subspan(begin, n));
    }
  });
}

FootFinder::Query SurfaceSamples::query(std::size_t i) const {
  if (i < n_vertices()) return {positions_[i], normals_and_areas_[i].head<3>(), vertex_map_[i]};
  const std::size_t in_faces = i - n_vertices();
  const Triangle& face = faces_[in_faces / per_face_];
  const std::size_t place = in_faces % per_face_;
  return {position_in_face(in_faces), normal(face), vertex_map_[face[place == 0 ? 0 : place - 1]]};
}

/// The centroid of a face, or a point half way from there to a corner.
Vec3 SurfaceSamples::position_in_face(std::size_t i) const {
  const Triangle& face = faces_[i / per_face_];
  const std::size_t place = i % per_face_;
  const Vec3 sum = positions_[face[0]] + positions_[face[1]] + positions_[face[2]];
  return place == 0 ? Vec3(sum / 3) : Vec3((sum + 3 * positions_[face[place - 1]]) / 6);
}

}  // namespace whittle
