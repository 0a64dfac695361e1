#pragma once

#include <string>

#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// Like `whittle::decimate`, by ModGarlandHeckbertT and ModFlipGuardT in OpenMesh's stock DecimaterT. It ranks by costs
/// that may be out of date, so that the result differs a little, and a limit of the cost would not hold; it doesn't
/// tell what it refused (`rejections` stays 0). Normals and colours are not carried; `locked` of the options is not
/// looked at. \pre the target has no `max_cost`. \param name of the mesh, for errors. \throw UnsupportedMesh if
/// OpenMesh's half-edges can't hold a face.
Decimation decimate_in_openmesh(const IndexedMesh& input, const std::string& name, const DecimateTarget& target,
                                const DecimateOptions& options);

}  // namespace whittle::app
