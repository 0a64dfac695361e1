#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// Joins meshes, and splits a mesh.

namespace whittle {

/// Some faces of a mesh, with the vertices and wedges that they have, and all their attributes.
struct MeshPiece {
  IndexedMesh mesh;             ///< vertices, wedges and faces in the order of the whole; its groups keep their numbers
  std::vector<Index> vertices;  ///< per vertex of `mesh`, its number in the whole
  std::vector<Index> faces;     ///< per face of `mesh`, its number in the whole
};

/// Splits a mesh, in linear time. Vertices that two pieces have in common are in both.
/// \param piece_of F; the piece of each face, below `n_pieces`
std::vector<MeshPiece> split_mesh(const IndexedMesh& mesh, std::span<const Index> piece_of, std::size_t n_pieces);

/// Appends vertices, wedges, faces and groups of `more` to `all`. An attribute that only one of both has is zero in the
/// other, a colour white. Origins don't change.
void append_mesh(IndexedMesh& all, IndexedMesh more);

/// Whether two attributes have the same name, kind and type.
bool is_same_kind(const Attribute& a, const Attribute& b);

}  // namespace whittle
