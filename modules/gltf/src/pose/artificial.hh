#pragma once

#include <cstddef>
#include <span>

#include "whittle/gltf/pose.hh"

namespace whittle::gltf {

/// Turns a joint of a pose about its own origin. \param number of the pose
void turn_joint(Pose& pose, std::size_t node, std::size_t number);

/// The weights of a node's morph targets, each in [0, 1). \param number of the pose
std::vector<double> artificial_weights(std::size_t node, std::size_t n_targets, std::size_t number);

}  // namespace whittle::gltf
