#include <memory>
#include <stdexcept>
#include <utility>

#include "bench/max_error/contenders/contender.hh"
#include "bench/peers/peer.hh"

namespace whittle::bench {
namespace {

/// CMake defines WHITTLE_BENCH_HAS_….
const std::vector<Contender>& own_contenders() {
  static const std::vector<Contender> all = {
      {"openmesh-hausdorff", Contender::Amount::length, by_openmesh_hausdorff},
#ifdef WHITTLE_BENCH_HAS_MESHOPTIMIZER
      {"meshoptimizer-error", Contender::Amount::length, by_meshoptimizer_error},
#endif
#ifdef WHITTLE_BENCH_HAS_CGAL
      {"cgal-envelope", Contender::Amount::length, by_cgal_envelope},
#endif
      {"meshlab", Contender::Amount::faces, by_meshlab},
  };
  return all;
}

}  // namespace

std::vector<std::string> contender_names() {
  std::vector<std::string> names;
  for (const Contender& contender : own_contenders()) names.push_back(contender.name);
  for (std::string& name : peer_names()) names.push_back(std::move(name));
  return names;
}

Contender make_contender(std::string_view name) {
  for (const Contender& contender : own_contenders())
    if (contender.name == name) return contender;
  const std::shared_ptr<const Peer> peer = make_peer(name);
  const auto decimate = [peer](const IndexedMesh& input, double n_faces) {
    Meter meter;
    return peer->decimate(input, static_cast<std::size_t>(n_faces), meter);
  };
  return {std::string(name), Contender::Amount::faces, decimate};
}

}  // namespace whittle::bench
