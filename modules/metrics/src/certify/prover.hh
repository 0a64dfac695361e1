#pragma once

#include "certify/patch.hh"
#include "whittle/metrics/certify.hh"

namespace whittle::metrics {

/// A point of a triangle that is far from a surface.
struct FarthestPoint {
  Vec3 point = Vec3::Zero();
  double distance = -1;  ///< none if negative
};

/// Proves that triangles are within a distance of a surface.
class Prover {
 public:
  explicit Prover(const TargetSurface& surface) : surface_(surface), patch_(surface) {}

  /// Proves that each point of a triangle is within a distance, or finds one that is farther. Undecided: a point is as
  /// far but for rounding, or it takes too many pieces. \param farthest of the points looked at
  Verdict prove(const Corners& triangle, double distance, FarthestPoint& farthest);

  /// Finds the farthest point of a triangle, as far as it is farther than `from`.
  /// \return a distance that all points are proven to be within: `1 + accuracy` times that of the point found, or of
  ///         `from`, and a 10⁻⁹th; more if that takes too many pieces
  double find_farthest(const Corners& triangle, double from, double accuracy, FarthestPoint& farthest);

 private:
  struct Piece {
    Corners corners;
    Index hint;  ///< a face of the surface that may be near
  };

  template <class Limit, class Decide>
  Verdict search(const Corners& triangle, const Limit& limit, const Decide& decide, FarthestPoint& farthest);
  double distance_from_one(const Corners& corners, Index face) const;
  void split(const Corners& corners, Index hint);

  const TargetSurface& surface_;
  Patch patch_;
  Index hint_ = invalid_index;  ///< the face found last
  std::vector<Piece> pieces_;
};

}  // namespace whittle::metrics
