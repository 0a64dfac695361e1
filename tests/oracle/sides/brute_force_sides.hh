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

/// Which faces of a mesh without backs are left, and with how many sides.
class BruteForceSides {
 public:
  void add(const Triangle& face, int n_sides) { faces_.push_back({face, n_sides}); }
  void contract(Index survivor, Index removed);
  /// Of faces that coincide, the first that were added are left.
  /// \param there the surface: once for each face, whichever it is
  /// \return both sides of those that are left
  std::vector<Triangle> faces_left(const std::vector<Triangle>& there) const;

 private:
  struct Face {
    Triangle corners;  ///< now
    int n_sides;
  };
  std::vector<Face> faces_;
};

}  // namespace whittle::test
