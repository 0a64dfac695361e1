#pragma once

#include <vector>

#include "document/json.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/gltf/asset.hh"

// Sums and comparisons over all vertices of large assets.

namespace whittle::gltf::test {

/// The vertices in lexicographic order, one by one. \return the largest difference of coordinates; infinite if one mesh
/// has more vertices than the other
double largest_difference(const IndexedMesh& a, const IndexedMesh& b);

/// \return whether both have the same positions, as 32 bits hold them
bool are_positions_same(const IndexedMesh& a, const IndexedMesh& b);

/// Of all faces: tells whether two meshes have the same ones, in any order.
Vec3 mean_corner(const IndexedMesh& mesh);

/// Likewise of an attribute.
std::vector<double> mean_value(const IndexedMesh& mesh, const Attribute& attribute);

/// The coordinates of all corners along an axis, ascending.
std::vector<double> corners_along(int axis, const IndexedMesh& mesh);

/// The asset with its own triangles as new ones, so that they are written anew.
Asset replaced(Asset asset);

/// As it was read.
Json document_of(const Asset& asset);

/// Largest difference of the corners, sorted along an axis, as a share of the diagonal: scenes have them in any order.
double relative_distance(const IndexedMesh& a, const IndexedMesh& b);

/// Compares both scenes at rest and while they move.
void expect_same_poses(const Asset& a, const Asset& b);

}  // namespace whittle::gltf::test
