#pragma once

#include <string>
#include <vector>

#include "bench/peers/peer.hh"

namespace whittle::bench {

/// How a run of ours does on more threads.
struct Scaling {
  std::string peer;
  double ms_on_one = 0;           ///< wall-clock time, one thread; medians, as all times here
  double ms_on_all = 0;           ///< on all threads that there are
  double cpu_ms_on_all = 0;       ///< processor time of these
  double serial_share = 0;        ///< of the work: what only one thread can do
  std::vector<double> simulated;  ///< how many times as fast as on one thread, by `simulated_threads`
};
inline constexpr unsigned simulated_threads[] = {2, 4, 8, 16, 32, 64};

/// Runs on one thread and on all, and times all blocks of parallel work. What more threads would need is simulated from
/// these times: each thread takes the next block when it has done one; memory and caches are as fast as here.
Scaling measure_scaling(const WhittleKind& kind, const IndexedMesh& input, std::size_t n_faces, int rounds);

/// As a table to read.
std::string to_text(const std::vector<Scaling>& scalings);

}  // namespace whittle::bench
