#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/progress.hh"

namespace whittle::metrics {

struct DistanceOptions {
  /// Area-weighted samples on each of the two surfaces, [1, 2^40]. All vertices are measured, too.
  std::size_t samples = 500'000;
  /// Seed of the positions of samples; any value. Equal seeds give equal bytes.
  std::uint64_t seed = 1;
  /// Threads to work with; 0 = all cores. The result is the same for any number.
  unsigned threads = 0;
  /// Gets the progress; returning false cancels with the exception `Cancelled`.
  ProgressCallback progress{};
};

/// From the points of one surface to the other surface.
struct DirectedDistance {
  double mean = 0.0;     ///< Over the samples, model units.
  double mean_sq = 0.0;  ///< Mean of squares over the samples, model units squared.
  double rms = 0.0;      ///< sqrt(mean_sq), model units.
  double max = 0.0;      ///< Over samples and vertices: a lower bound of the one-sided Hausdorff distance, model units.

  /// Mean angle between the normals of the sample's face and of the nearest face, degrees, in [0, 180]. If the nearest
  /// face belongs to a two-sided sheet (two_sided.hh), the side with the smaller angle counts. Samples where either
  /// face has no normal don't count; 0 without any sample.
  double normal_deviation_deg = 0.0;
  /// Share of these samples with an angle above 90 degrees, percent, in [0, 100].
  double flipped_percent = 0.0;
};

/// The distance between two surfaces, both ways, in model units.
struct SurfaceDistance {
  double mean = 0.0;     ///< Half the sum of both directions' means.
  double mean_sq = 0.0;  ///< Half the sum of both directions' mean squares, model units squared.
  double rms = 0.0;      ///< sqrt(mean_sq).
  double max = 0.0;      ///< The larger of both directions' maxima: the Hausdorff distance, sampled.

  /// Garland & Heckbert's measure: the mean of the squared distances over all points X of both surfaces, vertices and
  /// samples alike, 1/(|Xr| + |Xt|) (sum over Xr of d²(v, test) + sum over Xt of d²(v, reference)). Model units
  /// squared. Source: Garland, Heckbert: Surface Simplification Using Quadric Error Metrics (1997), section 6.
  double garland_heckbert = 0.0;

  double normal_deviation_deg = 0.0;  ///< Mean of both directions.
  double flipped_percent = 0.0;       ///< Mean of both directions.
  double diagonal = 0.0;              ///< Of the reference's bounding box; `…_rel` numbers are divided by it.

  DirectedDistance forward;   ///< From the reference to the test surface.
  DirectedDistance backward;  ///< From the test surface to the reference.
};

/// Samples both surfaces, stratified by area, and finds the exact closest point on the other surface for each sample
/// and vertex. Distances below 2^-48 of the larger diagonal are rounding noise and count as 0. In a surface without
/// area all faces get the same number of samples.
/// \throw std::invalid_argument if a mesh has no faces, a face names a missing vertex, a position is not finite, or
///        `options` is out of range
/// \throw Cancelled if `options.progress` returned false
SurfaceDistance surface_distance(const IndexedMesh& reference, const IndexedMesh& test,
                                 const DistanceOptions& options = {});

/// The reference of several measurements: what is found out about it is kept, a search tree above all, which takes
/// several times the memory of the mesh.
class DistanceReference {
 public:
  /// \param mesh must outlive this
  explicit DistanceReference(const IndexedMesh& mesh) : mesh_(&mesh) {}

  /// `surface_distance(mesh, test, options)`, in less time from the second call on. Not to be called at the same time
  /// by several threads.
  SurfaceDistance to(const IndexedMesh& test, const DistanceOptions& options = {});

 private:
  struct Kept;

  const IndexedMesh* mesh_;
  std::shared_ptr<Kept> kept_;  ///< null before the first call
};

}  // namespace whittle::metrics
