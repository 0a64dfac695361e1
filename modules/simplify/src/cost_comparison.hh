#pragma once

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/decimate_target.hh"

// The cost comparison: on small and on mostly flat meshes, simplify also runs with plain quadrics and takes the result
// that is nearer to the input.

namespace whittle {

/// Whether a second run with plain quadrics may give a nearer result, and is worth the time. It is for meshes with at
/// most 20,000 faces: with few faces either cost may be better. Up to 100,000 faces it is if the result may be nearly
/// exact: at most half of the vertices are bent, and at least a quarter of these may stay. A bent vertex has faces in
/// three planes or more, by a hundredth of a radian, so it can't be contracted along a plane or a straight edge. Never
/// with a limit of cost or error.
bool is_worth_plain_quadrics(const IndexedMesh& mesh, const DecimateTarget& target);

/// Whether `a` is nearer to `input` than `b`, by the mean distance of 2,000 points of each surface from the other
/// surface, both ways. False if a mesh has no area, or coordinates are out of a tree's range.
bool is_nearer(const IndexedMesh& input, const IndexedMesh& a, const IndexedMesh& b);

}  // namespace whittle
