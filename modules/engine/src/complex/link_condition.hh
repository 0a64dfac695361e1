#pragma once

#include "complex/triangle_complex.hh"

namespace whittle {

/// Whether contracting the pair leaves the topology as it is: Lk a ∩ Lk b = Lk ab, where borders and non-manifold lines
/// count as joined to a cone vertex. \cite dey_1999_topology
bool link_condition(TriangleComplex& complex, const ContractionProfile& profile);

/// The faces of a pair of which both vertices are left.
struct PairFaces {
  std::span<const LinkEdge> first;   ///< those at a without b
  std::span<const LinkEdge> second;  ///< those at b without a
  std::span<const Index> opposites;  ///< the third corners of the common ones
  std::array<VertexKind, 2> kinds;   ///< of a and b; if one is regular, the other's doesn't matter
};

/// The same of lists of faces. \param link with room for all vertices
bool link_condition(Link& link, const PairFaces& faces);

}  // namespace whittle
