#include "page_bytes.hh"

#include "encoding.hh"

namespace whittle::report {

Json PageBytes::add_items(const void* items, std::size_t n, std::size_t size) {
  const std::size_t at = bytes_.size();
  const std::string_view codec = append_items(bytes_, items, n, size);
  return {{"at", at}, {"bytes", bytes_.size() - at}, {"count", n}, {"size", size}, {"codec", codec}};
}

Json PageBytes::add_faces(std::span<const Triangle> faces, std::size_t n_vertices) {
  const std::size_t at = bytes_.size();
  const std::string_view codec = append_faces(bytes_, faces, n_vertices);
  return {{"at", at}, {"bytes", bytes_.size() - at}, {"count", 3 * faces.size()}, {"size", 4}, {"codec", codec}};
}

Json PageBytes::add_file(std::string_view file) {
  const std::size_t at = bytes_.size();
  bytes_.insert(bytes_.end(), file.begin(), file.end());
  return {{"at", at}, {"bytes", file.size()}, {"count", file.size()}, {"size", 1}, {"codec", "none"}};
}

}  // namespace whittle::report
