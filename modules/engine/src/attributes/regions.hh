#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// What parts a surface, for attributes.
enum class Break {
  seam,      ///< seams (`seam_edges`): the parts are charts
  any_wedge  ///< also where shading breaks: within each part all attributes are continuous
};

/// The part of each face: the number of its first face. Parts are connected over edges of two faces.
std::vector<Index> surface_regions(const IndexedMesh& mesh, Break at);

}  // namespace whittle
