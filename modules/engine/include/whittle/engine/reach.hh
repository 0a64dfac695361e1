#pragma once

namespace whittle {

/// Which pairs may cost less after a contraction nearby than before it.
enum class Reach {
  none,            ///< none: old costs are lower bounds
  ends,            ///< those of the merged vertex
  ring,            ///< those of the merged vertex and of its neighbours
  opposite_rings,  ///< those, and those of the neighbours of the corners opposite to the pair
};

}  // namespace whittle
