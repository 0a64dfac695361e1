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

/// Those of a value, k joints and then k weights, that a primitive with room for `n` keeps: all, or the `n` of the
/// largest weights. Their sum is 1, unless all are zero. What is 1 to within rounding of 32 bits stays as it is.
JointWeights kept_joints(std::span<const double> value, std::size_t n);

/// Rounds weights to multiples of 1/`largest` whose sum is that of the weights, rounded: 1 for 1.
void round_weights(std::span<double> weights, double largest);

}  // namespace whittle::gltf
