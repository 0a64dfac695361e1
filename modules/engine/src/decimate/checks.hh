#pragma once

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/decimate_target.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// \throw std::invalid_argument for an option out of its range or one that the cost doesn't take
void check(const DecimateTarget& target, const DecimateOptions& options, std::size_t n_vertices);

/// \throw std::invalid_argument for what is no mesh: numbers out of range, coordinates that aren't finite, attributes
///        of a wrong length
/// \throw std::length_error for more than 2³¹ faces or 2³² − 2 vertices; edges and pairs are counted where they are
/// made
void check(const IndexedMesh& mesh);

}  // namespace whittle
