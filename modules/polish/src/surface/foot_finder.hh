#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/vertex_corners.hh"

namespace whittle {

/// Where a point has come to lie on a surface.
struct Foot {
  Index face = invalid_index;  ///< none where no face nearby is below the point and faces the same way
  float second = 0;            ///< barycentric coordinate of the face's second corner
  float third = 0;
  float distance = 0;  ///< of the point from the face's plane, positive where the normal points
};

/// Finds the feet of points on a mesh: in the faces of a vertex near the point that one which holds the foot of the
/// perpendicular, the nearest of several. Only faces count whose normals are at less than 60° to the point's.
class FootFinder {
 public:
  /// Keeps references to both.
  FootFinder(const std::vector<Triangle>& faces, const VertexCorners& corners);

  /// Takes where the vertices are, for as long as they are there.
  void look_at(std::span<const Vec3> positions, unsigned threads);

  struct Query {
    Vec3 position;
    Eigen::Vector3f normal;  ///< of any length
    Index start;             ///< a vertex of the mesh near it, or `invalid_index`: then it has no foot
  };
  /// \param feet as many as queries
  void find(std::span<const Query> queries, std::span<Foot> feet) const;

 private:
  using EightFloats = std::array<float, 8>;
  /// Up to eight faces at a vertex side by side, as seen from there: normals, and the gradients of the barycentric
  /// coordinates of the next corner and of the one after that. Zeros for none.
  struct alignas(32) Octet {
    std::array<EightFloats, 3> normal, next, last;
  };
  class Lanes;

  void prefetch(Index start) const;
  void fill_octets(Index v);

  const std::vector<Triangle>& faces_;
  const VertexCorners& corners_;
  std::span<const Vec3> positions_;
  std::vector<Index> first_octet_;  ///< per vertex; one more at the end
  LargeArray<Octet> octets_;
};

}  // namespace whittle
