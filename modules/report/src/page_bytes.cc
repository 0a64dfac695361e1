#include "page_bytes.hh"

#include <meshoptimizer.h>
#include <zlib.h>

#include <stdexcept>

namespace whittle::report {

Json PageBytes::add_items(const void* items, std::size_t n, std::size_t size) {
  const std::size_t at = bytes_.size();
  bytes_.resize(at + meshopt_encodeVertexBufferBound(n, size));
  const std::size_t n_bytes =
      n == 0 ? 0 : meshopt_encodeVertexBuffer(bytes_.data() + at, bytes_.size() - at, items, n, size);
  bytes_.resize(at + n_bytes);
  return {{"at", at}, {"bytes", n_bytes}, {"count", n}, {"size", size}, {"codec", "vertices"}};
}

Json PageBytes::add_faces(std::span<const Triangle> faces, std::size_t n_vertices) {
  const std::size_t at = bytes_.size();
  const std::size_t n = 3 * faces.size();
  bytes_.resize(at + meshopt_encodeIndexBufferBound(n, n_vertices));
  const std::size_t n_bytes =
      n == 0 ? 0 : meshopt_encodeIndexBuffer(bytes_.data() + at, bytes_.size() - at, faces.data()->data(), n);
  bytes_.resize(at + n_bytes);
  return {{"at", at}, {"bytes", n_bytes}, {"count", n}, {"size", 4}, {"codec", "faces"}};
}

Json PageBytes::add_file(std::string_view file) {
  const std::size_t at = bytes_.size();
  bytes_.insert(bytes_.end(), file.begin(), file.end());
  return {{"at", at}, {"bytes", file.size()}, {"count", file.size()}, {"size", 1}, {"codec", "none"}};
}

std::string deflated(const std::vector<unsigned char>& bytes) {
  uLongf n = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(n, '\0');
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &n, bytes.data(), static_cast<uLong>(bytes.size()),
                Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib can't compress the page");
  }
  result.resize(n);
  return result;
}

}  // namespace whittle::report
