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
/// Whether no two corners are the same vertex. Faces without are none, to anything that asks how faces hang together.
inline bool has_three_corners(const Triangle& face) {
  return face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}
/// Red, green, blue, opacity, each in [0, 1].
using Color = std::array<float, 4>;

/// A triangle mesh as plain arrays: what files are read into, what the engine takes and gives.
///
/// Any set of triangles is allowed (open, non-manifold, several parts). With V vertices and F faces an attribute array
/// is either empty (absent, free of cost) or as long as its comment says.
struct IndexedMesh {
  std::vector<Vec3> positions;  ///< V; finite, model units.
  std::vector<Triangle> faces;  ///< F; every number below V.

  std::vector<std::array<float, 3>> normals;           ///< V; unit length (zero where undefined).
  std::vector<Color> colors;                           ///< V.
  std::vector<std::array<float, 2>> corner_texcoords;  ///< 3F; corner c of face f at 3f + c.
  std::vector<Index> face_groups;                      ///< F; the material or group, a number into `group_names`.
  std::vector<std::string> group_names;

  /// V; the number each vertex had in the file or array it first came from, ascending. Welding keeps the lowest of the
  /// merged vertices' numbers, decimation that of the surviving vertex. Empty: vertex v has origin v.
  std::vector<Index> origins;
};

}  // namespace whittle
