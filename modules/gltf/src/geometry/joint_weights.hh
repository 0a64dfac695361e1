#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace whittle::gltf {

/// Joints and their weights, as many of each.
struct JointWeights {
  std::vector<double> joints;
  std::vector<double> weights;
};

/// The joints that a primitive with room for `n` keeps of a value, k joints and then k weights: all, or the `n` with
/// the largest weights. The weights are scaled to sum 1, unless all are zero; a sum of 1 up to rounding to 32 bits is
/// kept.
JointWeights kept_joints(std::span<const double> value, std::size_t n);

/// Rounds weights to multiples of 1/`largest` whose sum is that of the weights, rounded: 1 for 1.
void round_weights(std::span<double> weights, double largest);

}  // namespace whittle::gltf
