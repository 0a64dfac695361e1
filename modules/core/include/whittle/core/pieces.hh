#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// Several meshes in one, and one mesh taken apart.

namespace whittle {

/// Some faces of a mesh, with the vertices and wedges that they have, and all their attributes.
struct MeshPiece {
  IndexedMesh mesh;             ///< vertices, wedges and faces in the order of the whole; its groups keep their numbers
  std::vector<Index> vertices;  ///< those of `mesh` in the whole
  std::vector<Index> faces;     ///< likewise
};

/// Takes a mesh apart, in linear time. Vertices that two pieces have in common are in both.
/// \param piece_of F; the piece of each face, below `n_pieces`
std::vector<MeshPiece> split_mesh(const IndexedMesh& mesh, std::span<const Index> piece_of, std::size_t n_pieces);

/// Adds a mesh to another. What the other doesn't have comes last: its vertices, wedges, faces, groups. An attribute
/// that only one of both has is zero in the other one, a colour white. Origins stay as they are.
void append_mesh(IndexedMesh& all, IndexedMesh more);

/// Whether two attributes have the same name, kind and type.
bool is_same_kind(const Attribute& a, const Attribute& b);

}  // namespace whittle
