#pragma once

#include <span>
#include <vector>

#include "original/closest_point_finder.hh"
#include "original/origins.hh"

namespace whittle::polishing {

/// The points that represent the original, and their closest points on a mesh, by vertex of the mesh.
///
/// The points are the original's vertices, and one or four points in each of its faces: its centroid, and points
/// half-way between the centroid and each corner. Each is merged into a vertex of the mesh with a vertex of the
/// original: itself, or the corner, or with the centroid the first corner. The weights add up to the area; vertices
/// have a quarter of it. Where a function is linear on a face, its weighted sum over the face's points is its integral.
/// With one point a face, the same holds for its square.
class MergedPoints {
 public:
  /// Keeps references to the data of both.
  /// \param end of the range of vertices passed to `find`
  /// \pre end > 0
  MergedPoints(const Origins& origins, const Surface& mesh, Index end);

  /// Finds the closest points of the points that were merged into a vertex.
  void find(Index v);
  std::span<const ClosestFacePoint> closest_points() const { return closest_points_; }  ///< per point
  std::span<const double> weights() const { return weights_; }                          ///< per point

 private:
  void add(const Vec3& position, const Eigen::Vector3f& normal, double weight);
  void add_points_of_face(const Corner& corner);
  void prefetch_after(const Index* vertex) const;
  void prefetch_after(const Corner* corner) const;

  const Origins& origins_;
  ClosestPointFinder finder_;
  const Index* vertices_end_;
  const Corner* corners_end_;
  std::vector<ClosestPointFinder::Point> points_;
  std::vector<double> weights_;
  std::vector<ClosestFacePoint> closest_points_;
};

}  // namespace whittle::polishing
