#pragma once

#include <array>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// All pairs of faces that have more in common than they should, each as (lower, higher) number, ascending.
///
/// Two faces should share what their corners share: no point, one corner, or one edge. Corners are the same when their
/// positions are equal, so an unwelded mesh is judged like a welded one. Hence faces that touch without sharing a
/// corner count (a vertex inside another face, a T-junction), so do neighbours folded exactly onto each other, and
/// coincident faces. Faces whose corners lie on a line are left out: `Shape::degenerate_faces` has them.
///
/// The answer is exact for the coordinates as given (orientation tests by floating-point filter, then by expansions),
/// as long as products of three coordinate differences neither over- nor underflow: extents within 1e-90 … 1e90. \param
/// threads 0 = all cores; the result doesn't depend on it. \throw std::invalid_argument as `bounds`.
std::vector<std::array<Index, 2>> self_intersections(const IndexedMesh& mesh, unsigned threads = 0);

}  // namespace whittle::metrics
