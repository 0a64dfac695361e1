#pragma once

#include <vector>

#include "original/origins.hh"
#include "surface/surface_walk.hh"

namespace whittle::polishing {

struct Distance {
  double square;
  double weight;  ///< the weights of each direction add up to one half
};
using Distances = std::vector<Distance>;

/// The distances between an original and a mesh, both ways, at some points of each. For comparing a mesh before and
/// after a pass: the points are the same for the same faces. \throw Cancelled
Distances two_sided_distances(const Origins& origins, const Surface& mesh, const detail::Workers& workers);

}  // namespace whittle::polishing
