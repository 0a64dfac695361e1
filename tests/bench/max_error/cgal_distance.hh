#pragma once

#include "whittle/core/indexed_mesh.hh"

namespace whittle::bench {

/// CGAL's bounded_error_symmetric_Hausdorff_distance. \param bound of its error, model units
/// \throw std::runtime_error if a half-edge mesh can't hold all faces
double cgal_distance(const IndexedMesh& a, const IndexedMesh& b, double bound);

}  // namespace whittle::bench
