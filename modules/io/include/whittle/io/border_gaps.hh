#pragma once

#include <cstddef>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/repair.hh"

namespace whittle::io {

/// Narrow gaps between open borders, which rounding leaves in files whose faces share no vertices.
struct BorderGaps {
  std::size_t n_vertices = 0;  ///< vertices that lie at a gap
  double widest = 0;           ///< width of the widest gap, model units

  /// A tolerance for `weld_gaps` that closes all gaps, model units; 0 without gaps. Larger than `widest`, as several
  /// vertices may meet at a gap.
  double tolerance() const { return 4 * widest; }
};

/// A vertex on an open border lies at a gap if a vertex of another face is nearer than a twentieth of the shortest edge
/// at either one, but not at the same position. Takes O(n log n) time in the number n of border vertices.
/// \pre positions are finite, every corner is below V
BorderGaps find_border_gaps(const IndexedMesh& mesh);

/// Welds vertices on open borders to their nearest vertex, if it is at most `tolerance` away, and nearer than the
/// shortest edge at either one. Two vertices of one face stay apart. No edge gets a third face, by the rules of
/// `weld_borders`. The vertex with the lowest number keeps its position. Then drops faces and vertices like `repair`
/// after welding.
/// \param tolerance model units, [0, ∞)
/// \param vertex_map if given, gets V numbers: the new number of each vertex, `invalid_index` if it was dropped
/// \param threads largest number of threads; 0 = all cores. The result is the same for any number.
/// \return counts of each kind of repair
/// \pre positions are finite, every corner is below V, attribute arrays are empty or full, every vertex has a face
/// \throw std::invalid_argument for a tolerance that is negative or not finite
Repairs weld_gaps(IndexedMesh& mesh, double tolerance, std::vector<Index>* vertex_map = nullptr, unsigned threads = 0);

}  // namespace whittle::io
