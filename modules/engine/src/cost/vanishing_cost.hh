#pragma once

#include "complex/triangle_complex.hh"

namespace whittle {

/// What a planned contraction that changes the topology costs, besides what its cost says: of each face that vanishes,
/// and that no face covers afterwards, its area times its longest side ^ (dimension - 2). A cost sees how far the
/// surface moves, not that there is none afterwards: to flatten a leaf of two sides, on which these cancel out, would
/// cost next to nothing.
///
/// 0 for threshold pairs, which join surfaces, and for contractions that the link condition allows.
/// \param position of the merged vertex
/// \param dimension power of a length that is the cost's unit
double vanishing_cost(const TriangleComplex& complex, const ContractionProfile& profile, const Vec3& position,
                      double dimension);

}  // namespace whittle
