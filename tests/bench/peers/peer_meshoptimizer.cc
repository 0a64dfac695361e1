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
    std::vector<float> positions;
    positions.reserve(3 * input.positions.size());
    for (const Vec3& p : input.positions)
      for (const double x : p) positions.push_back(static_cast<float>(x));
    std::vector<unsigned> indices;
    indices.reserve(3 * input.faces.size());
    for (const Triangle& face : input.faces) indices.insert(indices.end(), face.begin(), face.end());
    std::vector<unsigned> result(indices.size());

    meter.start();
    const std::size_t n_indices =
        meshopt_simplify(result.data(), indices.data(), indices.size(), positions.data(), input.positions.size(),
                         3 * sizeof(float), 3 * n_faces, std::numeric_limits<float>::max(), 0, nullptr);
    meter.stop();

    IndexedMesh mesh;
    mesh.positions = input.positions;
    for (std::size_t i = 0; i < n_indices; i += 3) mesh.faces.push_back({result[i], result[i + 1], result[i + 2]});
    return without_unused_vertices(mesh);
  }
};

}  // namespace

std::unique_ptr<Peer> make_meshoptimizer() { return std::make_unique<Meshoptimizer>(); }

}  // namespace whittle::bench
