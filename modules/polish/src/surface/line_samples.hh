#pragma once

#include <span>
#include <vector>

#include "surface/mesh_lines.hh"
#include "surface/surface_walk.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// The closest point on a mesh's lines to a sample of another mesh's lines.
struct ClosestLinePoint {
  Index edge = invalid_index;  ///< `invalid_index`: no line of the same kind and direction is near
  double share = 0;            ///< where on the edge, 0 … 1
  Vec3 offset = Vec3::Zero();  ///< from there to the sample
};

/// Samples of the lines of a mesh, and their closest points on the lines of another mesh. Each edge has two samples. If
/// a function is linear on an edge, the weighted sum of its square over the samples is the integral. Features also have
/// samples without weight, at their vertices.
class LineSamples {
 public:
  /// \param vertex_map as for `polish`
  LineSamples(const MeshLines& lines, std::span<const Vec3> positions, std::span<const Index> vertex_map);

  /// \throw Cancelled
  void find_closest_points(const MeshLines& lines, const Surface& mesh, const detail::Workers& workers);

  /// Distance between the lines at each vertex of the other mesh: the larger of the distance of the samples whose
  /// closest points are on its edges, and of the vertex from the edges of these samples. 0 without such samples.
  std::vector<double> distances(const MeshLines& lines, std::span<const Vec3> positions) const;

  /// Calls `use(closest, weight)` for each sample with a closest point, always in the same order.
  template <class Use>
  void for_each_closest_point(const Use& use) const {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (closest_points_[i].edge != invalid_index) use(closest_points_[i], samples_[i].weight);
    }
  }

 private:
  struct LineSample {
    Vec3 from;     ///< start of its edge
    Vec3 way;      ///< from there to the end of the edge
    double share;  ///< where on the edge, 0 … 1
    Index start;   ///< vertex of the other mesh near it
    LineKind kind;
    double weight;

    Vec3 position() const { return from + share * way; }
  };

  static ClosestLinePoint find(const LineSample& sample, const MeshLines& lines, const Surface& mesh);

  std::vector<LineSample> samples_;
  std::vector<ClosestLinePoint> closest_points_;
};

}  // namespace whittle::polishing
