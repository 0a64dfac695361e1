#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/max_error/row.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::bench {

struct JudgeOptions {
  std::size_t samples = 200'000;  ///< on each surface, besides all corners
  double limit_s = 120;           ///< for CGAL
};

/// Compares what is claimed of a result with independent measures.
/// \param result of `simplify` with `max_error` as target
/// \param remarks is told why a measure is missing
Proof judged(const IndexedMesh& input, const IndexedMesh& result, double max_error, const JudgeOptions& options,
             std::vector<std::string>& remarks);

/// What the measures say against the claim, one sentence each; empty if they agree with it.
std::vector<std::string> violations(const Proof& proof);

}  // namespace whittle::bench
