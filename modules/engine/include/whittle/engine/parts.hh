#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "whittle/engine/indexed_mesh.hh"

// The parts of a mesh: what hangs together over common vertices. Faces with two equal corners hold nothing together.

namespace whittle {

struct Parts {
  std::size_t count = 0;
  std::vector<Index> part_of;  ///< by vertex, numbered from 0 by their lowest vertices; `invalid_index` without a face
};

/// In all but linear time. \pre the faces' vertex numbers are below `n_vertices`.
Parts find_parts(std::size_t n_vertices, std::span<const Triangle> faces);

/// Of each part the diagonal of the box around its vertices, model units.
std::vector<double> part_diagonals(std::span<const Vec3> positions, const Parts& parts);

struct GapSearch {
  /// Gaps not below this are not looked for and given as ∞, model units. [0, ∞]. Where two surfaces run in parallel, a
  /// vertex is compared with the more of the other's the wider the gap is beside its edges.
  double max_gap = std::numeric_limits<double>::infinity();
  unsigned threads = 0;  ///< 0 = all cores. The result does not depend on it.
};

/// Of each part the least distance from one of its vertices to a vertex of another, model units; ∞ if there is none.
/// Distances between vertices, not between faces: where parts are coarse, their surfaces may be much nearer.
///
/// By a kd-tree that knows which of its branches lie in one part.
/// \param parts those of `mesh`
/// \throw std::invalid_argument for a `max_gap` that is negative or not a number, or, if there are several parts, a
///        coordinate that isn't finite.
std::vector<double> gaps_between_parts(const IndexedMesh& mesh, const Parts& parts, const GapSearch& search = {});

/// A mesh without some of its parts.
struct PrunedMesh {
  IndexedMesh mesh;  ///< the others, each with all its attributes, in their order; `origins` says which they were
  std::vector<Index> vertex_map;    ///< input vertices → vertices of `mesh`; `invalid_index` of those dropped
  std::size_t n_dropped_parts = 0;  ///< the smaller ones
  std::size_t n_dropped_faces = 0;  ///< theirs
};

/// Drops the parts whose box has a diagonal below `size`, with their vertices. Vertices of no part stay.
/// \param size model units, [0, ∞]
/// \throw std::invalid_argument for a size that is negative or not a number, or a vertex number out of range.
PrunedMesh without_small_parts(IndexedMesh mesh, double size);

}  // namespace whittle
