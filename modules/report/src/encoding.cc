#include "encoding.hh"

#include <meshoptimizer.h>

namespace whittle::report {

std::string_view append_items(std::vector<unsigned char>& bytes, const void* items, std::size_t n, std::size_t size) {
  const std::size_t at = bytes.size();
  bytes.resize(at + meshopt_encodeVertexBufferBound(n, size));
  const std::size_t n_bytes =
      n == 0 ? 0 : meshopt_encodeVertexBuffer(bytes.data() + at, bytes.size() - at, items, n, size);
  bytes.resize(at + n_bytes);
  return "vertices";
}

std::string_view append_faces(std::vector<unsigned char>& bytes, std::span<const Triangle> faces,
                              std::size_t n_vertices) {
  const std::size_t at = bytes.size();
  const std::size_t n = 3 * faces.size();
  bytes.resize(at + meshopt_encodeIndexBufferBound(n, n_vertices));
  const std::size_t n_bytes =
      n == 0 ? 0 : meshopt_encodeIndexBuffer(bytes.data() + at, bytes.size() - at, faces.data()->data(), n);
  bytes.resize(at + n_bytes);
  return "faces";
}

std::vector<Triangle> in_short_order(std::span<const Triangle> faces, std::size_t n_vertices) {
  std::vector<Triangle> ordered(faces.size());
  if (faces.empty()) return ordered;
  meshopt_optimizeVertexCache(ordered.data()->data(), faces.data()->data(), 3 * faces.size(), n_vertices);
  return ordered;
}

}  // namespace whittle::report
