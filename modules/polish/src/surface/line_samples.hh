#pragma once

#include <span>
#include <vector>

#include "surface/mesh_lines.hh"
#include "surface/surface_walk.hh"

namespace whittle {

/// Where a point of a line has come to lie on another mesh's lines.
struct LineFoot {
  Index edge = invalid_index;  ///< none where no line of that kind is near and runs the same way
  double share = 0;            ///< of the way along the edge
  Vec3 offset = Vec3::Zero();  ///< from there to the point
};

/// Points that stand for the lines of a mesh, two on each edge: where a function is linear on an edge, the sum of its
/// square over the points is the integral. And their feet on the lines of another mesh.
class LineSamples {
 public:
  /// \param vertex_map as `polish` says
  LineSamples(const MeshLines& lines, std::span<const Vec3> positions, std::span<const Index> vertex_map);

  void find_feet(const MeshLines& lines, const Surface& mesh, unsigned threads);

  /// How far lines are apart at the other mesh's vertices: the larger of the distances of points with feet on a vertex'
  /// edges from these, and of the vertex from the edges of these points. 0 where there are none.
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
    Vec3 from;     ///< of its edge
    Vec3 way;      ///< along the edge
    double share;  ///< of that
    Index start;   ///< a vertex of the other mesh near it
    bool is_border;
    double weight;

    Vec3 position() const { return from + share * way; }
  };

  static LineFoot find(const LineSample& sample, const MeshLines& lines, const Surface& mesh);

  std::vector<LineSample> samples_;
  std::vector<LineFoot> feet_;
};

}  // namespace whittle
