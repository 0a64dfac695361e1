#pragma once

#include <filesystem>
#include <vector>

#include "bench/results/report.hh"

namespace whittle::bench {

/// Draws the rows of a run as SVG files: `time.svg` and `time-permuted.svg` (milliseconds against faces of the input)
/// and `error-MESH.svg` for each mesh in its own order (mean error against faces of the result).
/// \return the files written
std::vector<std::filesystem::path> write_plots(const std::filesystem::path& folder, const std::vector<Row>& rows,
                                               Clock clock);

}  // namespace whittle::bench
