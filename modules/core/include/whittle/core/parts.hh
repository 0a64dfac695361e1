#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

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
