#pragma once

#include <string>

#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// Decimates like `whittle::decimate`, by our cost modules and ModFlipGuardT in OpenMesh's stock DecimaterT.
/// Differences:
///   - It ranks by costs that may be out of date. The result differs a little, and a cost limit would not hold.
///   - It asks the guard when a collapse is queued, not in its turn. A few faces still turn over.
///   - It doesn't count refusals: `refusals` stays 0.
///   - Normals and colours are not carried.
/// Of the options it follows `cost`, `quadric`, `isotropy`, `valence_weight`, `boundary`, `max_normal_flip_deg` and
/// `progress`. It ignores `order`, `pairs`, `topology`, `min_radius_ratio`, `refuse_intersections`, `locked`,
/// `feature_angle_deg`, `feature_tolerance`, `feature_edges`, `normals`, `keep_quadrics`, `listener` and `threads`. On
/// the command line `--engine openmesh` refuses the ones that change results. Lost normals are a warning.
/// \pre the target has no cost limit
/// \param name of the mesh, for errors
/// \throw UnsupportedMesh if OpenMesh's half-edges can't hold a face
Decimation decimate_in_openmesh(const IndexedMesh& input, const std::string& name, const DecimateTarget& target,
                                const DecimateOptions& options);

}  // namespace whittle::app
