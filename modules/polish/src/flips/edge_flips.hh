#pragma once

#include <span>
#include <vector>

#include "guard/face_limits.hh"
#include "surface/mesh_lines.hh"
#include "surface/surface_samples.hh"
#include "surface/surface_walk.hh"

namespace whittle {

/// Flips edges of a mesh, each the common side of two faces that becomes the other diagonal of their four corners,
/// where that lessens the sum of the squared distances of the points that have their feet in the two. None is flipped
/// where that would turn a face over, or faces to one another more than is allowed, make an edge that is there already,
/// a vertex with fewer than four or more than nine faces, or faces intersect; nor is any edge of a line.
/// \param groups per face or empty: edges between groups stay
/// \param samples points with feet on the mesh, which are moved along
/// \return the faces, most of them as they were
std::vector<Triangle> flip_edges(const Surface& mesh, const FaceNeighbors& neighbors, const FaceLimits& limits,
                                 const MeshLines& lines, std::span<const Index> groups, SurfaceSamples& samples,
                                 unsigned threads);

}  // namespace whittle
