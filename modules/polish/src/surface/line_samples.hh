#pragma once

#include <span>
#include <vector>

#include "surface/mesh_lines.hh"
#include "surface/surface_walk.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// The foot of a point of a line on another mesh's lines.
struct LineFoot {
  Index edge = invalid_index;  ///< `invalid_index`: no line of the same kind and direction is near
  double share = 0;            ///< where on the edge, 0 … 1
  Vec3 offset = Vec3::Zero();  ///< from there to the point
};

/// Points that represent the lines of a mesh, and their feet on the lines of another mesh. Each edge has two points.
/// Where a function is linear on an edge, the weighted sum of its square over the points is the integral. Features also
/// have points without weight, at their vertices.
class LineSamples {
 public:
  /// \param vertex_map as `polish` says
  LineSamples(const MeshLines& lines, std::span<const Vec3> positions, std::span<const Index> vertex_map);

  /// \throw Cancelled
  void find_feet(const MeshLines& lines, const Surface& mesh, const detail::Workers& workers);

  /// Per vertex of the other mesh, how far the lines are apart there: the larger of the distance of the points whose
  /// feet are on its edges, and the distance of the vertex from the edges of these points. 0 where there are no such
  /// points.
  std::vector<double> distances(const MeshLines& lines, std::span<const Vec3> positions) const;

  /// Calls `use(foot, weight)` for each point that has a foot, always in the same order.
  template <class Use>
  void for_each_foot(const Use& use) const {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (feet_[i].edge != invalid_index) use(feet_[i], samples_[i].weight);
    }
  }

 private:
  struct LineSample {
    Vec3 from;     ///< start of its edge
    Vec3 way;      ///< from there to the end of the edge
    double share;  ///< where on the edge, 0 … 1
    Index start;   ///< a vertex of the other mesh near it
    LineKind kind;
    double weight;

    Vec3 position() const { return from + share * way; }
  };

  static LineFoot find(const LineSample& sample, const MeshLines& lines, const Surface& mesh);

  std::vector<LineSample> samples_;
  std::vector<LineFoot> feet_;
};

}  // namespace whittle::polishing
