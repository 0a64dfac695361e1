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
  std::size_t samples = 50'000;  ///< of the distance, besides all vertices; 0 = the error is not measured
};

/// Runs every peer once by itself and checks the answers. Then times the peers whose answers count. A changed topology
/// is an error for Whittle's peers; for others it is only reported. \return a row a peer, in their order
std::vector<Row> run_case(const std::string& mesh_name, const IndexedMesh& input, double ratio,
                          const std::vector<NamedPeer>& peers, const RunOptions& options);

}  // namespace whittle::bench
