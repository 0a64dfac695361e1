#pragma once

#include <cstdint>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/progress.hh"
#include "whittle/polish/polish.hh"

namespace whittle {

/// What is asked of a fit to a reference.
struct PolishRequest {
  unsigned passes = 3;  ///< largest number of passes; they stop when one no longer reduces the error. [0, inf)
  Fit fit = Fit::balanced;
  std::vector<std::uint8_t> locked{};  ///< V, or empty: vertices with a non-zero entry stay (`held_borders`)
  unsigned threads = 0;                ///< 0 = all cores; the result is the same for any number
  ProgressCallback progress{};
};

/// Fits a simplified mesh, anyone's, to the mesh it was made from. Which vertex came from where is guessed by distance.
/// Seams stay at the reference's seams. Different normals along them stay: they show creases.
/// \param mesh its vertices move
/// \throw Cancelled if the progress ends it before the first pass; later, the mesh is as after the last pass
/// \throw std::invalid_argument if `locked` has a wrong length
PolishResult polish_to_reference(const IndexedMesh& reference, IndexedMesh& mesh, const PolishRequest& request);

}  // namespace whittle
