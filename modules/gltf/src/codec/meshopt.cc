#include "codec/meshopt.hh"

#include <vector>

#include "model/scalars.hh"

#ifdef WHITTLE_MESHOPT
#include <meshoptimizer.h>
#endif

namespace whittle::gltf {

#ifdef WHITTLE_MESHOPT

bool has_meshopt() { return true; }

namespace {

const unsigned char* unsigned_bytes(std::string_view bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

void apply_filter(const MeshoptLayout& layout, char* bytes) {
  switch (layout.filter) {
    case MeshoptFilter::none:
      break;
    case MeshoptFilter::octahedral:
      meshopt_decodeFilterOct(bytes, layout.count, layout.stride);
      break;
    case MeshoptFilter::quaternion:
      meshopt_decodeFilterQuat(bytes, layout.count, layout.stride);
      break;
    case MeshoptFilter::exponential:
      meshopt_decodeFilterExp(bytes, layout.count, layout.stride);
      break;
  }
}

int decode_into(char* bytes, const MeshoptLayout& layout, std::string_view packed) {
  const unsigned char* const from = unsigned_bytes(packed);
  switch (layout.mode) {
    case MeshoptMode::attributes:
      return meshopt_decodeVertexBuffer(bytes, layout.count, layout.stride, from, packed.size());
    case MeshoptMode::triangles:
      return meshopt_decodeIndexBuffer(bytes, layout.count, layout.stride, from, packed.size());
    case MeshoptMode::indices:
      break;
  }
  return meshopt_decodeIndexSequence(bytes, layout.count, layout.stride, from, packed.size());
}

std::string encode_triangles(const MeshoptLayout& layout, std::string_view bytes) {
  std::vector<unsigned> indices(layout.count);
  unsigned n_vertices = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const char* const at = bytes.data() + i * layout.stride;
    indices[i] = layout.stride == 2 ? load_little_endian<std::uint16_t>(at) : load_little_endian<std::uint32_t>(at);
    n_vertices = std::max(n_vertices, indices[i] + 1);
  }
  std::string packed(meshopt_encodeIndexBufferBound(indices.size(), n_vertices), '\0');
  meshopt_encodeIndexVersion(1);
  packed.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(packed.data()), packed.size(),
                                          indices.data(), indices.size()));
  return packed;
}

}  // namespace

std::optional<std::string> decode_meshopt(const MeshoptLayout& layout, std::string_view packed) {
  std::string bytes(layout.count * layout.stride, '\0');
  if (layout.count == 0) return bytes;
  if (decode_into(bytes.data(), layout, packed) != 0) return {};
  apply_filter(layout, bytes.data());
  return bytes;
}

std::string encode_meshopt(const MeshoptLayout& layout, std::string_view bytes) {
  if (layout.mode == MeshoptMode::triangles) return encode_triangles(layout, bytes);
  std::string packed(meshopt_encodeVertexBufferBound(layout.count, layout.stride), '\0');
  packed.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(packed.data()), packed.size(), bytes.data(),
                                           layout.count, layout.stride));
  return packed;
}

std::string encode_octahedral(const std::vector<float>& vectors) {
  std::string bytes(vectors.size(), '\0');
  meshopt_encodeFilterOct(bytes.data(), vectors.size() / 4, 4, 8, vectors.data());
  return bytes;
}

std::vector<Index> optimize_order(std::vector<Triangle>& faces, std::size_t n_vertices) {
  std::vector<unsigned> indices;
  indices.reserve(3 * faces.size());
  for (const Triangle& face : faces) indices.insert(indices.end(), face.begin(), face.end());
  meshopt_optimizeVertexCache(indices.data(), indices.data(), indices.size(), n_vertices);
  std::vector<unsigned> numbers(n_vertices);
  const std::size_t n_used =
      meshopt_optimizeVertexFetchRemap(numbers.data(), indices.data(), indices.size(), n_vertices);
  for (std::size_t i = 0; i < indices.size(); ++i) faces[i / 3][i % 3] = numbers[indices[i]];
  std::vector<Index> order(n_used);
  for (Index v = 0; v < n_vertices; ++v) {
    if (numbers[v] != invalid_index) order[numbers[v]] = v;
  }
  return order;
}

#else

bool has_meshopt() { return false; }
std::optional<std::string> decode_meshopt(const MeshoptLayout&, std::string_view) { return {}; }
std::string encode_meshopt(const MeshoptLayout&, std::string_view) { return {}; }
std::string encode_octahedral(const std::vector<float>&) { return {}; }
std::vector<Index> optimize_order(std::vector<Triangle>&, std::size_t) { return {}; }

#endif

}  // namespace whittle::gltf
