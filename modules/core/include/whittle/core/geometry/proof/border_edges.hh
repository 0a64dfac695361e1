#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// The open borders of a mesh as degenerate triangles: each is the segment between its first two corners.
struct BorderEdges {
  IndexedMesh mesh;          ///< has all vertices of the mesh; empty if the mesh has no border
  std::vector<Index> faces;  ///< per edge, its face in the mesh
};

/// Edges with exactly one face, in the order of the faces and of their corners; each in the direction of its face.
/// \pre the vertex numbers are valid
BorderEdges border_edges_of(const IndexedMesh& mesh);

}  // namespace whittle
