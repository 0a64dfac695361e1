#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/model.hh"
#include "whittle/core/indexed_mesh.hh"

// KHR_draco_mesh_compression, by the library Draco.

namespace whittle::gltf {

struct DracoAttribute {
  std::string name;
  ScalarType type = ScalarType::float32;
  std::size_t n_components = 1;
  std::string bytes;  ///< packed, a value for each vertex
};

struct DracoMesh {
  std::size_t n_vertices = 0;
  std::vector<Triangle> faces;  ///< every number below `n_vertices`
  std::vector<DracoAttribute> attributes;
};

/// Whether this build has the library.
bool has_draco();

/// \throw std::runtime_error with the problem, without a full stop
DracoMesh decode_draco(std::string_view packed, const NamedNumbers& attributes);

}  // namespace whittle::gltf
