#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/geometry/triangle.hh"

namespace whittle {

/// A bound, with room, on the rounding error of a distance; lengths are about 1. Proofs hold with this margin.
inline constexpr double distance_slack = 1e-14;

/// The face beyond each edge: from corner 0 to 1, from 1 to 2, from 2 to 0. `invalid_index` unless the edge has exactly
/// two faces.
using FacesBeyond = std::array<Index, 3>;

/// Faces with their neighbours, in a frame of about size 1. Views: the arrays must outlive it.
struct LinkedFaces {
  std::span<const Vec3> positions;
  std::span<const Triangle> faces;
  std::span<const FacesBeyond> beyond;  ///< per face
  std::span<const double> offsets;      ///< per face, added to its distance; or empty

  double offset(Index face) const { return offsets.empty() ? 0 : offsets[face]; }
  Corners corners(Index face) const { return corners_of(positions, faces[face]); }
};

/// A face at each vertex, or `invalid_index`.
std::vector<Index> face_at_each_vertex(std::span<const Triangle> faces, std::size_t n_vertices);

/// A face near a point.
struct NearFace {
  Index face = invalid_index;
  double distance = 0;  ///< including the face's offset
};

/// The target of proofs that triangles are near a surface.
class ProofTarget {
 public:
  virtual ~ProofTarget() = default;

  virtual LinkedFaces faces() const = 0;
  /// The nearest face. \param hint a face that may be near, or `invalid_index`: only the time depends on it
  virtual NearFace nearest(const Vec3& point, Index hint) const = 0;
};

/// Distance of a point from a triangle, at most 1e-15 too large by rounding. Corners may coincide.
double distance_to(const Corners& triangle, const Vec3& point);

}  // namespace whittle
