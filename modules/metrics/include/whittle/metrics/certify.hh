#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "whittle/core/geometry/proof/verdict.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/progress.hh"

// Proofs about the largest distance between two surfaces, both ways: for every point of each surface, not samples.

namespace whittle::metrics {

struct CertifyOptions {
  unsigned threads = 0;  ///< 0 = all cores; the result is the same for any number
  /// Gets the progress; returning false cancels with the exception `Cancelled`.
  ProgressCallback progress{};
  /// Per vertex of the first mesh, model units, positive; or empty. Then each point of a face of the first surface must
  /// be within the least tolerance of the face's corners of the second surface, and each point of the second surface
  /// within that tolerance of some face of the first. `max_distance` holds in any case.
  std::span<const double> tolerances{};
  /// For each vertex of the first mesh its vertex in the second, as `Decimation::vertex_map`, or `invalid_index`; or
  /// empty. Only the time depends on it: proofs begin near the right faces, and rarely need a tree.
  std::span<const Index> vertex_map{};
};

struct LargestDistanceOptions {
  unsigned threads = 0;         ///< as above
  ProgressCallback progress{};  ///< as above
  /// If no point is farther than this, the proven distance isn't either; model units. The accuracy is then a share of
  /// this, so that much nearer points take less time.
  double limit = std::numeric_limits<double>::infinity();
};

/// A point of one surface, and its distance from the other.
struct FarPoint {
  bool is_on_first = true;  ///< whether it is a point of the first surface
  Index face = invalid_index;
  Vec3 point = Vec3::Zero();
  double distance = 0;  ///< model units, up to rounding
};

struct Certification {
  Verdict verdict = Verdict::undecided;
  std::optional<FarPoint> farther{};  ///< if refuted: a farther point
};

/// Proves that two surfaces are within a distance of each other, or finds a farther point.
///
/// A triangle of one surface is proven
/// - if its corners are within the distance of one face of the other surface: the distance from a point to a convex set
///   is convex, so it is greatest at a corner; or
/// - if faces of the other surface, connected over edges, cover it: none of their open edges lies over the triangle, an
///   odd number of them lies over some point of it, and over the triangle they are nowhere higher than the distance.
///   Then an odd number lies over each point.
/// Else it is split in two. Any triangles are allowed; edges with other than two faces count as open.
/// \param max_distance model units, not negative
/// \throw std::invalid_argument if a mesh has no faces, a face names a missing vertex, a position is not finite or
///        above 3e150, the distance is negative or not a number, or tolerances or vertex_map have a wrong length or
///        name a missing vertex. Cancelled
Certification certify(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                      const CertifyOptions& options = {});

/// The largest distance of the points of a surface from another surface.
struct LargestDistance {
  double at_least = 0;  ///< distance of `where`, model units
  double at_most = 0;   ///< proven bound, model units
  FarPoint where{};
  std::size_t n_far_faces = 0;  ///< number of faces with a corner farther than 9/10 of `at_least`
};
/// The largest distances both ways; the larger one is the Hausdorff distance.
struct LargestDistances {
  LargestDistance forward;   ///< of the first surface's points
  LargestDistance backward;  ///< of the second surface's points
};

/// Finds the largest distances by the tests of `certify`.
/// \param relative_accuracy of each, [1e-6, 1]: at_most is at most (1 + accuracy) at_least plus a 10⁻⁹th of the size of
///        both; with a limit, at_least plus accuracy times the limit, if that is more. If that takes more than 65,536
///        pieces of a triangle, it is 4, 16, … times as inaccurate.
/// \throw as `certify`; std::invalid_argument if the accuracy is out of range
LargestDistances largest_distances(const IndexedMesh& first, const IndexedMesh& second, double relative_accuracy,
                                   const LargestDistanceOptions& options = {});

/// `certify` for the open borders of both surfaces, the edges with exactly one face: each point of either border is
/// within the distance of the other border. Proven if no mesh has a border; refuted by a point at infinite distance if
/// only one mesh has a border.
/// \throw as `certify`; std::invalid_argument if there are tolerances
Certification certify_borders(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                              const CertifyOptions& options = {});

/// `largest_distances` of the open borders. Empty if no mesh has a border. If only one mesh has a border, its distance
/// is infinite, and the other way's 0. \throw as `largest_distances`
std::optional<LargestDistances> largest_border_distances(const IndexedMesh& first, const IndexedMesh& second,
                                                         double relative_accuracy,
                                                         const LargestDistanceOptions& options = {});

}  // namespace whittle::metrics
