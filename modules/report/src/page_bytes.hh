#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::report {

using Json = nlohmann::ordered_json;

/// The arrays of a page, encoded (encoding.hh), one after the other. Adding an array gives the JSON by which the page
/// finds it: {"at", "bytes", "count", "size", "codec"}, the last one "vertices", "faces" or, for bytes as they are,
/// "none".
class PageBytes {
 public:
  /// Items of `Item`, whose size is a multiple of four bytes.
  template <class Item>
  Json add(std::span<const Item> items) {
    static_assert(sizeof(Item) % 4 == 0);
    return add_items(items.data(), items.size(), sizeof(Item));
  }
  template <class Item>
  Json add(const std::vector<Item>& items) {
    return add(std::span<const Item>(items));
  }
  /// Vertex numbers of faces. Their corners may be rotated.
  Json add_faces(std::span<const Triangle> faces, std::size_t n_vertices);
  /// A file, as it is.
  Json add_file(std::string_view file);

  /// Afterwards nothing is left.
  std::vector<unsigned char> take() { return std::move(bytes_); }

 private:
  Json add_items(const void* items, std::size_t n, std::size_t size);

  std::vector<unsigned char> bytes_;
};

}  // namespace whittle::report
