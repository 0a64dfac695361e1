#pragma once

#include <span>

#include "original/closest_point_finder.hh"
#include "surface/surface_walk.hh"
#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::polishing {

/// The original: vertices in their frame, with faces, normals and areas.
class OriginalSurface {
 public:
  /// Keeps a reference to the faces. \throw Cancelled
  OriginalSurface(const IndexedMesh& mesh, const detail::Workers& workers);

  const Frame& frame() const { return frame_; }  ///< of the vertices

  std::span<const Triangle> faces() const { return faces_; }
  std::span<const Vec3> positions() const { return positions_; }  ///< in the frame
  /// The sum of a vertex' faces' normals, each as long as twice the face's area.
  Eigen::Vector3f normal(Index v) const { return normals_and_areas_[v].head<3>(); }
  /// A third of the area of a vertex' faces.
  float area(Index v) const { return normals_and_areas_[v].w(); }

  /// The closest point to `point` that a walk from a vertex finds.
  SurfacePoint nearest(const Vec3& point, Index start) const {
    return walk_to_nearest(faces_, faces_at_vertex_, positions_, point, start);
  }
  Vec3 position_of(const SurfacePoint& nearest) const {
    const auto& [a, b, c] = faces_[nearest.face];
    return (1 - nearest.at.second - nearest.at.third) * positions_[a] + nearest.at.second * positions_[b] +
           nearest.at.third * positions_[c];
  }

  /// Prefetches positions, normals and areas.
  void prefetch(Index v) const {
    prefetch_line(&positions_[v]);
    prefetch_line(&normals_and_areas_[v]);
  }

 private:
  void measure(const detail::Workers& workers);

  Frame frame_;
  std::span<const Triangle> faces_;
  LargeArray<Vec3> positions_;
  LargeArray<Eigen::Vector4f> normals_and_areas_;
  detail::IndexLists<Index> faces_at_vertex_;
};

}  // namespace whittle::polishing
