#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geometry/elements.hh"
#include "model/model.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::gltf {

/// An attribute of a primitive: "TEXCOORD_0", or that of a morph target: "target 0 POSITION".
struct Channel {
  std::string name;
  std::size_t accessor;
};

/// All of a primitive, in the file's order, the morph targets last.
std::vector<Channel> channels_of(const Primitive& primitive);

/// The triangles of a primitive, with the vertices that the file has.
struct Surface {
  std::size_t n_vertices = 0;
  std::vector<Triangle> faces;                               ///< every number below `n_vertices`
  std::vector<std::pair<std::string, Elements>> attributes;  ///< by channel; `n_vertices` or more values each
  std::vector<std::shared_ptr<const std::string>> decoded;   ///< data that some attributes point into

  const Elements* attribute(std::string_view name) const;
};

/// \param number of the primitive, which is a surface. \throw io::ReadError
Surface read_surface(const Model& model, std::size_t mesh, std::size_t number);

/// The document's number of triangles, without decompression.
std::size_t n_triangles_of(const Model& model, const Primitive& primitive);

}  // namespace whittle::gltf
