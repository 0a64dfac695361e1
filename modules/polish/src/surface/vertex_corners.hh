#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::polishing {

/// A vertex as a corner of one of its faces.
struct Corner {
  Index face;
  Index slot;  ///< which of the face's corners, 0 … 2
};

/// For each vertex its corners, ascending by face.
using VertexCorners = detail::IndexLists<Corner>;

inline VertexCorners corners_by_vertex(std::span<const Triangle> faces, std::size_t n_vertices) {
  return {n_vertices, [faces](const auto& add) {
            for (Index f = 0; f < faces.size(); ++f) {
              for (Index slot = 0; slot < 3; ++slot) add(faces[f][slot], Corner{f, slot});
            }
          }};
}

/// The corners of some vertices; the other lists are empty. \param is_wanted per vertex, 1 or 0 \throw Cancelled
inline VertexCorners corners_by_vertex(std::span<const Triangle> faces, std::span<const std::uint8_t> is_wanted,
                                       const detail::Workers& workers) {
  std::vector<std::vector<Index>> found((faces.size() + range_length - 1) / range_length);  // by range
  for_each_range(faces.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<Index>(begin); f < end; ++f) {
      const auto& [a, b, c] = faces[f];
      if ((is_wanted[a] | is_wanted[b] | is_wanted[c]) != 0) found[begin / range_length].push_back(f);
    }
  });
  return {is_wanted.size(), [&](const auto& add) {
            for (const std::vector<Index>& part : found) {
              for (const Index f : part) {
                for (Index slot = 0; slot < 3; ++slot) {
                  if (is_wanted[faces[f][slot]] != 0) add(faces[f][slot], Corner{f, slot});
                }
              }
            }
          }};
}

/// The corner `n` slots further on in its face.
inline Index corner_after(const Triangle& face, Index slot, Index n) { return face[(slot + n) % 3]; }

}  // namespace whittle::polishing
