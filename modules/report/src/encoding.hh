#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// How a page stores its arrays. encoding.cc compresses them by meshoptimizer; a browser that makes a page for itself
// takes them as they are (modules/web/src/page/plain_encoding.cc).

namespace whittle::report {

/// Appends items whose size is a multiple of four bytes. \return the codec, for the viewer
std::string_view append_items(std::vector<unsigned char>& bytes, const void* items, std::size_t n, std::size_t size);

/// Appends vertex numbers of faces, whose corners may be rotated. \return the codec, for the viewer
std::string_view append_faces(std::vector<unsigned char>& bytes, std::span<const Triangle> faces,
                              std::size_t n_vertices);

/// The faces in the order in which they take the fewest bytes, which says nothing of their numbers before.
std::vector<Triangle> in_short_order(std::span<const Triangle> faces, std::size_t n_vertices);

}  // namespace whittle::report
