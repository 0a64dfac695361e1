#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "commands/simplify/simplify_options.hh"
#include "files/input.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/decimate_target.hh"
#include "whittle/metrics/certify.hh"

namespace whittle::app {

/// The largest distances, both ways, of all points between an input and the file that a result is to be written to: as
/// the file is read again, with rounded coordinates.
struct DistancesAsWritten {
  IndexedMesh written;            ///< the file
  std::vector<Index> vertex_map;  ///< vertices of the input → those of the file, if it has as many as the result
  metrics::LargestDistances surface;
  std::optional<metrics::LargestDistances> borders;  ///< none if neither has open borders
};

/// \param target where it limits the error, distances below are proven to be so
/// \return nothing if no face is left in the file
std::optional<DistancesAsWritten> distances_as_written(const Input& input, const Decimation& result,
                                                       const SimplifyCommand& options, const DecimateTarget& target,
                                                       const Talk& talk);

/// The steps of the proof: of the limits of the error, or, where there are none, of what is proven.
/// \param tolerances of the input's vertices, or empty
/// \throw std::runtime_error if the distances aren't proven after all
std::string certificate_as_written(const IndexedMesh& input, const DistancesAsWritten& distances,
                                   const SimplifyCommand& options, const DecimateTarget& target,
                                   std::span<const double> tolerances, const Talk& talk);

/// The greater of both, as far as it is proven.
double proven_distance(const metrics::LargestDistances& largest);

/// Whether they are proven to keep the limits of the error. \pre the target has them
bool are_within(const DecimateTarget& target, const DistancesAsWritten& distances);

/// Whether they are proven to keep the tolerances of the input's vertices, too. \param tolerances may be empty
bool keeps_tolerances(const IndexedMesh& input, const DistancesAsWritten& distances, const SimplifyCommand& options,
                      const DecimateTarget& target, std::span<const double> tolerances);

}  // namespace whittle::app
