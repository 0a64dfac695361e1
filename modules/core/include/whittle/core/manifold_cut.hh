#pragma once

#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// Any set of triangles, cut until each of its parts is what half-edges can hold: an oriented manifold.
//
//   two faces are joined over an edge that has no third face, if they run along it in opposite directions
//   the faces at a vertex fall into fans: those that can be reached from one another over such edges
//   the vertex becomes as many vertices, one a fan, all at its position

namespace whittle {

/// Faces with vertices cut into copies.
struct ManifoldCut {
  std::vector<Triangle> faces;   ///< all of them, in their order, each with its orientation and first corner
  std::vector<Index> originals;  ///< of the vertices added, numbered on from the others: what each is a copy of
};

/// The first copy of a vertex, that of its lowest face, keeps its number; the others are added in the order in which
/// the faces come to them. So every edge has one face, or two that run along it in opposite directions, and the faces
/// of every vertex are one open or closed fan. Faces with two equal corners are left as they are and count for nothing.
///
/// Of an edge with more than two faces, all are parted, and not joined in twos: which two belong together can't be
/// told from the faces alone, and joining those that don't would tie two bodies together. Two that are in the same fan
/// at both its ends have both ends in common still, and so the edge.
/// \param faces every number below n_vertices
/// \throw std::length_error for 2³² / 3 faces or more, or vertices past the range of `Index`
ManifoldCut cut_into_manifold(std::size_t n_vertices, std::span<const Triangle> faces);

/// Of side 3f + i, from corner i of face f to the next, the side of the other face at that edge: `invalid_index` unless
/// there is just one, and it runs the other way.
/// \param faces every number below n_vertices
/// \throw std::length_error as `cut_into_manifold`
std::vector<Index> opposite_sides(std::size_t n_vertices, std::span<const Triangle> faces);

}  // namespace whittle
