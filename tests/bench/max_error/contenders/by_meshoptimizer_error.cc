#include <meshoptimizer.h>

#include "bench/max_error/contenders/contender.hh"
#include "bench/peers/peer_arrays.hh"

// meshoptimizer's meshopt_simplify, with its limit of the error alone.

namespace whittle::bench {

IndexedMesh by_meshoptimizer_error(const IndexedMesh& input, double length) {
  const FloatArrays arrays(input);
  const float scale = meshopt_simplifyScale(arrays.positions.data(), input.positions.size(), 3 * sizeof(float));
  std::vector<unsigned> result(arrays.indices.size());
  result.resize(meshopt_simplify(result.data(), arrays.indices.data(), arrays.indices.size(), arrays.positions.data(),
                                 input.positions.size(), 3 * sizeof(float), 0, static_cast<float>(length) / scale, 0,
                                 nullptr));
  return with_faces(input, result);
}

}  // namespace whittle::bench
