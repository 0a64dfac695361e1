#pragma once

#include <optional>
#include <span>

#include "whittle/metrics/lines.hh"

namespace whittle::metrics {

struct LineDistanceOptions {
  /// Samples on a segment are at most this far apart, over the greater diagonal of the boxes around both sets of lines.
  /// In [1e-6, 1].
  double spacing_rel = 1.0 / 2000.0;
  /// Threads to work with; 0 = all cores. No result depends on it.
  unsigned threads = 0;
};

/// From the points of one set of lines to the other set.
struct DirectedLineDistance {
  double mean = 0.0;  ///< Over the length of the lines, model units.
  /// Over the samples, model units: less than the one-sided Hausdorff distance by at most half the spacing.
  double max = 0.0;
};

/// How far two sets of lines are apart, both ways, in model units.
struct LineDistance {
  double mean = 0.0;  ///< Half the sum of both directions' means.
  double max = 0.0;   ///< The greater of both directions' largest distances: the Hausdorff distance, sampled.

  DirectedLineDistance forward;   ///< From the reference to the test lines.
  DirectedLineDistance backward;  ///< From the test lines to the reference.
};

/// Samples every segment at both ends and evenly between, and finds the exact nearest point of the other set for each
/// sample. Distances below 2^-48 of the greater of both diagonals are rounding noise and count as 0. Lines without any
/// length are weighted alike in the mean.
///
/// Nothing if either set is empty: there is no distance then, and 0 would be a lie.
/// \throw std::invalid_argument if a point is not finite, or `options` is out of range.
std::optional<LineDistance> line_distance(std::span<const Segment> reference, std::span<const Segment> test,
                                          const LineDistanceOptions& options = {});

}  // namespace whittle::metrics
