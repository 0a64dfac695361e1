#pragma once

#include <string>

#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// Like `whittle::decimate`, by our cost modules, ModFlipGuardT and, with a least radius ratio, ModRadiusRatioT in
/// OpenMesh's stock DecimaterT. It ranks by costs that may be out of date, so that the result differs a little, and a
/// limit of the cost would not hold; guards are asked when a collapse is queued, so that a few faces still turn over or
/// get thin, and feature lines have no tolerance and may lose a loop; it doesn't tell what it refused (`rejections`
/// stays 0). Normals and colours are not carried; `locked` and `order` of the options are not looked at. \pre the
/// target has no `max_cost`. \param name of the mesh, for errors. \throw UnsupportedMesh if OpenMesh's half-edges can't
/// hold a face.
Decimation decimate_in_openmesh(const IndexedMesh& input, const std::string& name, const DecimateTarget& target,
                                const DecimateOptions& options);

}  // namespace whittle::app
