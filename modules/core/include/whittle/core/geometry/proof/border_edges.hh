#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// The open borders of a mesh as triangles of which two corners are one: such a triangle is the segment between its
/// first two corners.
struct BorderEdges {
  IndexedMesh mesh;          ///< with the vertices of the mesh
  std::vector<Index> faces;  ///< of the mesh, the one at each edge
};

/// Edges with exactly one face, in the order of the faces and of their corners; each in the direction of its face. \pre
/// the vertex numbers are valid
BorderEdges border_edges_of(const IndexedMesh& mesh);

}  // namespace whittle
