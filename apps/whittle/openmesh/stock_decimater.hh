#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// The result of OpenMesh's decimater, and how long it took.
struct StockRun {
  IndexedMesh mesh;
  std::uint64_t n_lost_faces = 0;  ///< faces of the input that a half-edge mesh can't hold
  double seconds_build = 0;        ///< building OpenMesh's mesh
  double seconds_decimate = 0;     ///< `initialize`, decimation and garbage collection
};

/// Decimates as users of OpenMesh do: by ModQuadric, and ModNormalFlipping at its default angle, in DecimaterT. The
/// mesh has coordinates in double. A cost limit becomes ModQuadric's `max_err`, which has the same unit.
/// \param progress called with the number of contractions now and then
/// \throw UnsupportedMesh if OpenMesh refuses every face.
StockRun decimate_by_stock(const IndexedMesh& input, const std::string& name, const DecimateTarget& target,
                           const std::function<void(std::uint64_t)>& progress);

}  // namespace whittle::app
