#pragma once

#include <array>
#include <span>
#include <vector>

#include "surface/surface_walk.hh"
#include "whittle/core/geometry/eight_floats.hh"

namespace whittle::polishing {

/// |v|². Eigen's sum has another order on other processors.
inline float length_sq(const Eigen::Vector3f& v) { return v.x() * v.x() + (v.y() * v.y() + v.z() * v.z()); }

/// The closest point on a mesh to a sample of the original.
struct ClosestFacePoint {
  Index face;    ///< `invalid_index`: there is none
  Index corner;  ///< index of the face among the corners at the vertex where it was found
  float second;  ///< barycentric coordinate of the face's second corner
  float third;
  float distance;  ///< signed distance of the sample from the face's plane, positive where the normal points
};
constexpr ClosestFacePoint no_closest_point{invalid_index, 0, 0, 0, 0};

/// Finds closest points on a mesh. Candidates are faces at a vertex near the sample, if the perpendicular from the
/// sample meets them and their normals are less than 60° from the sample's. The closest point is in the nearest
/// candidate.
class ClosestPointFinder {
 public:
  /// Keeps references to the data of `mesh`.
  explicit ClosestPointFinder(const Surface& mesh) : mesh_(mesh) {}

  struct Point {
    Vec3 position;
    Eigen::Vector3f normal;  ///< of any length
  };
  /// \param v a vertex of the mesh near all points \param closest_points one per point
  void find(Index v, std::span<const Point> points, std::span<ClosestFacePoint> closest_points);

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
