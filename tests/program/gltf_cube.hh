#pragma once

#include <string>

namespace whittle::test {

/// Writes a glTF file: a cube with a chart a side, of two materials by turns, with normals and texture coordinates, and
/// three squares that are points; in a scene with a camera, an animation and extras. \param n squares along a side
void write_gltf_cube(const std::string& path, int n);

}  // namespace whittle::test
