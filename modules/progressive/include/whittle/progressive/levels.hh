#pragma once

#include <functional>
#include <vector>

#include "whittle/simplify/simplify.hh"

namespace whittle::progressive {

/// What becomes of a mesh, for instance in a file that rounds coordinates.
using MeshMapping = std::function<IndexedMesh(const IndexedMesh&)>;

/// A level that is proven to be near to the input.
struct ProvenLevel : Simplification {
  double error = 0;  ///< each point of it, as it is written, is within this of the input, and each point of the input
                     ///< of it; model units
};

/// Levels of detail out of one run, of few faces within each error: the run goes down to the last face, each level is
/// found by bisection, to 1 % of its faces, and is polished where that keeps within the error.
/// \param errors model units, above 0, ascending
/// \param options `decimate.progress` is asked during the run alone
/// \param as_written what of each level is proven: the level itself if empty
/// \return a level an error; of all the input's faces if no other is proven. Fewer if the run is cancelled
/// \throw as `simplify`; std::invalid_argument for other errors; std::runtime_error if not even the input, as it is
///        written, is within one
std::vector<ProvenLevel> levels_within(const IndexedMesh& mesh, const std::vector<double>& errors,
                                       Effort effort = Effort::normal, const SimplifyOptions& options = {},
                                       const MeshMapping& as_written = {});

}  // namespace whittle::progressive
