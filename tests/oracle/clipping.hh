#pragma once

#include <array>
#include <vector>
#include <whittle/core/indexed_mesh.hh>

namespace whittle::test {

/// All pairs of faces that share more than their common corners allow (self_intersections.hh), ascending. Each pair is
/// tested by clipping one face to the other in rational numbers. \pre positions are whole numbers from −8 to 8
std::vector<std::array<Index, 2>> intersections_by_clipping(const IndexedMesh& mesh);

}  // namespace whittle::test
