#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/detail/large_array.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

// A side is a face's own part of an edge. Side i of face f runs from corner i of the face to the next corner, and has
// the number 3f + i. An edge is the set of all sides between the same two vertices.
//
// Faces with two equal corners (`has_three_corners`) have no sides.

namespace whittle::detail {

inline Index face_of(Index side) { return side / 3; }
inline Index next_in_face(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
inline Index previous_in_face(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }
inline Index start_of(Index side, std::span<const Triangle> faces) { return faces[side / 3][side % 3]; }

/// The edges of a set of faces, ascending by vertices, each with its sides.
class EdgeTable {
 public:
  EdgeTable() = default;
  /// Takes O(F) time where each vertex has few edges.
  /// \param is_chosen per face, 0 leaves it out; or empty: all faces
  /// \pre all vertex numbers are below `n_vertices`
  /// \throw std::length_error for 2³² / 3 faces or more
  EdgeTable(std::span<const Triangle> faces, std::size_t n_vertices, std::span<const std::uint8_t> is_chosen = {});

  std::size_t size() const { return edges_.size() - 1; }  ///< number of edges
  const VertexPair& operator[](std::size_t edge) const { return edges_[edge].ends; }
  /// The sides at an edge, ascending; at least one.
  std::span<const Index> sides(std::size_t edge) const {
    return std::span(sides_).subspan(edges_[edge].first, edges_[edge + 1].first - edges_[edge].first);
  }
  /// Whether the edge has exactly two faces, and these run along it in opposite directions.
  bool is_regular(std::size_t edge, std::span<const Triangle> faces) const {
    const std::span<const Index> both = sides(edge);
    return both.size() == 2 && start_of(both[0], faces) != start_of(both[1], faces);
  }

 private:
  friend std::vector<VertexPair> border_edges(std::span<const Triangle>, std::size_t, unsigned);
  friend std::vector<std::uint8_t> border_vertices(std::span<const Triangle>, std::size_t, unsigned);

  struct Edge {
    VertexPair ends;
    Index first;  ///< index of its first side
  };

  /// \param for_each_own_side calls its argument with `(from, to, number)` for each side, by ascending number
  template <class ForEachSide>
  void build(std::size_t n_vertices, const ForEachSide& for_each_own_side);

  /// Edges with exactly one side, among edges with `is_candidate(from, to)`, ascending.
  /// \pre either all sides of an edge are candidates or none is
  template <class IsCandidate>
  static std::vector<VertexPair> border_edges_among(std::span<const Triangle> faces, std::size_t n_vertices,
                                                    unsigned threads, const IsCandidate& is_candidate);

  LargeArray<Edge> edges_ = LargeArray<Edge>(1, Edge{});  ///< plus one that marks the end of the last edge's sides
  LargeArray<Index> sides_;                               ///< by edge
};

/// Edges with exactly one side, ascending. Several times as fast as an `EdgeTable`: it sorts only sides whose vertices
/// may both lie on a border.
/// \param threads 0 = all cores
/// \pre, \throw as `EdgeTable`
std::vector<VertexPair> border_edges(std::span<const Triangle> faces, std::size_t n_vertices, unsigned threads = 1);

/// Per vertex, 1 if it is an end of a border edge. Faster than `border_edges` where the faces share few vertices.
/// \param threads 0 = all cores
/// \pre, \throw as `EdgeTable`
std::vector<std::uint8_t> border_vertices(std::span<const Triangle> faces, std::size_t n_vertices,
                                          unsigned threads = 1);

}  // namespace whittle::detail
