#pragma once

#include <optional>

#include "commands/simplify_options.hh"
#include "whittle/metrics/certify.hh"

namespace whittle::app {

/// The largest distances, both ways, of all points between a mesh and the file that another one is to be written to:
/// as the file is read again, with rounded coordinates. \param limit as `LargestDistanceOptions::limit`
/// \return nothing if no face is left in the file
std::optional<metrics::LargestDistances> distances_as_written(const IndexedMesh& input, const IndexedMesh& result,
                                                              const SimplifyCommand& options,
                                                              std::optional<double> limit, const Talk& talk);

/// The greater of both, as far as it is proven.
double proven_distance(const metrics::LargestDistances& largest);

}  // namespace whittle::app
