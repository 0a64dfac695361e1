#include <meshoptimizer.h>

#include <limits>

#include "bench/peers/peer.hh"
#include "bench/peers/peer_arrays.hh"

// meshoptimizer's meshopt_simplify. Its input is positions in float and indices. Its output is indices in an array that
// the caller provides. Both exist before the clock starts. The error is not limited: only the number of faces stops it.

namespace whittle::bench {
namespace {

class Meshoptimizer : public Peer {
 public:
  IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const override {
    const FloatArrays arrays(input);
    std::vector<unsigned> result(arrays.indices.size());

    meter.start();
    const std::size_t n_indices = meshopt_simplify(result.data(), arrays.indices.data(), arrays.indices.size(),
                                                   arrays.positions.data(), input.positions.size(), 3 * sizeof(float),
                                                   3 * n_faces, std::numeric_limits<float>::max(), 0, nullptr);
    meter.stop();

    result.resize(n_indices);
    return with_faces(input, result);
  }
};

}  // namespace

std::unique_ptr<Peer> make_meshoptimizer() { return std::make_unique<Meshoptimizer>(); }

}  // namespace whittle::bench
