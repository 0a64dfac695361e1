#pragma once

#include <array>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/progress.hh"

namespace whittle::metrics {

/// All pairs of faces that intersect beyond their common corners, each as (lower, higher) number, ascending.
///
/// Two faces may share no point, one corner, or one edge, as their corners do. Corners are the same if their positions
/// are equal, so an unwelded mesh has the same result as the welded one. These also count as intersections: faces that
/// touch without a common corner (a vertex inside another face, a T-junction), neighbours folded exactly onto each
/// other, and coincident faces. Faces whose corners are on a line don't count: `Shape::degenerate_faces` counts them.
///
/// The result is exact for the given coordinates: orientation tests use a floating-point filter, then expansions. They
/// require that coordinates along an axis that differ from each other or from 0 differ by at least 1e-30 of the mesh's
/// extent.
/// \param threads 0 = all cores; the result is the same for any number.
/// \throw std::invalid_argument as `bounds`.
/// \throw Cancelled if `progress` returned false.
std::vector<std::array<Index, 2>> self_intersections(const IndexedMesh& mesh, unsigned threads = 0,
                                                     const ProgressCallback& progress = {});

}  // namespace whittle::metrics
