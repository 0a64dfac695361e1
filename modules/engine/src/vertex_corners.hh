#pragma once

#include <span>
#include <vector>

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
  explicit VertexCorners(const IndexedMesh& mesh) : VertexCorners(mesh.faces, mesh.positions.size()) {}
  VertexCorners(std::span<const Triangle> faces, std::size_t n_vertices) : first_(n_vertices + 1) {
    for (const Triangle& face : faces) {
      for (const Index v : face) ++first_[v + 1];
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    corners_.resize(3 * faces.size());
    std::vector<Index> end(first_.begin(), first_.end() - 1);
    for (Index f = 0; f < faces.size(); ++f) {
      for (Index place = 0; place < 3; ++place) corners_[end[faces[f][place]]++] = {f, place};
    }
  }

  std::size_t n_vertices() const { return first_.size() - 1; }
  std::span<const Corner> of(Index v) const {
    return std::span(corners_).subspan(first_[v], first_[v + 1] - first_[v]);
  }

 private:
  std::vector<Index> first_;  ///< place of a vertex' first corner; one more at the end
  std::vector<Corner> corners_;
};

/// The corner so many places further on in its face.
inline Index corner_after(const Triangle& face, Index place, Index n) { return face[(place + n) % 3]; }

}  // namespace whittle
