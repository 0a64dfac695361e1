#pragma once

#include <array>
#include <span>
#include <vector>

#include "surface/surface_walk.hh"
#include "whittle/core/geometry/eight_floats.hh"

namespace whittle::polishing {

/// |v|². Eigen's sum has another order on other processors.
inline float length_sq(const Eigen::Vector3f& v) { return v.x() * v.x() + (v.y() * v.y() + v.z() * v.z()); }

/// The foot of a point on a surface.
struct Foot {
  Index face;    ///< `invalid_index`: the point has no foot
  Index corner;  ///< which of the corners at the vertex where it was found is one of this face
  float second;  ///< barycentric coordinate of the face's second corner
  float third;
  float distance;  ///< of the point from the face's plane, positive where the normal points
};
constexpr Foot no_foot{invalid_index, 0, 0, 0, 0};

/// Finds the feet of points on a mesh. The candidates are the faces at a vertex near the point that hold the foot of
/// the perpendicular, and whose normals are less than 60° from the point's. The foot is in the nearest candidate.
class FootFinder {
 public:
  /// Keeps references to what `mesh` refers to.
  explicit FootFinder(const Surface& mesh) : mesh_(mesh) {}

  struct Point {
    Vec3 position;
    Eigen::Vector3f normal;  ///< of any length
  };
  /// \param v a vertex of the mesh near all points \param feet as many as points
  void find(Index v, std::span<const Point> points, std::span<Foot> feet);

 private:
  /// Up to eight faces at a vertex side by side, relative to the vertex: unit normals, and the gradients of the
  /// barycentric coordinates of the next corner and of the one after that. Zeros where there is no face.
  struct alignas(32) Octet {
    std::array<detail::EightFloats, 3> normal, next, last;
  };
  class Lanes;

  void fill_octets(Index v);

  Surface mesh_;
  std::vector<Octet> octets_;  ///< scratch: at one vertex
};

}  // namespace whittle::polishing
