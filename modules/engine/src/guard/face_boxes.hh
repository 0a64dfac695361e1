#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "complex/triangle_complex.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle {

/// A binary tree of boxes around all faces. Each leaf has a vertex's *own* faces: those of which it is the lowest
/// vertex. Vertices are numbered along a space-filling curve, so neighbouring leaves lie near each other. Merged
/// vertices leave empty boxes behind.
class FaceBoxes {
 public:
  explicit FaceBoxes(TriangleComplex& complex);

  /// Notes that faces at v have changed. To be called for each corner of a face that changed.
  void update(Index v);

  /// Calls `visit` with each vertex whose own faces' box overlaps `box`, until it returns false.
  template <class Visit>
  void visit(const FloatBox& box, const Visit& visit) const {
    std::array<std::size_t, 64> waiting;  // one a level, and the tree has fewer
    std::size_t n_waiting = 0;
    waiting[n_waiting++] = 1;
    while (n_waiting > 0) {
      const std::size_t node = waiting[--n_waiting];
      if (!nodes_[node].intersects(box)) continue;
      if (node >= n_leaves_) {
        if (!visit(static_cast<Index>(node - n_leaves_))) return;
        continue;
      }
      waiting[n_waiting++] = 2 * node + 1;
      waiting[n_waiting++] = 2 * node;
    }
  }

 private:
  FloatBox box_of_own_faces(Index v) const;

  TriangleComplex& complex_;
  std::size_t n_leaves_;         ///< a power of two
  std::vector<FloatBox> nodes_;  ///< the root is 1, the children of i are 2i and 2i + 1, the leaf of v is n_leaves_ + v
};

}  // namespace whittle
