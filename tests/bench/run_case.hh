#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "bench/command_line.hh"
#include "bench/measure.hh"
#include "bench/peers/peer.hh"
#include "bench/results/report.hh"

namespace whittle::bench {

struct NamedPeer {
  std::string name;
  std::unique_ptr<Peer> peer;
};

struct RunOptions {
  Rounds rounds{.slow_s = 4, .limit_s = 120};
  std::size_t samples = 50'000;  ///< of the distance, beside all vertices; 0 = the error is not measured
};

/// Runs every peer once by itself, checks the answers, and then times those that gave one that counts. A changed
/// topology is a fault of ours; of others it is told, and they are timed. \return a row a peer, in their order
std::vector<Row> run_case(const std::string& mesh_name, const IndexedMesh& input, double ratio,
                          const std::vector<NamedPeer>& peers, const RunOptions& options);

}  // namespace whittle::bench
