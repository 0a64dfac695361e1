#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "codec/meshopt.hh"
#include "encode/grid.hh"
#include "geometry/surface.hh"
#include "model/model.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::gltf {

/// The values of an accessor, as a buffer holds them.
struct Encoded {
  ScalarType type = ScalarType::float32;
  bool is_normalized = false;
  ElementShape shape;
  std::size_t count = 0;
  std::size_t stride = 0;  ///< a multiple of 4, but for indices
  std::string bytes;       ///< `count * stride`; for compression, in the form of its filter
  MeshoptMode mode = MeshoptMode::attributes;
  MeshoptFilter filter = MeshoptFilter::none;
  std::vector<double> low;  ///< per component, after reading back; only for positions
  std::vector<double> high;
};

/// How values are written that are to take little space.
struct Packing {
  bool compresses = false;   ///< EXT_meshopt_compression: values get the form of its filters
  bool quantizes = false;    ///< KHR_mesh_quantization: small integers
  std::optional<Grid> grid;  ///< of positions and their morph targets; none: they aren't rounded
};

/// \param documented the accessor that the values replace: its shape, and the type where that can be kept
/// \throw std::range_error if a number is too large for 32 bits
Encoded encode_channel(const Channel& channel, const Accessor& documented, const std::vector<double>& values,
                       const Packing& packing);

/// Encodes in the smallest type that fits, of 16 bits or more.
/// \param documented null, or the replaced accessor: 8 bits stay, unless they are compressed
Encoded encode_indices(const std::vector<Triangle>& faces, std::size_t n_vertices, const Accessor* documented,
                       const Packing& packing);

}  // namespace whittle::gltf
