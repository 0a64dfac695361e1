#pragma once

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Whether each face is a chart of its own on a texture: texture coordinates differ between the two faces of each inner
/// edge, at one of its ends at least.
bool has_chart_per_face(const IndexedMesh& mesh);

}  // namespace whittle
