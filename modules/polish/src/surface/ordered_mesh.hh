#pragma once

#include <span>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle::polishing {

/// A mesh with its vertices numbered along a Morton curve, and its faces by their lowest vertex. Neighbours are near in
/// memory, and vertices with successive numbers form a patch.
class OrderedMesh {
 public:
  /// \param frame of the positions \param threads 0 = all cores
  OrderedMesh(const IndexedMesh& from, const Frame& frame, unsigned threads);

  IndexedMesh mesh;  ///< positions and faces

  // From the input mesh to this one.
  std::vector<Index> map(std::span<const Index> vertices) const;  ///< `invalid_index` stays
  std::vector<VertexPair> map(std::span<const VertexPair> edges) const;
  std::vector<std::uint8_t> per_vertex(std::span<const std::uint8_t> values) const;  ///< empty stays empty
  std::vector<Index> per_face(std::span<const Index> values) const;                  ///< empty stays empty

  /// Writes positions and faces. \param to the input mesh
  void write_to(IndexedMesh& to) const;

 private:
  std::vector<Index> vertices_;  ///< by number here, the number there
  std::vector<Index> numbers_;   ///< by number there, the number here
  std::vector<Index> faces_;     ///< by number here, the number there
};

}  // namespace whittle::polishing
