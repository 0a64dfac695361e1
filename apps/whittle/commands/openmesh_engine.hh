#pragma once

#include <string>

#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// Decimates like `whittle::decimate`, by our cost modules, ModFlipGuardT and, with a least radius ratio,
/// ModRadiusRatioT in OpenMesh's stock DecimaterT. Differences:
///   - It ranks by costs that may be out of date. The result differs a little, and a limit of the cost would not hold.
///   - It asks guards when a collapse is queued. A few faces still turn over or get thin.
///   - Feature lines have no tolerance and may lose a loop.
///   - It doesn't tell what it refused: `rejections` stays 0.
///   - Normals and colours are not carried. `locked` and `order` of the options are ignored.
/// \pre the target has no limit of the cost
/// \param name of the mesh, for errors
/// \throw UnsupportedMesh if OpenMesh's half-edges can't hold a face
Decimation decimate_in_openmesh(const IndexedMesh& input, const std::string& name, const DecimateTarget& target,
                                const DecimateOptions& options);

}  // namespace whittle::app
