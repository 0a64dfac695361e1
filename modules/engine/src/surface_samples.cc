#include "surface_samples.hh"

#include <algorithm>

#include "whittle/engine/parallel.hh"

namespace whittle {

SurfaceSamples::SurfaceSamples(const IndexedMesh& surface, std::span<const Index> vertex_map, const Frame& frame,
                               std::size_t per_face, unsigned threads)
    : faces_(surface.faces),
      vertex_map_(vertex_map),
      per_face_(per_face),
      positions_(surface.positions.size()),
      normals_(surface.positions.size(), Vec3::Zero()),
      vertex_areas_(surface.positions.size()),
      face_areas_(surface.faces.size()) {
  for_each_range(positions_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) positions_[v] = frame.to_frame(surface.positions[v]);
  });
  vertex_feet_.resize(positions_.size());
  face_feet_.resize(per_face * faces_.size());
  measure();
}

void SurfaceSamples::measure() {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const auto& [a, b, c] = faces_[f];
    const Vec3 normal = (positions_[b] - positions_[a]).cross(positions_[c] - positions_[a]);
    face_areas_[f] = static_cast<float>(0.5 * normal.norm());
    for (const Index v : faces_[f]) {
      normals_[v] += normal;
      vertex_areas_[v] += face_areas_[f] / 3;
    }
  }
}

void SurfaceSamples::find_feet(const FootFinder& finder, unsigned threads) {
  for_each_range(positions_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      vertex_feet_[v] = {};
      if (vertex_map_[v] == invalid_index) continue;
      vertex_feet_[v] = finder.find({positions_[v], normals_[v].normalized(), vertex_map_[v]});
    }
  });
  for_each_range(faces_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) find_feet_of_face(finder, f);
  });
}

Vec3 SurfaceSamples::position(std::size_t i) const {
  if (i < n_vertices()) return positions_[i];
  const std::size_t f = (i - n_vertices()) / per_face_;
  const std::size_t place = (i - n_vertices()) % per_face_;
  const Vec3 sum = positions_[faces_[f][0]] + positions_[faces_[f][1]] + positions_[faces_[f][2]];
  return place == 0 ? Vec3(sum / 3) : Vec3((sum + 3 * positions_[faces_[f][place - 1]]) / 6);
}

double SurfaceSamples::weight(std::size_t i) const {
  if (i < n_vertices()) return 0.25 * vertex_areas_[i];
  const std::size_t f = (i - n_vertices()) / per_face_;
  const std::span<const Foot> feet = std::span(face_feet_).subspan(f * per_face_, per_face_);
  const auto n = std::count_if(feet.begin(), feet.end(), [](const Foot& foot) { return foot.face != invalid_index; });
  return 0.75 * face_areas_[f] / static_cast<double>(n);
}

/// Where the corners have their feet in one face, the centroid's is there, too, and it will do.
void SurfaceSamples::find_feet_of_face(const FootFinder& finder, std::size_t f) {
  const std::span<Foot> feet = std::span(face_feet_).subspan(f * per_face_, per_face_);
  std::fill(feet.begin(), feet.end(), Foot{});
  const auto& [a, b, c] = faces_[f];
  const Foot& at_a = vertex_feet_[a];
  const Foot& at_b = vertex_feet_[b];
  const Foot& at_c = vertex_feet_[c];
  if (at_a.face == at_b.face && at_b.face == at_c.face) {
    const auto mean = [](float x, float y, float z) { return (x + y + z) / 3; };
    feet[0] = {at_a.face, mean(at_a.second, at_b.second, at_c.second), mean(at_a.third, at_b.third, at_c.third),
               mean(at_a.distance, at_b.distance, at_c.distance)};
    return;
  }
  const Vec3 normal = (positions_[b] - positions_[a]).cross(positions_[c] - positions_[a]).normalized();
  const Vec3 sum = positions_[a] + positions_[b] + positions_[c];
  const auto find = [&](const Vec3& position, Index near) -> Foot {
    if (vertex_map_[near] == invalid_index) return {};
    return finder.find({position, normal, vertex_map_[near]});
  };
  feet[0] = find(sum / 3, a);
  if (per_face_ == 1) return;
  for (std::size_t i = 0; i < 3; ++i) feet[1 + i] = find((sum + 3 * positions_[faces_[f][i]]) / 6, faces_[f][i]);
}

}  // namespace whittle
