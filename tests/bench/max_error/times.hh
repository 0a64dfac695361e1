#pragma once

#include <cstddef>

#include "bench/max_error/row.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::bench {

struct TimeOptions {
  unsigned threads = 2;
  int rounds = 5;
  double slow_s = 20;  ///< if a run takes longer, there is only one round
};

/// `simplify` with a length as target, and to the number of faces that it gives, one after the other in each round.
TimeBeside time_beside(const IndexedMesh& input, double max_error, std::size_t n_faces, const TimeOptions& options);

/// Makes a result with a tenth of the faces; then times that, and the proof of it. \return a row with `pair`
/// \throw std::runtime_error if it isn't proven, or the certificate doesn't hold
Row time_pair(const IndexedMesh& input, const TimeOptions& options);

}  // namespace whittle::bench
