#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

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
/// How many corners of one face are corners of the other.
inline int n_common_corners(const Triangle& face, const Triangle& other) {
  int n = 0;
  for (const Index v : face) n += int{v == other[0]} | int{v == other[1]} | int{v == other[2]};
  return n;
}
/// Red, green, blue, opacity, each in [0, 1].
using Color = std::array<float, 4>;

/// A triangle mesh as plain arrays.
///
/// Any set of triangles is allowed: open, non-manifold, several parts. V is the number of vertices, F of faces. An
/// attribute array is either empty (absent) or as long as its comment says.
struct IndexedMesh {
  std::vector<Vec3>
      positions;  ///< V; finite, model units. At most 2^500 (3e150), so that squares of lengths are finite.
  std::vector<Triangle> faces;  ///< F; every number below V.

  std::vector<std::array<float, 3>> normals;           ///< V; unit length (zero where undefined).
  std::vector<Color> colors;                           ///< V.
  std::vector<std::array<float, 2>> corner_texcoords;  ///< 3F; corner c of face f at 3f + c.
  std::vector<Index> face_groups;                      ///< F; the material or group, a number into `group_names`.
  std::vector<std::string> group_names;

  /// V; the number that each vertex had in the first file or array, ascending. Welding keeps the lowest number of the
  /// merged vertices, decimation that of the surviving vertex. Empty: vertex v has origin v.
  std::vector<Index> origins;
};

}  // namespace whittle
