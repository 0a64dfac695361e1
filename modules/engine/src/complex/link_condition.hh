#pragma once

#include "complex/triangle_complex.hh"

namespace whittle {

/// Whether contracting the pair leaves the topology as it is: Lk a ∩ Lk b = Lk ab, where borders and non-manifold lines
/// count as joined to a cone vertex. \cite dey_1999_topology
bool link_condition(TriangleComplex& complex, const ContractionProfile& profile);

}  // namespace whittle
