#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "error/error_bounds.hh"
#include "whittle/engine/simplify.hh"

namespace whittle {

/// Polishes a decimation, but for the vertices that are held, a 1 each.
using PolishHeld = std::function<PolishResult(Decimation&, const std::vector<std::uint8_t>& held)>;

/// Polishes a decimation that keeps bounds, so that it keeps them afterwards: vertices are held where it wouldn't. If
/// that doesn't help, nothing is polished.
PolishResult polish_within(ErrorBounds& bounds, const IndexedMesh& input, Decimation& decimation,
                           const PolishHeld& polish);

}  // namespace whittle
