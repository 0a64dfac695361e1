#pragma once

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/decimate_target.hh"

namespace whittle {

/// Share of the vertices that can't be contracted along a plane or a straight edge: those whose faces lie in three
/// planes or more, by a hundredth of a radian. [0, 1]
double bent_share(const IndexedMesh& mesh);

/// Whether a result may be nearly exact, as far as the input tells: parts are flat, and a quarter of the bent vertices,
/// or more, may stay. Larger meshes are not looked at: 100,000 faces at most.
bool may_be_nearly_exact(const IndexedMesh& mesh, const DecimateTarget& target);

}  // namespace whittle
