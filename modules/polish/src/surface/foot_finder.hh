#pragma once

#include <array>
#include <span>
#include <vector>

#include "surface/eight_floats.hh"
#include "surface/vertex_corners.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// |v|². Eigen's sum has another order on other processors.
inline float length_sq(const Eigen::Vector3f& v) { return v.x() * v.x() + (v.y() * v.y() + v.z() * v.z()); }

/// The foot of a point on a surface. Arrays of feet stay unset until all threads fill them.
struct Foot {
  Index face;    ///< `invalid_index`: the point has no foot
  float second;  ///< barycentric coordinate of the face's second corner
  float third;
  float distance;  ///< of the point from the face's plane, positive where the normal points
};
constexpr Foot no_foot{invalid_index, 0, 0, 0};

/// Finds the feet of points on a mesh. The candidates are the faces at a vertex near the point that hold the foot of
/// the perpendicular, and whose normals are less than 60° from the point's. The foot is in the nearest candidate.
class FootFinder {
 public:
  /// Keeps references to both.
  FootFinder(const std::vector<Triangle>& faces, const VertexCorners& corners);

  /// Sets the vertices' positions. Keeps a reference to them. \throw Cancelled
  void look_at(std::span<const Vec3> positions, const detail::Workers& workers);

  struct Query {
    Vec3 position;
    Eigen::Vector3f normal;  ///< of any length
    Index start;             ///< a vertex of the mesh near it; `invalid_index`: it has no foot
  };
  /// \param feet as many as queries
  void find(std::span<const Query> queries, std::span<Foot> feet) const;

 private:
  /// Up to eight faces at a vertex side by side, relative to the vertex: unit normals, and the gradients of the
  /// barycentric coordinates of the next corner and of the one after that. Zeros where there is no face.
  struct alignas(32) Octet {
    std::array<EightFloats, 3> normal, next, last;
  };
  class Lanes;

  void prefetch(Index start) const;
  void fill_octets(Index v);

  const std::vector<Triangle>& faces_;
  const VertexCorners& corners_;
  std::span<const Vec3> positions_;
  std::vector<Index> first_octet_;  ///< per vertex, and one more at the end
  LargeArray<Octet> octets_;
};

}  // namespace whittle::polishing
