#pragma once

#include <vector>

#include "whittle/engine/quadric_term.hh"
#include "whittle/engine/triangle_complex.hh"

namespace whittle {

/// Each vertex's quadric before the first contraction, about its own position: the shares of its faces in the input's
/// order, then, face by face in the same order, the border planes of the edge leaving the vertex and of the one
/// arriving.
std::vector<Quadric> initial_quadrics(const TriangleComplex& complex, const QuadricOptions& options, unsigned threads);

}  // namespace whittle
