#pragma once

#include <vector>

#include "whittle/engine/decimate.hh"

namespace whittle {

/// What a stage did, or several did one after the other.
struct StageReport {
  DecimateResult result{};                   ///< with threshold pairs, but without what is compared in the end
  RunSteps steps{};                          ///< where they are wanted
  std::vector<RefusedPair> refused_pairs{};  ///< if nothing more could be done; by the input's vertices
  double progress = 0;                       ///< of the run, that has been told. [0, 1]

  /// Adds the next stage. How it all stands in the end is what that one says.
  StageReport& operator+=(StageReport next);
};

}  // namespace whittle
