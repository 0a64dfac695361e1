#pragma once

#include <functional>
#include <vector>

#include "whittle/simplify/simplify.hh"

namespace whittle::progressive {

/// Whether a level, as it is written, is proven to be within a distance of the input, model units, and the input of it.
using LevelProof = std::function<bool(const Decimation& level, double distance)>;

/// A level proven to be near the input.
struct ProvenLevel : Simplification {
  double error = 0;  ///< largest distance that is proven, both ways, between the level as written and the input
};

/// Levels of detail from one run, with few faces within each error. The run goes down to the last face; each level is
/// found by bisection, to 1 % of its faces, and polished if that stays within the error.
/// \param errors model units, above 0, ascending
/// \param options `decimate.progress` is only called during the run
/// \param is_within the proof; empty: `metrics::certify` of the level itself
/// \return a level per error, with all faces of the input if no other is proven. Fewer if the run is cancelled
/// \throw as `simplify`; std::invalid_argument for other errors; std::runtime_error if even the input, as written, is
///        beyond an error
std::vector<ProvenLevel> levels_within(const IndexedMesh& mesh, const std::vector<double>& errors,
                                       Effort effort = Effort::normal, const SimplifyOptions& options = {},
                                       const LevelProof& is_within = {});

}  // namespace whittle::progressive
