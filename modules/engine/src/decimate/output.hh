#pragma once

#include <vector>

#include "complex/triangle_complex.hh"
#include "cost/pair_cost.hh"
#include "whittle/core/frame.hh"
#include "whittle/engine/decimate.hh"

namespace whittle {

/// The mesh and the maps of a decimation, from a complex after its contractions; `result` and `feature_edges` are left
/// to the caller. \param quadrics_of whose quadrics are wanted; null for none
Decimation make_output(const IndexedMesh& input, TriangleComplex& complex, const Frame& frame, Normals normals,
                       const PairCost* quadrics_of);

/// What of the input's attributes is not carried.
std::vector<Warning> warnings_about_attributes(const IndexedMesh& input);

}  // namespace whittle
