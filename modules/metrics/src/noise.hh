#pragma once

namespace whittle::metrics {

/// Distances below this share of the diagonal count as 0. A sample is a sum of three rounded products and both sides
/// are moved to a local origin: some units in the last place of the diagonal, 2^-52 each. A hundred times finer than
/// what float coordinates can tell apart is still 2^-31.
inline constexpr double noise_rel = 0x1p-48;

}  // namespace whittle::metrics
