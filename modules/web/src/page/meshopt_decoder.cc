#include <stdexcept>

#include "../../../gltf/src/codec/meshopt.hh"

// Compressed glTF files, by meshoptimizer's own decoder for JavaScript.

namespace whittle::gltf {
namespace {

/// \param mode, filter names as documents have them, which end with 0 \return whether the data are whole
__attribute__((import_module("whittle"), import_name("decode_meshopt"))) bool decode(void* to, std::size_t count,
                                                                                     std::size_t stride,
                                                                                     const void* from, std::size_t size,
                                                                                     const char* mode,
                                                                                     const char* filter);

[[noreturn]] void refuse() { throw std::invalid_argument("the page doesn't compress glTF files"); }

}  // namespace

bool has_meshopt() { return true; }

std::optional<std::string> decode_meshopt(const MeshoptLayout& layout, std::string_view packed) {
  std::string bytes(layout.count * layout.stride, '\0');
  if (layout.count == 0) return bytes;
  const bool is_whole = decode(bytes.data(), layout.count, layout.stride, packed.data(), packed.size(),
                               name_of(layout.mode), name_of(layout.filter));
  if (!is_whole) return {};
  return bytes;
}

std::string encode_meshopt(const MeshoptLayout&, std::string_view) { refuse(); }
std::string encode_octahedral(const std::vector<float>&) { refuse(); }
std::vector<Index> optimize_order(std::vector<Triangle>&, std::size_t) { refuse(); }

}  // namespace whittle::gltf
