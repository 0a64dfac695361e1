#pragma once

#include <array>
#include <functional>
#include <vector>

#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/progress.hh"

namespace whittle::metrics {

/// `self_intersections` of the pairs for which `is_wanted` holds; all if it is empty.
/// \param is_wanted called from several threads, with the lower number first
std::vector<std::array<Index, 2>> face_intersections(const IndexedMesh& mesh,
                                                     const std::function<bool(Index, Index)>& is_wanted,
                                                     unsigned threads, const ProgressCallback& progress);

/// Whether a face has an area. A face without area intersects nothing.
bool has_area(const Corners& face);

/// Whether two faces with areas intersect, decided as there. Corners at equal positions are common ones.
/// \pre working_scale.hh has scaled the mesh
bool do_intersect(const Corners& face, const Corners& other);

}  // namespace whittle::metrics
