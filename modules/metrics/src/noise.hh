#pragma once

namespace whittle::metrics {

/// Distances below this share of the diagonal count as 0. A sample is a sum of three rounded products, and both meshes
/// are moved to a local origin. Together these errors are some units in the last place of the diagonal, 2^-52 each.
/// Float coordinates are far coarser: a hundredth of their resolution is still 2^-31.
inline constexpr double noise_rel = 0x1p-48;

}  // namespace whittle::metrics
