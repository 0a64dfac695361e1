#pragma once

#include <array>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Unit normals of vertices: the normalised sum of their faces' normals, weighted by area.
std::vector<std::array<float, 3>> vertex_normals(const IndexedMesh& mesh, const Frame& frame);

/// Where normals break unless a caller says otherwise, degrees: what Houdini's Normal node and Unity's import have,
/// too. Smooth surfaces of few faces turn by 40° and more at an edge, boxes by 90°.
inline constexpr double default_crease_angle_deg = 60;

/// Computes the normals of all corners anew. That of a corner is the normalised sum, weighted by area, of the normals
/// of its own face and of those faces around the vertex that are connected with it over edges that are no creases. An
/// edge is a crease between two faces if they turn there by the angle or more, to 1e-6 in the cosine. Where a vertex
/// gets several normals, it gets several wedges (`IndexedMesh`) with the same other attributes. Faces without area
/// connect nothing: their corners have the normal of `vertex_normals`. \param frame of the mesh \param crease_angle_deg
/// (0, 180]; 180: each vertex has one normal
void recompute_normals(IndexedMesh& mesh, const Frame& frame, double crease_angle_deg = default_crease_angle_deg);

}  // namespace whittle
