#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// EXT_meshopt_compression, by the library meshoptimizer.

namespace whittle::gltf {

enum class MeshoptMode : std::uint8_t { attributes, triangles, indices };
enum class MeshoptFilter : std::uint8_t { none, octahedral, quaternion, exponential };

struct MeshoptLayout {
  std::size_t count = 0;   ///< of elements
  std::size_t stride = 0;  ///< bytes of an element
  MeshoptMode mode = MeshoptMode::attributes;
  MeshoptFilter filter = MeshoptFilter::none;
};

/// Whether this build has the library.
bool has_meshopt();

/// Names as documents have them.
std::optional<MeshoptMode> meshopt_mode(std::string_view name);
std::optional<MeshoptFilter> meshopt_filter(std::string_view name);
const char* name_of(MeshoptMode mode);
const char* name_of(MeshoptFilter filter);

/// The problem with a layout, or empty. \param packed_size of the compressed data, which limits the unpacked size
std::string problem_of(const MeshoptLayout& layout, std::size_t packed_size);

/// `count * stride` bytes; empty if the data are damaged. \pre the layout has no problem
std::optional<std::string> decode_meshopt(const MeshoptLayout& layout, std::string_view packed);

/// Compresses bytes that already have the filter's form. \pre this build has the library
std::string encode_meshopt(const MeshoptLayout& layout, std::string_view bytes);

/// Vectors of 4 components, of which 3 are a direction, as 4 bytes each, in the form of the octahedral filter.
/// \pre this build has the library
std::string encode_octahedral(const std::vector<float>& vectors);

/// Puts faces into an order in which they compress well, and numbers their vertices by first use.
/// \return the old number of each vertex that a face has. \pre this build has the library
std::vector<Index> optimize_order(std::vector<Triangle>& faces, std::size_t n_vertices);

}  // namespace whittle::gltf
