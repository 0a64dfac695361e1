#pragma once

#include <string>

#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// Decimates like `whittle::decimate`, by our cost modules, ModFlipGuardT and, with a least radius ratio,
/// ModRadiusRatioT in OpenMesh's stock DecimaterT. Differences:
///   - It ranks by costs that may be out of date. The result differs a little, and a cost limit would not hold.
///   - It asks the guards when a collapse is queued, not in its turn. A few faces still turn over or get thin.
///   - It doesn't count refusals: `rejections` stays 0.
///   - Normals and colours are not carried. `locked`, `order` and the options of feature lines are ignored.
/// \pre the target has no cost limit
/// \param name of the mesh, for errors
/// \throw UnsupportedMesh if OpenMesh's half-edges can't hold a face
Decimation decimate_in_openmesh(const IndexedMesh& input, const std::string& name, const DecimateTarget& target,
                                const DecimateOptions& options);

}  // namespace whittle::app
