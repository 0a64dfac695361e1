#pragma once

#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// A corner of a front has one wedge, the same corner of its back another. \param back_wedges of each corner of `mesh`,
/// that of its back, or its own where it has none; wedges of `mesh`, too
/// \return whether any are different. Then corners have wedges that stand for both: their attributes are those of the
/// front, followed by those of the back
bool join_sides_of_wedges(std::span<const Index> back_wedges, IndexedMesh& mesh);

/// Undoes `join_sides_of_wedges`: gives a mesh twice as many wedges, first those of fronts, then those of backs, in the
/// same order. \param input what `mesh` was made from, with the attributes of one side
/// \param are_joined whether wedges stand for both sides; else both have the same attributes
/// \param turns_normals whether backs have the opposite normals of fronts, in any case
void part_sides_of_wedges(const IndexedMesh& input, bool are_joined, bool turns_normals, IndexedMesh& mesh);

}  // namespace whittle
