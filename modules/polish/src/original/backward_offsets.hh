#pragma once

#include <span>
#include <vector>

#include "original/origins.hh"
#include "surface/surface_walk.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// How far the vertices of a mesh are from the original, and which way: for each vertex the vector from its foot, the
/// nearest point of the original, to itself. Zero where it is near. That is told by the plane through the nearest of
/// its origins; only for the others the foot is found.
class BackwardOffsets {
 public:
  /// Keeps references to the origins, and to what `mesh` refers to. \param near distance that is near
  /// \throw Cancelled
  BackwardOffsets(const Origins& origins, const Surface& mesh, double near, const detail::Workers& workers);

  std::span<const Vec3> positions() const { return mesh_.positions; }
  std::span<const Vec3> offsets() const { return offsets_; }

  /// At other positions. A vertex is also near if it can't be far by its offset before and by its move.
  /// \param near distance that is near, at least that from before \throw Cancelled
  std::vector<Vec3> after_moves(std::span<const Vec3> positions, double near, const detail::Workers& workers) const;

 private:
  template <class MayBeFar>
  std::vector<Vec3> offsets_at(std::span<const Vec3> positions, const MayBeFar& may_be_far,
                               const detail::Workers& workers) const;
  Vec3 offset(Index v, const Vec3& position) const;
  bool may_be_far(Index v, const Vec3& position, double near) const;

  const Origins& origins_;
  Surface mesh_;
  double near_;
  std::vector<Index> nearest_;  ///< per vertex the nearest of its origins, or `invalid_index`
  std::vector<Vec3> offsets_;
};

}  // namespace whittle::polishing
