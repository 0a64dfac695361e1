#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "whittle/core/geometry/proof/verdict.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/progress.hh"

// Proofs about the largest distance between two surfaces, both ways: every point of each one, not samples.

namespace whittle::metrics {

struct CertifyOptions {
  unsigned threads = 0;  ///< 0 = all cores; the result is the same for any number
  /// Is told the progress; returning false cancels with the exception `Cancelled`.
  ProgressCallback progress{};
  /// Of each vertex of the first mesh, model units, positive; or empty. Each point of a face of the first surface is to
  /// be within the least tolerance of the face's corners of the second one, and each point of the second surface within
  /// that of some face of it. `max_distance` holds in any case.
  std::span<const double> tolerances{};
  /// Vertices of the first mesh → those of the second that they became, as `Decimation::vertex_map`; or empty. Names
  /// may be `invalid_index`. Only the time depends on it: proofs begin near the right faces, and rarely need a tree.
  std::span<const Index> vertex_map{};
};

struct LargestDistanceOptions {
  unsigned threads = 0;         ///< as above
  ProgressCallback progress{};  ///< as above
  /// If no point is farther than this, model units, what is proven is no more than this either. The accuracy is then a
  /// share of this: what is much nearer needn't be known as well.
  double limit = std::numeric_limits<double>::infinity();
};

/// A point of one surface, and how far it is from the other one.
struct FarPoint {
  bool is_on_first = true;  ///< whether it is a point of the first surface
  Index face = invalid_index;
  Vec3 point = Vec3::Zero();
  double distance = 0;  ///< model units, but for rounding
};

struct Certification {
  Verdict verdict = Verdict::undecided;
  std::optional<FarPoint> farther{};  ///< if refuted: a point that is farther
};

/// Proves that two surfaces are within a distance of each other, or finds a point that is farther.
///
/// A triangle of one surface is proven
/// - if its corners are within the distance of one face of the other surface: the distance from a point to a convex set
///   is convex, so it is greatest at a corner; or
/// - if faces of the other surface, connected over edges, cover it: none of their open edges lies over the triangle, an
///   odd number of them lies over some point of it, and over the triangle they are nowhere higher than the distance.
///   Then an odd number lies over each point.
/// Else it is split in two. Any triangles are allowed; edges with other than two faces count as open.
/// \param max_distance model units, not negative
/// \throw std::invalid_argument if a mesh has no faces, a face names a vertex that isn't there, a position is not
///        finite or above 3e150, the distance is negative or not a number, or tolerances or vertex_map have a wrong
///        length or name a vertex that isn't there. Cancelled
Certification certify(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                      const CertifyOptions& options = {});

/// The largest distance of the points of a surface from another one.
struct LargestDistance {
  double at_least = 0;  ///< that of `where`, model units
  double at_most = 0;   ///< proven
  FarPoint where{};
  std::size_t n_far_faces = 0;  ///< with a corner that is farther than 9/10 of `at_least`
};
/// Both ways: the greater of them is the Hausdorff distance.
struct LargestDistances {
  LargestDistance forward;   ///< of the first surface's points
  LargestDistance backward;  ///< of the second surface's points
};

/// Finds the largest distances by the tests of `certify`.
/// \param relative_accuracy of each, [1e-6, 1]: at_most is (1 + accuracy) at_least and a 10⁻⁹th of the size of both, or
///        less; with a limit, at_least and accuracy times the limit, if that is more. If that takes more than 65,536
///        pieces of a triangle, it is 4, 16, … times as inaccurate.
/// \throw as `certify`; std::invalid_argument if the accuracy is out of range
LargestDistances largest_distances(const IndexedMesh& first, const IndexedMesh& second, double relative_accuracy,
                                   const LargestDistanceOptions& options = {});

/// `certify` for the open borders of both surfaces, the edges with exactly one face: each point of either border is
/// within the distance of the other border. Proven if no mesh has any; refuted if only one has, by a point that is
/// infinitely far.
/// \throw as `certify`; std::invalid_argument if there are tolerances
Certification certify_borders(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                              const CertifyOptions& options = {});

/// `largest_distances` of the open borders. Nothing if no mesh has any. If only one has, its points are infinitely far,
/// and the other way is 0.
/// \throw as `largest_distances`
std::optional<LargestDistances> largest_border_distances(const IndexedMesh& first, const IndexedMesh& second,
                                                         double relative_accuracy,
                                                         const LargestDistanceOptions& options = {});

}  // namespace whittle::metrics
