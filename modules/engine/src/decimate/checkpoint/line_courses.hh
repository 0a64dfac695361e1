#pragma once

#include <span>
#include <vector>

#include "loop/working_surface.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Finds the courses of feature edges anew, after a checkpoint has moved vertices: each vertex of the input's lines
/// goes to the feature edge that is nearest, of those at the vertex that it was merged into. So contractions keep the
/// tolerance to the input's lines, and not to where a checkpoint has put them. \param input, frame that the lines are
/// those of \param features of the input, or empty
void find_courses(const IndexedMesh& input, const Frame& frame, std::span<const VertexPair> features,
                  WorkingSurface& surface);

}  // namespace whittle
