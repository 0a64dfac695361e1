#pragma once

#include <span>
#include <vector>

#include "original/foot_finder.hh"
#include "original/origins.hh"

namespace whittle::polishing {

/// The points that represent the original, and their feet on a mesh, one vertex of the mesh after the other.
///
/// The points are the original's vertices, and one or four points in each of its faces: its centroid, and points
/// half-way between the centroid and each corner. Each is merged into a vertex of the mesh with a vertex of the
/// original: itself, or the corner, or with the centroid the first corner. The weights add up to the area; vertices
/// have a quarter of it. Where a function is linear on a face, its weighted sum over the face's points is its integral.
/// With one point a face, the same holds for its square.
class MergedPoints {
 public:
  /// Keeps references to what both refer to. \param end of the vertices that will be asked for
  /// \pre there is one
  MergedPoints(const Origins& origins, const Surface& mesh, Index end);

  /// Finds the feet of the points that were merged into a vertex.
  void find(Index v);
  std::span<const Foot> feet() const { return feet_; }          ///< of those points
  std::span<const double> weights() const { return weights_; }  ///< of those points

 private:
  void add(const Vec3& position, const Eigen::Vector3f& normal, double weight);
  void add_points_of_face(const Corner& corner);
  void prefetch_after(const Index* vertex) const;
  void prefetch_after(const Corner* corner) const;

  const Origins& origins_;
  FootFinder finder_;
  const Index* vertices_end_;
  const Corner* corners_end_;
  std::vector<FootFinder::Point> points_;
  std::vector<double> weights_;
  std::vector<Foot> feet_;
};

}  // namespace whittle::polishing
