#pragma once

#include <span>

#include "index_lists.hh"
#include "whittle/engine/indexed_mesh.hh"

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
      : VertexCorners(faces, n_vertices, [](Index) { return true; }) {}
  /// Of some vertices. \param is_wanted tells by number which
  template <class IsWanted>
  VertexCorners(std::span<const Triangle> faces, std::size_t n_vertices, const IsWanted& is_wanted)
      : lists_(n_vertices, [&](const auto& add) {
          for (Index f = 0; f < faces.size(); ++f) {
            for (Index place = 0; place < 3; ++place) {
              if (is_wanted(faces[f][place])) add(faces[f][place], Corner{f, place});
            }
          }
        }) {}

  std::size_t n_vertices() const { return lists_.size(); }
  std::span<const Corner> of(Index v) const { return lists_.of(v); }

 private:
  IndexLists<Corner> lists_;
};

/// The corner so many places further on in its face.
inline Index corner_after(const Triangle& face, Index place, Index n) { return face[(place + n) % 3]; }

}  // namespace whittle
