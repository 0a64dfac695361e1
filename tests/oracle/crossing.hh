#pragma once

#include <array>
#include <vector>
#include <whittle/core/indexed_mesh.hh>

namespace whittle::test {

/// All pairs of faces, without a common edge, of which a side of one clearly passes through the inside of the other:
/// not by rounding, nor as two faces do that touch or lie in one plane. Faces that enter each other by less than 1e-11
/// of their size touch. Faces without area cross nothing. Ascending. By the signs of volumes.
std::vector<std::array<Index, 2>> clear_crossings(const IndexedMesh& mesh);

}  // namespace whittle::test
