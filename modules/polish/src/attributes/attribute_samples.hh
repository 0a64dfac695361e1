#pragma once

#include <vector>

#include "original/merged_points.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// Closest points between two surfaces that are cut open at their seams.
struct AttributeSamples {
  /// A point of the original, and its closest point on the mesh.
  struct Sample {
    ClosestFacePoint closest = no_closest_point;
    double weight = 0;
    Index wedge = invalid_index;  ///< wedge of the mesh that the point was merged into
  };

  std::vector<Sample> of_vertices;      ///< per vertex of the original
  std::vector<Sample> of_faces;         ///< per face of the original, at its centroid
  std::vector<SurfacePoint> of_wedges;  ///< per wedge of the mesh, its closest point on the original
};

AttributeSamples find_attribute_samples(const Origins& origins, const Surface& mesh, const detail::Workers& workers);

}  // namespace whittle::polishing
