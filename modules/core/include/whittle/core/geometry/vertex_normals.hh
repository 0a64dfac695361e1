#pragma once

#include <array>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Unit normals of vertices: the normalised sum of their faces' normals, weighted by area.
std::vector<std::array<float, 3>> vertex_normals(const IndexedMesh& mesh, const Frame& frame);

/// Default crease angle, degrees, as in Houdini's Normal node and Unity's import. Smooth surfaces of few faces turn by
/// 40° and more at an edge, boxes by 90°.
inline constexpr double default_crease_angle_deg = 60;

/// Computes the normals of all corners anew. A corner's normal is the normalised sum, weighted by area, of the normals
/// of its face and of the faces around the vertex connected with it without a crease between. An edge is a crease if
/// its two faces turn by the angle or more, to 1e-6 in the cosine. A vertex with several normals gets several wedges
/// (`IndexedMesh`) with the same other attributes. Faces without area connect nothing: their corners get the normal of
/// `vertex_normals`. \param frame of the mesh \param crease_angle_deg (0, 180]; 180: each vertex has one normal
void recompute_normals(IndexedMesh& mesh, const Frame& frame, double crease_angle_deg = default_crease_angle_deg);

}  // namespace whittle
