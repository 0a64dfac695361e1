#pragma once

#include <optional>
#include <span>

#include "whittle/core/progress.hh"
#include "whittle/metrics/lines.hh"

namespace whittle::metrics {

struct LineDistanceOptions {
  /// Largest distance between samples on a segment, over the larger diagonal of the boxes around both sets of lines.
  /// [1e-6, 1].
  double spacing_rel = 1.0 / 2000.0;
  /// Threads to work with; 0 = all cores. The result is the same for any number.
  unsigned threads = 0;
  /// Gets the progress; returning false cancels with the exception `Cancelled`.
  ProgressCallback progress{};
};

/// From the points of one set of lines to the other set.
struct DirectedLineDistance {
  double mean = 0.0;  ///< Over the length of the lines, model units.
  /// Over the samples, model units. The one-sided Hausdorff distance is larger by at most half the spacing.
  double max = 0.0;
};

/// The distance between two sets of lines, both ways, in model units.
struct LineDistance {
  double mean = 0.0;  ///< Half the sum of both directions' means.
  double max = 0.0;   ///< The larger of both directions' maxima: the Hausdorff distance, sampled.

  DirectedLineDistance forward;   ///< From the reference to the test lines.
  DirectedLineDistance backward;  ///< From the test lines to the reference.
};

/// Samples every segment at both ends and evenly between them, and finds the exact closest point of the other set for
/// each sample. Distances below 2^-48 of the larger diagonal are rounding noise and count as 0. If no line has a
/// length, all have the same weight in the mean.
///
/// Empty if either set is empty: then there is no distance.
/// \throw std::invalid_argument if a point is not finite, or `options` is out of range.
/// \throw Cancelled if `options.progress` returned false.
std::optional<LineDistance> line_distance(std::span<const Segment> reference, std::span<const Segment> test,
                                          const LineDistanceOptions& options = {});

}  // namespace whittle::metrics
