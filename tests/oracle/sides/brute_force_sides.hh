#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::test {

/// A mesh without the backs of its two-sided sheets, by definition.
struct OneSided {
  IndexedMesh mesh;          ///< of the attributes it has groups alone: those of both sides, as one
  std::vector<int> n_sides;  ///< of each face: 2 if it has a back, else 1
};

/// As it is if there are no sheets: then with all attributes. Takes O(F²).
OneSided brute_force_without_backs(const IndexedMesh& mesh);

}  // namespace whittle::test
