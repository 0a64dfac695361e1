#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::report {

/// Signed distances of the points of a surface from another surface; below 0 where the other surface lies behind. They
/// are interpolated linearly on the faces of `mesh`: the faces of the surface, cut into smaller ones where distances
/// aren't linear. The sign keeps them linear where the surfaces cross.
struct DistanceMap {
  IndexedMesh mesh;                      ///< positions and faces alone; the surface's vertices come first
  std::vector<double> signed_distances;  ///< per vertex of `mesh`, model units
  double max = 0;                        ///< largest distance, model units
  double usual = 0;                      ///< upper bound for 99 % of the area, model units; at most `max`
  /// Upper bound on the error of interpolation for 95 % of the area, from a sample; unit of
  /// `DistanceMapOptions::tolerance`.
  double deviation = 0;

  /// The cuts, in rounds. The first round has the faces of the surface, each later round the parts of faces cut in the
  /// round before. A byte per face: bit k, the edge from corner k on is cut in its middle; the first cut of an edge
  /// adds a vertex. `parts_of` gives the parts.
  std::vector<std::vector<std::uint8_t>> rounds;
};

struct DistanceMapOptions {
  /// Accuracy of interpolation, about this share of `DistanceMap::usual`, or of the distance if that is larger; (0, 1].
  double tolerance = 1.0 / 10;
  /// Distance between sample points of a face, model units; the middles of its edges are always sampled. About the
  /// length of the other surface's edges is good: narrower peaks may be missed.
  double spacing = std::numeric_limits<double>::infinity();
  /// Largest number of faces. If it is reached, the faces farthest from linear are cut.
  std::size_t most_faces = 4'000'000;
  unsigned threads = 0;  ///< 0 = all cores; the result doesn't depend on it
};

/// \throw std::invalid_argument if the mesh has no faces, or for a tolerance or a spacing out of range
DistanceMap distance_map(const IndexedMesh& mesh, const TriangleTree& other, const DistanceMapOptions& options = {});

/// Shares of the area, [0, 1], with distances in each of `n` equal parts of [0, max]; each vertex stands for a third of
/// its faces. \pre n > 0
std::vector<double> distance_histogram(const DistanceMap& map, double max, std::size_t n);

}  // namespace whittle::report
