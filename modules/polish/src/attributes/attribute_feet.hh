#pragma once

#include <vector>

#include "original/merged_points.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// Where two surfaces that are cut open at their seams lie on each other.
struct AttributeFeet {
  /// A point of the original, and its foot on the mesh.
  struct Sample {
    Foot foot = no_foot;
    double weight = 0;
    Index wedge = invalid_index;  ///< of the mesh, that the point was merged into
  };

  std::vector<Sample> of_vertices;      ///< of the original
  std::vector<Sample> of_faces;         ///< of the original: of their centroids
  std::vector<NearestPoint> of_wedges;  ///< of the mesh: the nearest points of the original
};

AttributeFeet find_attribute_feet(const Origins& origins, const Surface& mesh, const detail::Workers& workers);

}  // namespace whittle::polishing
