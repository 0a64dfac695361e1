#pragma once

#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// Cuts any set of triangles into oriented manifold parts, which half-edges can represent.
//
//   two faces are joined over an edge if it has no third face, and they run along it in opposite directions
//   the faces at a vertex form fans: sets of faces connected over such edges
//   each fan gets its own copy of the vertex, at the same position

namespace whittle {

/// Faces in which some vertices are replaced by copies.
struct ManifoldCut {
  std::vector<Triangle> faces;   ///< all faces in their order, each with its orientation and first corner
  std::vector<Index> originals;  ///< for each added vertex n_vertices + i, the vertex that it copies
};

/// The fan of a vertex's lowest face keeps the vertex's number. Copies for the others are added in the order of the
/// faces. Afterwards each edge has one face, or two that run along it in opposite directions, and the faces of each
/// vertex form one open or closed fan. Faces with two equal corners stay as they are, and are otherwise ignored.
///
/// At an edge with more than two faces all faces are parted; none are joined in twos. The faces alone don't tell which
/// two belong together, and a wrong pair would connect two bodies. Two of these faces may be in the same fan at both
/// ends of the edge. Then they still have both vertices, and so the edge, in common.
/// \param faces every number below n_vertices
/// \throw std::length_error for 2³² / 3 faces or more, or vertices past the range of `Index`
ManifoldCut cut_into_manifold(std::size_t n_vertices, std::span<const Triangle> faces);

/// For side 3f + i, from corner i of face f to the next corner, the side of the other face at that edge;
/// `invalid_index` unless the edge has exactly one other face, which runs in the opposite direction.
/// \param faces every number below n_vertices
/// \throw std::length_error for 2³² / 3 faces or more
std::vector<Index> opposite_sides(std::size_t n_vertices, std::span<const Triangle> faces);

}  // namespace whittle
