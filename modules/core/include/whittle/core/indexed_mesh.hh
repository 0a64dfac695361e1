#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/core/detail/abi.hh"

namespace whittle {

/// Number of a vertex or a face. Both counts stay below `invalid_index`.
using Index = std::uint32_t;
inline constexpr Index invalid_index = ~Index{0};

using Vec3 = Eigen::Vector3d;
/// Three vertex numbers, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;
/// Whether no two corners are the same vertex. Other faces are degenerate: they have no edges and connect nothing.
inline bool has_three_corners(const Triangle& face) {
  return face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}
/// Number of corners of one face that are corners of the other.
inline int n_common_corners(const Triangle& face, const Triangle& other) {
  int n = 0;
  for (const Index v : face) n += int{v == other[0]} | int{v == other[1]} | int{v == other[2]};
  return n;
}
/// Red, green, blue, opacity, each in [0, 1].
using Color = std::array<float, 4>;

/// A triangle mesh as plain arrays.
///
/// Any set of triangles is allowed: open, non-manifold, several parts. V is the number of vertices, F of faces.
///
/// A vertex may have several attribute values: one on each side of a texture seam. Each of them is a *wedge*
/// (\cite hoppe_1999_attributes), and each corner of a face has one. W is the number of wedges. Where `wedges` is
/// empty, each vertex has one wedge, with the vertex's number, and W = V. wedges.hh has their functions.
///
/// An attribute array is either empty (absent) or as long as its comment says.
struct IndexedMesh {
  /// V; finite, model units. At most 2^500 (3e150), so that squares of lengths are finite.
  std::vector<Vec3> positions;
  std::vector<Triangle> faces;  ///< F; every number below V.

  /// 3F or empty; the wedge of corner c of face f at 3f + c, below W. Corners with one wedge are at one vertex.
  std::vector<Index> wedges;

  std::vector<std::array<float, 3>> normals;  ///< W; unit length (zero where undefined).
  std::vector<Color> colors;                  ///< W.
  std::vector<Attribute> attributes;          ///< W values each: texture coordinates and all others.

  std::vector<Attribute> face_attributes;  ///< F values each.
  std::vector<Index> face_groups;          ///< F; the material or group, a number into `group_names`.
  std::vector<std::string> group_names;

  /// V; the number of each vertex in the first file or array, ascending. Welding keeps the lowest number of the merged
  /// vertices, decimation the number of the surviving vertex. Empty: vertex v has origin v.
  std::vector<Index> origins;

  /// The wedge at a corner of a face.
  Index wedge(std::size_t face, std::size_t corner) const {
    return wedges.empty() ? faces[face][corner] : wedges[3 * face + corner];
  }
};

}  // namespace whittle
