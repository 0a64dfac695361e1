#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// A vertex in one of its faces.
struct Corner {
  Index face;
  Index place;  ///< among the face's corners
};

/// The faces of each vertex of a mesh, ascending.
class VertexCorners {
 public:
  VertexCorners() = default;
  explicit VertexCorners(const IndexedMesh& mesh) : VertexCorners(mesh.faces, mesh.positions.size()) {}
  VertexCorners(std::span<const Triangle> faces, std::size_t n_vertices)
      : lists_(n_vertices, [faces](const auto& add) {
          for (Index f = 0; f < faces.size(); ++f) {
            for (Index place = 0; place < 3; ++place) add(faces[f][place], Corner{f, place});
          }
        }) {}
  /// Of some vertices. \param is_wanted per vertex, 1 or 0
  VertexCorners(std::span<const Triangle> faces, std::span<const std::uint8_t> is_wanted) {
    std::vector<Index> found;
    for (Index f = 0; f < faces.size(); ++f) {
      const auto& [a, b, c] = faces[f];
      if ((is_wanted[a] | is_wanted[b] | is_wanted[c]) != 0) found.push_back(f);
    }
    lists_ = {is_wanted.size(), [&](const auto& add) {
                for (const Index f : found) {
                  for (Index place = 0; place < 3; ++place) {
                    if (is_wanted[faces[f][place]] != 0) add(faces[f][place], Corner{f, place});
                  }
                }
              }};
  }

  std::size_t n_vertices() const { return lists_.size(); }
  std::span<const Corner> of(Index v) const { return lists_.of(v); }

 private:
  IndexLists<Corner> lists_;
};

/// The corner so many places further on in its face.
inline Index corner_after(const Triangle& face, Index place, Index n) { return face[(place + n) % 3]; }

}  // namespace whittle
