#pragma once

#include <span>
#include <vector>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle::polishing {

/// The edges that make up a mesh's lines: its border and its features.
class MeshLines {
 public:
  struct Edge {
    Index from, to;
    bool is_border;  ///< else it is a feature
  };

  MeshLines(std::span<const VertexPair> borders, std::span<const VertexPair> features, std::size_t n_vertices);

  bool empty() const { return edges_.empty(); }
  const std::vector<Edge>& edges() const { return edges_; }
  /// Indices of the edges at a vertex.
  std::span<const Index> at(Index v) const { return edges_at_.of(v); }

 private:
  std::vector<Edge> edges_;
  detail::IndexLists<Index> edges_at_;
};

}  // namespace whittle::polishing
