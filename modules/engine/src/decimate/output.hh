#pragma once

#include <vector>

#include "blocks/level.hh"
#include "whittle/core/frame.hh"
#include "whittle/engine/decimate.hh"

namespace whittle {

/// The mesh and the maps of a decimation, from the last pass after its contractions; `result` and `feature_edges` are
/// left to the caller.
/// \param remainder what the pass began with; null if that was the input
Decimation make_output(const IndexedMesh& input, const Remainder* remainder, Pass& pass, const Frame& frame,
                       const DecimateOptions& options);

/// What of the input's attributes is not carried.
std::vector<Warning> warnings_about_attributes(const IndexedMesh& input);

}  // namespace whittle
