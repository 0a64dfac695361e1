#pragma once

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/decimate_target.hh"

namespace whittle {

/// Whether a result with plain quadrics may be nearer to the input, and is worth the time. So it is where the mesh has
/// 20,000 faces at most: of few faces, now one cost has the better ones, now the other. Up to 100,000 faces it is where
/// the result may be nearly exact: at most half of the vertices are bent, and a quarter of these, or more, may stay.
/// A vertex is bent whose faces lie in three planes or more, by a hundredth of a radian: it can't be contracted along a
/// plane or a straight edge.
bool is_worth_plain_quadrics(const IndexedMesh& mesh, const DecimateTarget& target);

}  // namespace whittle
