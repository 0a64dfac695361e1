#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// True if two corners are the same vertex: such a face has no edges to speak of.
inline bool is_collapsed(const Triangle& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

/// True if `face`, which has that edge, runs along it from `from` to `to`.
inline bool runs_along(const Triangle& face, Index from, Index to) {
  return (face[0] == from && face[1] == to) || (face[1] == from && face[2] == to) || (face[2] == from && face[0] == to);
}

/// All edges of a mesh, each with its faces. Collapsed faces are left out.
class EdgeTable {
 public:
  struct Edge {
    Index low, high;    ///< Its vertices, low < high.
    std::size_t first;  ///< Of its faces in the common array.
  };

  /// O(F) time as long as vertices have few edges; every face's vertices must exist.
  explicit EdgeTable(const IndexedMesh& mesh);

  std::size_t size() const { return edges_.size() - 1; }
  /// Ascending by (low, high).
  const Edge& operator[](std::size_t edge) const { return edges_[edge]; }
  /// Faces at the edge, ascending; one or more.
  std::span<const Index> faces(std::size_t edge) const {
    return {faces_.data() + edges_[edge].first, faces_.data() + edges_[edge + 1].first};
  }

 private:
  std::vector<Edge> edges_;  ///< One more than there are edges: the last has the end of the faces.
  std::vector<Index> faces_;
};

/// The unit normals of both faces at an edge, one of them turned if they run along it the same way. Nothing unless the
/// edge has exactly two faces and both a normal to be trusted.
std::optional<std::array<Vec3, 2>> normals_at(const IndexedMesh& mesh, const EdgeTable& edges, std::size_t edge);

}  // namespace whittle::metrics
