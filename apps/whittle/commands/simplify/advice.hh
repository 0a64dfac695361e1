#pragma once

#include <string>

#include "whittle/simplify/simplify.hh"

namespace whittle::app {

/// What stands in the way of the pairs that are left, the most frequent reason first: "12 by topology, 3 by turning a
/// face". Empty if no pair is left.
std::string reasons_at_end(const RefusalCounts& refused);

/// Which option gets nearer to a target that was missed. Each option that lifts a reason is tried, so what is said of
/// it is true: on the input, or from the result on if the input is large. \param options those of the run
/// \param keeps_meshes of a glTF file: then --weld and --threshold aren't taken
std::string advice(const IndexedMesh& input, const Decimation& result, const DecimateTarget& target,
                   const DecimateOptions& options, bool keeps_meshes);

}  // namespace whittle::app
