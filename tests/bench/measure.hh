#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/peers/peer.hh"
#include "bench/processes/clock.hh"

namespace whittle::bench {

/// What a peer did in a process of its own (`run_forked`).
struct FirstRun {
  std::optional<IndexedMesh> answer;
  double ms = 0;                            ///< on cold memory; 0 without an answer
  std::optional<std::uint64_t> peak_bytes;  ///< see `Meter`
  std::string failure;                      ///< why there is no answer
};
/// \param limit_s seconds after which the process is ended; all its work counts
FirstRun first_run(const Peer& peer, const IndexedMesh& input, std::size_t n_faces, Clock clock, double limit_s);

/// Milliseconds of each peer in each round. All rounds run in one forked process; each peer runs once a round. A first
/// round that doesn't count comes before.
/// \return a row a peer, a number a round
std::vector<std::vector<double>> time_interleaved(const std::vector<const Peer*>& peers, const IndexedMesh& input,
                                                  std::size_t n_faces, Clock clock, int rounds);

}  // namespace whittle::bench
