#pragma once

#include <cstddef>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// The attributes of the input that costs look at, as lengths in the frame.
struct ScaledAttributes {
  std::size_t n_components = 0;
  std::vector<double> values;  ///< a row of `stride()` numbers for each wedge of the input
  double farthest = 0;         ///< as that of `SurfaceAttributes`

  /// The components, and zeros up to a multiple of four.
  std::size_t stride() const { return (n_components + 3) / 4 * 4; }
};

/// Whether the cost looks at attributes, and the mesh has some that may count.
bool looks_at_attributes(const DecimateOptions& options, const IndexedMesh& mesh);

/// None if no attribute counts. \param weights of `DecimateOptions`
ScaledAttributes scaled_attributes(const IndexedMesh& input, const Frame& frame, const AttributeWeights& weights,
                                   unsigned threads);

}  // namespace whittle
