#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "surface/face_neighbors.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle {

/// Least cosine between a face's normals before and after its corners were moved.
constexpr double least_turn_cosine = 0.2;

inline double cosine(const Vec3& a, const Vec3& b) { return a.dot(b) / std::sqrt(a.squaredNorm() * b.squaredNorm()); }

/// What a polished mesh' faces may not become. Neighbouring ones may not turn to each other so that it folds them, or
/// takes the edge between them over the angle that tells sharp edges from others, unless it becomes one of those that
/// are to be sharp. None may become thin.
class FaceLimits {
 public:
  /// Keeps a reference to `neighbors`.
  /// \param features edges that are to be sharp; what is no edge of two faces doesn't count
  /// \param feature_angle_deg between the normals; 180 = none are sharp
  /// \param min_radius_ratio below which a face is thin; faces with next to no area always are
  FaceLimits(const FaceNeighbors& neighbors, std::span<const VertexPair> features, double feature_angle_deg,
             double min_radius_ratio = 0);

  /// Whether neighbours may turn to each other but to folds: no edge may become sharper than 120°.
  bool only_folds() const { return is_feature_.empty(); }

  /// Between the normals of two faces, if the edge between them is neither to be sharp nor to be a fold.
  double least_cosine() const { return std::max(least_cosine_, least_fold_cosine); }

  /// The face on the other side, if any.
  Index beyond(Index face, Index place) const { return neighbors_.beyond(face, place).face; }

  /// Whether faces with such radius ratios may not come of others with these.
  bool forbid_thinning(double before, double after) const { return after < min_radius_ratio_ && after < before; }
  /// Whether a face (corner, x, y) may be thin: for one that is far from it, without a root.
  /// \param normal_sq four times the square of its area
  bool may_be_thin(double normal_sq, const Vec3& to_x, const Vec3& to_y) const {
    const double squares = to_x.squaredNorm() + to_y.squaredNorm();
    return normal_sq < wide_ * wide_ * squares * squares;
  }

  /// Whether a face and its neighbour may not turn to each other like that.
  /// \param normal gives the normal of a face, of any length, before or after: `normal(face, is_after)`
  template <class Normal>
  bool forbid(Index face, Index place, const Normal& normal) const {
    const Index other = neighbors_.beyond(face, place).face;
    if (other == invalid_index) return false;
    const auto cosine_of = [&](bool is_after) {
      const double between = cosine(normal(face, is_after), normal(other, is_after));
      return neighbors_.is_twisted(face, place) ? -between : between;
    };
    const double after = cosine_of(true);
    const bool is_sharp = after < least_cosine_;
    if (only_folds() && !is_sharp) return false;
    const double before = cosine_of(false);
    if (after < least_fold_cosine && !(after >= before)) return true;
    return !only_folds() && is_sharp != (before < least_cosine_) && is_sharp != is_feature_[face][place];
  }

  /// The normal of a face times that of its neighbour, one of them turned if need be. \pre there is one
  double along(Index face, Index place, const Vec3& normal, const Vec3& other) const {
    return neighbors_.is_twisted(face, place) ? -normal.dot(other) : normal.dot(other);
  }

 private:
  /// Below which two faces are nearly folded.
  static constexpr double least_fold_cosine = -0.5;

  /// Of faces that have an area one can see, and a normal.
  static constexpr double least_radius_ratio = 1e-3;

  const FaceNeighbors& neighbors_;
  double least_cosine_;
  double min_radius_ratio_;
  double wide_;  ///< twice the area over the sum of two sides' squares, from which on a face is not thin
  std::vector<std::array<bool, 3>> is_feature_;  ///< per side of a face; empty without sharp edges
};

}  // namespace whittle
