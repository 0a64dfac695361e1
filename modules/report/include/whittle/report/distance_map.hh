#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::report {

/// How far each point of a surface is from another surface. A signed distance is below 0 where the other surface
/// lies behind. It is linear across each face of a mesh, which has the faces of the surface, cut into smaller ones
/// where that is not so. Where the surfaces cross, distances are not linear, and signed ones are.
struct DistanceMap {
  IndexedMesh mesh;                      ///< positions and faces alone; the vertices of the surface come first
  std::vector<double> signed_distances;  ///< of its vertices, model units
  double max = 0;                        ///< greatest distance, model units
  double usual = 0;                      ///< nearer than this is 99 % of the area, model units; at most `max`
  double deviation = 0;  ///< of 95 % of the area, interpolated distances are not farther off: in the unit of
                         ///< `DistanceMapOptions::tolerance`, from a sample

  /// How the faces were cut, in rounds. The first one begins with the faces of the surface, each other one with the
  /// parts of those that were cut in the round before. A byte a face: bit k, the edge from corner k on is cut in its
  /// middle, which is a new vertex where that edge comes first. `parts_of` says what the parts are.
  std::vector<std::vector<std::uint8_t>> rounds;
};

struct DistanceMapOptions {
  /// Between the vertices distances are interpolated, to about this share of `DistanceMap::usual`, or of the distance
  /// where that is greater; in (0, 1].
  double tolerance = 1.0 / 10;
  /// How near to each other the points of a face are that are looked at, model units; at least the middles of its
  /// edges. About the length of the other surface's edges is good. Narrower peaks may be missed.
  double spacing = std::numeric_limits<double>::infinity();
  /// Where there would be more faces, those are cut that are farthest from linear.
  std::size_t most_faces = 4'000'000;
  unsigned threads = 0;  ///< 0 = all cores; the result doesn't depend on it
};

/// \throw std::invalid_argument if the mesh has no faces, or for a tolerance or a spacing out of range
DistanceMap distance_map(const IndexedMesh& mesh, const TriangleTree& other, const DistanceMapOptions& options = {});

/// Shares of the area, [0, 1], of which the distance is in each of `n` equal parts of [0, max]; each vertex stands for
/// a third of its faces. \pre n > 0
std::vector<double> distance_histogram(const DistanceMap& map, double max, std::size_t n);

}  // namespace whittle::report
