#pragma once

#include <cstddef>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/repair.hh"

namespace whittle::io {

/// Narrow gaps between open borders, as rounding leaves them in files whose faces share no vertices.
struct BorderGaps {
  std::size_t n_vertices = 0;  ///< vertices that lie at a gap
  double widest = 0;           ///< distance across the widest one, model units

  /// A tolerance for `weld_gaps` that closes them, model units; 0 if there are none. Several vertices may meet at a
  /// gap, and lie farther from each other than each from the nearest.
  double tolerance() const { return 4 * widest; }
};

/// A vertex on an open border lies at a gap if a vertex on another face lies very near: nearer than a twentieth of the
/// shortest edge at either one, but not at the same place. Takes O(n log n) time in the number n of border vertices.
/// \pre positions are finite, every corner is below V
BorderGaps find_border_gaps(const IndexedMesh& mesh);

/// Welds vertices on open borders that lie near each other. What is welded to a vertex is the nearest, at most
/// `tolerance` away, and nearer than the shortest edge at either one. Two vertices of one face stay apart. No edge gets
/// a third face, by the rules of `weld_borders`. The vertex with the lowest number stays where it is. Then drops what
/// `repair` drops after welding.
/// \param tolerance model units, [0, ∞)
/// \param vertex_map if given, becomes V numbers: of each vertex in the result, `invalid_index` if it was dropped
/// \param threads largest number of threads; 0 = all cores. The result is the same for any number.
/// \return counts of each kind of repair
/// \pre positions are finite, every corner is below V, attribute arrays are empty or full, every vertex has a face
/// \throw std::invalid_argument for a tolerance that is negative or not finite
Repairs weld_gaps(IndexedMesh& mesh, double tolerance, std::vector<Index>* vertex_map = nullptr, unsigned threads = 0);

}  // namespace whittle::io
