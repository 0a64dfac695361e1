#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "surface/face_neighbors.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle::polishing {

/// Least cosine between a face's normals before and after its corners were moved.
constexpr double least_turn_cosine = 0.2;

inline double cosine(const Vec3& a, const Vec3& b) { return a.dot(b) / std::sqrt(a.squaredNorm() * b.squaredNorm()); }

/// Limits of the faces of a polished mesh. No two neighbours may become a fold. No edge may become sharp unless it is a
/// feature, and no feature may stop being sharp. No face may become thin.
class FaceLimits {
 public:
  /// Keeps a reference to `neighbors`.
  /// \param features edges that should be sharp; entries that are not edges of two faces are ignored
  /// \param feature_angle_deg between the normals at an edge, above which the edge is sharp; none: no edge is sharp
  /// \param min_radius_ratio below which a face is thin; faces with nearly no area always are
  FaceLimits(const FaceNeighbors& neighbors, std::span<const VertexPair> features,
             std::optional<double> feature_angle_deg, double min_radius_ratio = 0);

  /// Whether only folds (edges of more than 120°) are forbidden between neighbours.
  bool only_folds() const { return is_feature_.empty(); }

  /// Least cosine between the normals of two faces whose edge is neither sharp nor a fold.
  double least_cosine() const { return std::max(least_cosine_, least_fold_cosine); }

  /// The face beyond a side, or `invalid_index`.
  Index beyond(Index face, Index slot) const { return neighbors_.beyond(face, slot).face; }

  /// Whether a face may not go from one radius ratio to another.
  bool forbid_thinning(double before, double after) const { return after < min_radius_ratio_ && after < before; }
  /// Whether the face (corner, x, y) may be thin. Rules most faces out without taking a root.
  /// \param normal_sq squared length of (x − corner) × (y − corner), four times the squared area
  bool may_be_thin(double normal_sq, const Vec3& to_x, const Vec3& to_y) const {
    const double squares = to_x.squaredNorm() + to_y.squaredNorm();
    return normal_sq < wide_ * wide_ * squares * squares;
  }

  /// Whether a face and its neighbour may not turn to each other in this way.
  /// \param normal `normal(face, is_after)` is the normal of a face before or after, of any length
  template <class Normal>
  bool forbid(Index face, Index slot, const Normal& normal) const {
    const Index other = neighbors_.beyond(face, slot).face;
    if (other == invalid_index) return false;
    const auto cosine_of = [&](bool is_after) {
      const double between = cosine(normal(face, is_after), normal(other, is_after));
      return neighbors_.is_twisted(face, slot) ? -between : between;
    };
    const double after = cosine_of(true);
    const bool is_sharp = after < least_cosine_;
    if (only_folds() && !is_sharp) return false;
    const double before = cosine_of(false);
    if (after < least_fold_cosine && !(after >= before)) return true;
    return !only_folds() && is_sharp != (before < least_cosine_) && is_sharp != is_feature_[face][slot];
  }

  /// Scalar product of the normals of a face and its neighbour, one reversed if these are twisted. \pre there is a
  /// neighbour
  double along(Index face, Index slot, const Vec3& normal, const Vec3& other) const {
    return neighbors_.is_twisted(face, slot) ? -normal.dot(other) : normal.dot(other);
  }

 private:
  /// Cosine between the normals of two faces below which these are a fold.
  static constexpr double least_fold_cosine = -0.5;

  /// A face below this has nearly no area, and no reliable normal.
  static constexpr double least_radius_ratio = 1e-3;

  const FaceNeighbors& neighbors_;
  double least_cosine_;
  double min_radius_ratio_;
  double wide_;  ///< twice the area over the sum of two squared sides, from which on a face is surely not thin
  std::vector<std::array<bool, 3>> is_feature_;  ///< per side of a face; empty where no edge is sharp
};

}  // namespace whittle::polishing
