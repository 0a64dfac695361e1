#pragma once

#include <string>
#include <vector>

#include "whittle/pipeline/targets.hh"
#include "whittle/scene/scene.hh"
#include "whittle/simplify/simplify.hh"

// `--per-mesh`: each mesh of a glTF file is simplified on its own.

namespace whittle {

/// The target of each mesh (`SceneDocument::meshes_of_faces`), by its own counts. No count is above those of the mesh.
/// \param input before --prune \param diagonal of all
std::vector<DecimateTarget> targets_per_mesh(const Targets& options, const Scene& scene, double diagonal);

/// What the meshes may have together.
DecimateTarget sum_of(const std::vector<DecimateTarget>& targets);

/// The names of the meshes that have more faces and vertices than their targets say.
/// \param mesh the result
std::vector<std::string> meshes_above(const std::vector<DecimateTarget>& targets, const SceneDocument& document,
                                      const IndexedMesh& mesh);

/// Simplifies each mesh, and puts the results together: counts are sums, `max_cost` is the greatest, `stop` that of a
/// mesh that missed its target, if there is one.
/// \param input of several meshes \param options without `keep_steps` \return as `simplify`, without quadrics
Simplification simplify_per_mesh(const Scene& scene, const std::vector<DecimateTarget>& targets, Effort effort,
                                 const SimplifyOptions& options);

}  // namespace whittle
