#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/run_case.hh"

namespace whittle::bench {

/// How near each peer comes to the least errors that `n_faces` triangles can have: its errors over these, on smooth
/// surfaces that are known exactly. The inputs have 100 times as many faces. As a table to read.
/// \param n_samples points of the result
std::string efficiency_text(std::size_t n_faces, const std::vector<NamedPeer>& peers, std::size_t n_samples,
                            const Rounds& rounds);

}  // namespace whittle::bench
