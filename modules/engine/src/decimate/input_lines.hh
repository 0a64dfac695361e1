#pragma once

#include "complex/restraints.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// The feature edges by angle and those that the caller names, and the seams of the mesh. Some that the caller names
/// may be no edges of the mesh.
FeatureLines input_lines(const IndexedMesh& mesh, const DecimateOptions& options);

}  // namespace whittle
