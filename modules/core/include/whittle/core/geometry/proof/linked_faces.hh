#pragma once

#include <array>
#include <span>

#include "whittle/core/geometry/triangle.hh"

namespace whittle {

/// What rounding may do to a distance, with room: lengths are about 1. Proofs hold with this to spare.
inline constexpr double distance_slack = 1e-14;

/// The face at the other side of each edge: from corner 0 to 1, from 1 to 2, from 2 to 0. `invalid_index` if the edge
/// has other than two faces.
using FacesBeyond = std::array<Index, 3>;

/// Faces that know their neighbours, in a frame of about the size 1. What it names must outlive it.
struct LinkedFaces {
  std::span<const Vec3> positions;
  std::span<const Triangle> faces;
  std::span<const FacesBeyond> beyond;  ///< of each face
  std::span<const double> offsets;      ///< how much farther each face counts as than it is; or empty

  double offset(Index face) const { return offsets.empty() ? 0 : offsets[face]; }
  Corners corners(Index face) const { return corners_of(positions, faces[face]); }
};

/// A face that comes near to a point.
struct NearFace {
  Index face = invalid_index;
  double distance = 0;  ///< with the face's offset
};

/// A surface that triangles are proven to be near to.
class ProofTarget {
 public:
  virtual ~ProofTarget() = default;

  virtual LinkedFaces faces() const = 0;
  /// The nearest face. \param hint a face that may be near, or `invalid_index`: only the time depends on it
  virtual NearFace nearest(const Vec3& point, Index hint) const = 0;
};

/// Distance of a point from a triangle, or more by rounding errors of 1e-15. Its corners may coincide.
double distance_to(const Corners& triangle, const Vec3& point);

}  // namespace whittle
