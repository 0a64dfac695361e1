#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// Items of a corner besides its vertex: numbers of values of the file, or `invalid_index`.
struct CornerItems {
  Index texcoord = invalid_index;
  Index normal = invalid_index;
  bool operator==(const CornerItems&) const = default;
};

/// The texture coordinates and normals that corners of faces name.
struct CornerValues {
  std::vector<CornerItems> corners;  ///< 3F, or empty: no corner names any
  Attribute texcoords{.name = "texcoord", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}};
  std::vector<std::array<float, 3>> normals;
};

/// Gives a mesh the values of its corners. A vertex gets a wedge for each different value at its corners; a corner
/// without a value has zeros. Without a second wedge at any vertex there is no table. Attributes of vertices are copied
/// to their wedges. \pre the mesh has no table, and no normals if corners name some
void set_corner_values(IndexedMesh& mesh, CornerValues values);

/// The normals of corners as one per vertex: where they differ, the sum of the different ones.
/// \param are_summed becomes true if some differ
void set_vertex_normals(IndexedMesh& mesh, const CornerValues& values, bool& are_summed);

}  // namespace whittle::io
