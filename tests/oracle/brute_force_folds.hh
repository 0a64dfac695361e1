#pragma once

#include <set>
#include <span>

#include "support/face_list.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/options.hh"

namespace whittle::test {

/// The fold edges that planes hold, if the options ask for them: edges of two faces that run along them in opposite
/// ways, with both third corners in the same direction from the edge.
std::set<Edge> brute_force_folds(std::span<const Vec3> positions, std::span<const Triangle> faces,
                                 const DecimateOptions& options);

}  // namespace whittle::test
