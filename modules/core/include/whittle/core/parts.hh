#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// The parts of a mesh: faces connected over common vertices. Faces with two equal corners connect nothing.

namespace whittle {

struct Parts {
  std::size_t count = 0;
  /// Per vertex; `invalid_index` without a face. Parts are numbered by their lowest vertices.
  std::vector<Index> part_of;
};

/// Takes nearly linear time. \pre the faces' vertex numbers are below `n_vertices`.
Parts find_parts(std::size_t n_vertices, std::span<const Triangle> faces);

/// Per part, the diagonal of its bounding box, model units.
std::vector<double> part_diagonals(std::span<const Vec3> positions, const Parts& parts);

/// A mesh without some of its parts.
struct PrunedMesh {
  IndexedMesh mesh;                 ///< the other parts in their order, with attributes and `origins`
  std::vector<Index> vertex_map;    ///< from vertices of the input to vertices of `mesh`; `invalid_index` if dropped
  std::size_t n_dropped_parts = 0;  ///< number of parts below the size
  std::size_t n_dropped_faces = 0;  ///< number of their faces
};

/// Drops the parts whose box has a diagonal below `size`, with their vertices. Vertices of no part stay.
/// \param size model units, [0, ∞]
/// \throw std::invalid_argument for a size that is negative or not a number, or a vertex number out of range.
PrunedMesh without_small_parts(IndexedMesh mesh, double size);

}  // namespace whittle
