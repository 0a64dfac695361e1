#pragma once

#include <optional>
#include <string>

#include "whittle/pipeline/run.hh"

namespace whittle {

/// How much longer than in what was looked at distances can be in the scene as it is shown.
struct Slack {
  double stretch = 1;  ///< `widest_stretch`
  double gap = 0;      ///< the file may have a vertex several times, and not quite at one place

  void add_to(metrics::LargestDistances& distances) const;
  /// The distance in what is looked at that keeps this one in the scene.
  double within(double limit) const;
};

/// What is read again of a result from the plan's output, and how far it is from the scene. Where the target limits the
/// error, distances below are proven to be so.
/// \return nothing if no face is left in the file \throw Cancelled
std::optional<DistancesAsWritten> distances_as_written(const Plan& plan, const Decimation& result,
                                                       const RunObserver& observer);

/// The steps of the proof: of the limits of the error, or, where there are none, of what is proven.
/// \throw std::runtime_error if the distances aren't proven after all; Cancelled
std::string certificate_as_written(const Plan& plan, const DistancesAsWritten& distances, const RunObserver& observer);

/// Whether they are proven to keep the limits of the error, and the tolerances of the scene's vertices.
/// \pre the target has them
bool keep_limits(const Plan& plan, const DistancesAsWritten& distances);

}  // namespace whittle
