#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// The straight line between two points, in model units. The points may coincide.
struct Segment {
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
};

/// The open borders of a mesh: its edges with exactly one face, each once, from the lower to the higher vertex number,
/// ascending. Like `Topology::boundary_edges` they go by vertex numbers: coincident positions are not merged, and
/// collapsed faces are left out. O(F) time.
/// \throw std::invalid_argument as `bounds`.
std::vector<Segment> border_lines(const IndexedMesh& mesh);

/// The sharp edges of a mesh, in the same order: edges with exactly two faces whose normals are more than `angle_deg`
/// degrees apart. If both faces run along the edge in the same direction, one of them is reversed first. Edges of a
/// face without a normal (thinner than 1e-11 of its longest side) are not sharp. O(F) time.
/// \param angle_deg in (0, 180).
/// \throw std::invalid_argument as `bounds`, or if `angle_deg` is out of range.
std::vector<Segment> feature_lines(const IndexedMesh& mesh, double angle_deg);

}  // namespace whittle::metrics
