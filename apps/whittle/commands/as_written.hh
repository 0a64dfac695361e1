#pragma once

#include <optional>

#include "commands/simplify_options.hh"
#include "whittle/engine/decimate_target.hh"
#include "whittle/metrics/certify.hh"

namespace whittle::app {

/// The largest distances, both ways, of all points between an input and the file that a result is to be written to: as
/// the file is read again, with rounded coordinates.
struct DistancesAsWritten {
  metrics::LargestDistances surface;
  std::optional<metrics::LargestDistances> borders;  ///< none if neither has open borders
};

/// \param target where it limits the error, distances below are proven to be so
/// \return nothing if no face is left in the file
std::optional<DistancesAsWritten> distances_as_written(const IndexedMesh& input, const IndexedMesh& result,
                                                       const SimplifyCommand& options, const DecimateTarget& target,
                                                       const Talk& talk);

/// The greater of both, as far as it is proven.
double proven_distance(const metrics::LargestDistances& largest);

/// Whether they are proven to keep the limits of the error. \pre the target has them
bool are_within(const DecimateTarget& target, const DistancesAsWritten& distances);

}  // namespace whittle::app
