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

std::vector<unsigned char> deflated(const std::vector<unsigned char>& bytes) {
  uLongf n = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<unsigned char> result(n);
  if (compress2(result.data(), &n, bytes.data(), static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib can't compress the page");
  }
  result.resize(n);
  return result;
}

std::string base64(std::span<const unsigned char> bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
    for (int shift = 18; shift >= 0; shift -= 6) text += digits[group >> shift & 63U];
  }
  for (std::size_t k = 0; k < (3 - bytes.size() % 3) % 3; ++k) text[text.size() - 1 - k] = '=';
  return text;
}

}  // namespace whittle::report
