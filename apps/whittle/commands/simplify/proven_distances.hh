#pragma once

#include <string>
#include <vector>

#include "whittle/pipeline/run.hh"

// The proven distances of a run, in messages.

namespace whittle::app {

/// The input of a run and its result, as messages name them.
struct NamesOfRun {
  std::string input;
  std::string output;
  double diagonal = 0;  ///< of the input's bounding box
};

/// The request, and a line for each way, of the surface and of the borders: the proven distance and the farthest point.
std::vector<std::string> distance_lines(const DistancesAsWritten& distances, const DecimateTarget& target,
                                        const NamesOfRun& names);

}  // namespace whittle::app
