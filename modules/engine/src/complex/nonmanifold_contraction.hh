#pragma once

#include "complex/triangle_complex.hh"

// Contractions that change the topology: of threshold pairs, and of edges for which the link condition does not hold.
// The two stars become one, and the common neighbours get new lists, because their old ones would name a vertex twice.
//
//        a   b           a = b
//       /|\ /|\           / | \ .
//      x | c | y         x  c  y       c: a common neighbour without a face (a, b, c): its two edges become one, and
//       \|/ \|/           \ | / .         faces at a and b over the same link edge coincide

namespace whittle {

/// Works out what contracting the pair does to the topology: fills in `is_nonmanifold` and `nonmanifold` of the
/// profile.
///
/// Faces at a and at b over the same link edge would coincide. If as many of them run one way as the other, none is
/// left. Otherwise one of the more frequent orientation is left, at a if there is one.
void plan_nonmanifold(TriangleComplex& complex, ContractionProfile& profile);

/// Whether a planned contraction makes no more border edges, misoriented edges, non-manifold edges and non-manifold
/// vertices, and keeps all neighbours of the two vertices as neighbours of the merged vertex, or of a neighbour of it.
/// So no part falls apart or vanishes.
bool is_no_less_manifold(TriangleComplex& complex, const ContractionProfile& profile);

/// Whether the two stars and their common neighbours are of a closed, oriented manifold, which a planned contraction
/// wouldn't leave: a part that vanishes wholly leaves one.
bool opens_closed_manifold(TriangleComplex& complex, const ContractionProfile& profile);

/// Whether a planned contraction of an edge keeps the Euler number. \pre `is_no_less_manifold`
bool keeps_euler_number(const ContractionProfile& profile);

}  // namespace whittle
