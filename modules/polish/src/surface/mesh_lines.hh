#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle::polishing {

enum class LineKind : std::uint8_t { border, feature, seam };
constexpr std::size_t n_line_kinds = 3;

/// The edges of a mesh's lines: its border, its features and its seams.
class MeshLines {
 public:
  struct Edge {
    Index from, to;
    LineKind kind;
  };

  MeshLines(std::span<const VertexPair> borders, std::span<const VertexPair> features,
            std::span<const VertexPair> seams, std::size_t n_vertices);

  bool empty() const { return edges_.empty(); }
  /// Whether there are lines besides the border.
  bool has_inner() const { return !edges_.empty() && edges_.back().kind != LineKind::border; }
  const std::vector<Edge>& edges() const { return edges_; }
  /// Indices of the edges at a vertex.
  std::span<const Index> at(Index v) const { return edges_at_.of(v); }

 private:
  std::vector<Edge> edges_;
  detail::IndexLists<Index> edges_at_;
};

}  // namespace whittle::polishing
