#pragma once

#include <span>
#include <vector>

#include "original/origins.hh"
#include "surface/surface_walk.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// For each vertex of a mesh, the vector from its closest point on the original to itself; zero where it is near. The
/// plane through the nearest of its origins shows that a vertex is near; the closest point is searched only otherwise.
class BackwardOffsets {
 public:
  /// Keeps references to the origins, and to the data of `mesh`.
  /// \param near distance up to which a vertex is near
  /// \throw Cancelled
  BackwardOffsets(const Origins& origins, const Surface& mesh, double near, const detail::Workers& workers);

  std::span<const Vec3> positions() const { return mesh_.positions; }
  std::span<const Vec3> offsets() const { return offsets_; }

  /// The offsets at other positions. A vertex is also near if its offset before and its move add up to no more.
  /// \param near distance up to which a vertex is near, at least that of the constructor \throw Cancelled
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
