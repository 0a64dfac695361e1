#include "surface/surface_samples.hh"

#include <algorithm>
#include <array>
#include <cmath>

#include "surface/surface_walk.hh"
#include "whittle/core/detail/compiler.hh"
#include "whittle/core/detail/item_groups.hh"

namespace whittle::polishing {
namespace {

/// How many faces ahead corners are prefetched: the time of a miss, some hundred nanoseconds.
constexpr std::size_t ahead = 12;

/// Finds feet in batches that are small enough for the first cache.
class Batch {
 public:
  Batch(const FootFinder& finder, std::span<Foot> feet) : finder_(finder), feet_(feet) {}

  void add(const FootFinder::Query& query) {
    queries_[n_++] = query;
    if (n_ == queries_.size()) finish();
  }
  void finish() {
    finder_.find(std::span(queries_).first(n_), feet_.first(n_));
    feet_ = feet_.subspan(n_);
    n_ = 0;
  }

 private:
  const FootFinder& finder_;
  std::span<Foot> feet_;  ///< of the queries to come
  std::array<FootFinder::Query, 128> queries_;
  std::size_t n_ = 0;
};

}  // namespace

SurfaceSamples::SurfaceSamples(const IndexedMesh& surface, std::span<const Index> vertex_map, const Frame& frame,
                               std::size_t per_face, const detail::Workers& workers)
    : faces_(surface.faces),
      vertex_map_(vertex_map),
      per_face_(per_face),
      positions_(surface.positions.size()),
      normals_and_areas_(surface.positions.size()),
      face_areas_(surface.faces.size()) {
  for_each_range(positions_.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) positions_[v] = frame.to_frame(surface.positions[v]);
  });
  measure(workers);
  feet_.resize(positions_.size() + per_face * faces_.size());
}

/// Prefetches the positions of a face's corners, and what `more` has of them.
template <class PerVertex>
void SurfaceSamples::prefetch_corners(std::size_t f, const PerVertex& more) const {
  if (f >= faces_.size()) return;
  for (const Index v : faces_[f]) {
    prefetch_line(&positions_[v]);
    prefetch_line(&more[v]);
  }
}

void SurfaceSamples::measure(const detail::Workers& workers) {
  constexpr Index check_mask = (Index{1} << 16) - 1;  // some milliseconds from check to check
  const auto measure_around = [&](Index begin, Index end, const auto& for_each_face) {
    workers.update(0);
    std::fill(&normals_and_areas_[begin], normals_and_areas_.data() + end, Eigen::Vector4f::Zero());
    for_each_face([&](Index f) {
      if ((f & check_mask) == 0) workers.update(0);
      prefetch_corners(f + ahead, normals_and_areas_);
      const Eigen::Vector3f normal = area_normal(faces_[f], positions_).cast<float>();
      const float area = 0.5F * std::sqrt(length_sq(normal));
      const Eigen::Vector4f sum(normal.x(), normal.y(), normal.z(), area / 3);
      const auto is_here = [=](Index v) { return v >= begin && v < end; };
      if (is_here(faces_[f][0])) face_areas_[f] = area;
      for (const Index v : faces_[f]) {
        if (is_here(v)) normals_and_areas_[v] += sum;
      }
    });
  };
  detail::for_each_vertex_range(faces_, n_vertices(), workers.threads, measure_around);
}

void SurfaceSamples::find_feet(const FootFinder& finder, const detail::Workers& workers) {
  for_each_range(n_vertices(), workers, [&](std::size_t begin, std::size_t end) {
    Batch batch(finder, std::span(feet_).subspan(begin));
    for (std::size_t v = begin; v < end; ++v) {
      batch.add({positions_[v], normals_and_areas_[v].head<3>(), vertex_map_[v]});
    }
    batch.finish();
  });
  for_each_range(faces_.size(), workers, [&](std::size_t begin, std::size_t end) {
    Batch batch(finder, std::span(feet_).subspan(n_vertices() + begin * per_face_));
    for (std::size_t f = begin; f < end; ++f) {
      prefetch_corners(f + ahead, vertex_map_);
      const Eigen::Vector3f normal = area_normal(faces_[f], positions_).cast<float>();
      for (std::size_t i = 0; i < per_face_; ++i) {
        batch.add({point_in_face(faces_[f], i), normal, vertex_map_[faces_[f][i == 0 ? 0 : i - 1]]});
      }
    }
    batch.finish();
  });
}

/// The centroid, or a point half-way between the centroid and a corner.
Vec3 SurfaceSamples::point_in_face(const Triangle& face, std::size_t i) const {
  const Vec3 sum = positions_[face[0]] + positions_[face[1]] + positions_[face[2]];
  return i == 0 ? Vec3(sum / 3) : Vec3((sum + 3 * positions_[face[i - 1]]) / 6);
}

Vec3 SurfaceSamples::position(std::size_t i) const {
  if (i < n_vertices()) return positions_[i];
  const std::size_t in_faces = i - n_vertices();
  return point_in_face(faces_[in_faces / per_face_], in_faces % per_face_);
}

}  // namespace whittle::polishing
