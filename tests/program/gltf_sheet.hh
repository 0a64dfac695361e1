#pragma once

#include <string>

namespace whittle::test {

/// A square sheet, 4 × 4 in size, that can be posed.
struct GltfSheet {
  double height = 0;        ///< its z; its morph target adds as much
  bool has_skin = true;     ///< of one joint, which moves all vertices
  bool has_target = false;  ///< a morph target, whose weight is 0
  bool is_animated = true;  ///< the joint becomes three times as large, linearly in one second
  double scale = 1;         ///< of the joint at rest
};

/// Writes a glTF file. \param n squares along a side
void write_gltf_sheet(const std::string& path, const GltfSheet& sheet, int n = 4);

}  // namespace whittle::test
