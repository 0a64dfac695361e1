#pragma once

#include "whittle/engine/quadric_term.hh"
#include "whittle/engine/triangle_complex.hh"

namespace whittle {

/// Gives each vertex its quadric before the first contraction: the shares of its faces in the input's order, then, face
/// by face in the same order, the border planes of the edge leaving the vertex and of the one arriving.
void set_initial_quadrics(TriangleComplex& complex, const QuadricOptions& options, unsigned threads);

}  // namespace whittle
