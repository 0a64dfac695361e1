#pragma once

#include <span>
#include <vector>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::polishing {

/// A vertex as a corner of one of its faces.
struct Corner {
  Index face;
  Index slot;  ///< which of the face's corners, 0 … 2
};

/// The corners of each vertex, ascending by face.
using VertexCorners = detail::IndexLists<Corner>;

inline VertexCorners corners_by_vertex(std::span<const Triangle> faces, std::size_t n_vertices) {
  return {n_vertices, [faces](const auto& add) {
            for (Index f = 0; f < faces.size(); ++f) {
              for (Index slot = 0; slot < 3; ++slot) add(faces[f][slot], Corner{f, slot});
            }
          }};
}

/// The corner `n` slots further on in its face.
inline Index corner_after(const Triangle& face, Index slot, Index n) { return face[(slot + n) % 3]; }

}  // namespace whittle::polishing
