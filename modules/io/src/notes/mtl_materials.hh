#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// A material of a library (MTL), as far as it is read.
struct MtlMaterial {
  std::string name;         ///< `newmtl`
  Color color{1, 1, 1, 1};  ///< `Kd`, each component in [0, 1]; the opacity is `d`, or one less `Tr`
  std::string texture{};    ///< `map_Kd`, as it stands there, without options
};

/// The materials of a library, in its order. What is no number is left out.
std::vector<MtlMaterial> mtl_materials(std::string_view text);

}  // namespace whittle::io
