#include "codec/meshopt.hh"

namespace whittle::gltf {
namespace {

constexpr const char* mode_names[] = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
constexpr const char* filter_names[] = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};

/// Largest number of bytes per byte of compressed data. 256 equal bytes of attributes take four. A triangle or an index
/// takes at least a byte.
std::size_t most_bytes_of_a_byte(const MeshoptLayout& layout) {
  switch (layout.mode) {
    case MeshoptMode::attributes:
      return 64;
    case MeshoptMode::triangles:
      return 3 * layout.stride;
    case MeshoptMode::indices:
      break;
  }
  return layout.stride;
}

bool has_valid_stride(const MeshoptLayout& layout) {
  if (layout.mode != MeshoptMode::attributes) return layout.stride == 2 || layout.stride == 4;
  if (layout.stride == 0 || layout.stride % 4 != 0 || layout.stride > 256) return false;
  if (layout.filter == MeshoptFilter::octahedral) return layout.stride == 4 || layout.stride == 8;
  return layout.filter != MeshoptFilter::quaternion || layout.stride == 8;
}

template <class Value, std::size_t n>
std::optional<Value> value_of(const char* const (&names)[n], std::string_view name) {
  for (std::size_t i = 0; i < n; ++i) {
    if (name == names[i]) return static_cast<Value>(i);
  }
  return {};
}

}  // namespace

std::optional<MeshoptMode> meshopt_mode(std::string_view name) { return value_of<MeshoptMode>(mode_names, name); }
std::optional<MeshoptFilter> meshopt_filter(std::string_view name) {
  return value_of<MeshoptFilter>(filter_names, name);
}
const char* name_of(MeshoptMode mode) { return mode_names[static_cast<std::size_t>(mode)]; }
const char* name_of(MeshoptFilter filter) { return filter_names[static_cast<std::size_t>(filter)]; }

std::string problem_of(const MeshoptLayout& layout, std::size_t packed_size) {
  if (!has_valid_stride(layout)) return "\"byteStride\" doesn't fit the mode and the filter";
  if (layout.mode != MeshoptMode::attributes && layout.filter != MeshoptFilter::none) {
    return "indices can't have a filter";
  }
  if (layout.mode == MeshoptMode::triangles && layout.count % 3 != 0) return "\"count\" is not a multiple of 3";
  // The bytes at the end, with the header, can stand for one more block.
  const std::size_t most = (packed_size + 1) * most_bytes_of_a_byte(layout);
  if (layout.count > most / layout.stride) return "\"count\" is above what the compressed data can hold";
  return {};
}

}  // namespace whittle::gltf
