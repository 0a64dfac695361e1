#pragma once

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Whether `a` is nearer to `input` than `b`: by the mean distance of 2,000 points of each surface from the other one,
/// both ways. False where that can't be told: a mesh has no area, or coordinates are out of a tree's range.
bool is_nearer(const IndexedMesh& input, const IndexedMesh& a, const IndexedMesh& b);

}  // namespace whittle
