#include "../../../report/src/encoding.hh"

// Arrays of a page that the browser makes for itself: they are not compressed, nor put in another order.

namespace whittle::report {

std::string_view append_items(std::vector<unsigned char>& bytes, const void* items, std::size_t n, std::size_t size) {
  const auto* const begin = static_cast<const unsigned char*>(items);
  bytes.insert(bytes.end(), begin, begin + n * size);
  return "none";
}

std::string_view append_faces(std::vector<unsigned char>& bytes, std::span<const Triangle> faces,
                              std::size_t /*n_vertices*/) {
  return append_items(bytes, faces.data(), faces.size(), sizeof(Triangle));
}

std::vector<Triangle> in_short_order(std::span<const Triangle> faces, std::size_t /*n_vertices*/) {
  return {faces.begin(), faces.end()};
}

}  // namespace whittle::report
