#pragma once

#include <span>
#include <vector>

#include "surface/simplified_surface.hh"
#include "surface/surface_samples.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// How far the vertices of a simplified mesh are from the original, and which way.
class BackwardOffsets {
 public:
  /// Keeps references to what `original` refers to, and to `samples`. \param positions of the mesh's vertices
  /// \throw Cancelled
  BackwardOffsets(const SimplifiedSurface& original, const SurfaceSamples& samples, std::span<const Vec3> positions,
                  const detail::Workers& workers);

  /// For each vertex the vector from its foot, the nearest point of the original, to itself. Zero where the vertex is
  /// near. That is told by the plane through the nearest of the original's vertices that were merged into it; only for
  /// the others the foot is found. \param near distance that is near
  /// \throw Cancelled
  std::vector<Vec3> at(std::span<const Vec3> positions, double near, const detail::Workers& workers) const;

 private:
  SimplifiedSurface original_;
  const SurfaceSamples& samples_;
  std::vector<Index> origins_;  ///< per vertex the nearest of those merged into it, or `invalid_index`
};

}  // namespace whittle::polishing
