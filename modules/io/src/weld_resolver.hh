#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// Decides which vertices at the ends of doubtful edges become one, such that no edge gets a third face by it.
///
/// Vertices are joined in sets. A doubtful edge (a pair of positions) has as many actual edges as there are pairs of
/// sets that its faces use at the two ends; `join` refuses to make one of two or more faces out of others with a third.
/// Only doubtful edges are known here: all others stay legal whatever is joined.
class WeldResolver {
 public:
  /// A vertex of the mesh, in ascending order, before the first edge.
  void add_vertex(Index vertex);
  /// A doubtful edge; the faces added next are its.
  void begin_edge() { edges_.emplace_back(); }
  /// \param ends the face's vertices at the lower and the higher position. \param forward it runs from lower to higher.
  void add_face(const std::array<Index, 2>& ends, bool forward);

  /// Makes two vertices at one position one, unless an edge would get a third face. \return whether they are one now.
  bool join(Index a, Index b);

  /// Joins faces across doubtful edges where both are still open there: first those that have one end in common
  /// already; then, edge by edge, the first that fit, each time followed by what has come to have an end in common.
  /// Faces that run the other way along the edge come before those that run the same way. Edges of more than 16 faces
  /// are left as they are.
  void join_open_edges();

  /// The lowest vertex of the set.
  Index lowest_joined(Index vertex) const { return lowest_[find(set_of_.at(vertex))]; }

 private:
  using Set = std::uint32_t;
  struct Face {
    std::array<Set, 2> ends;  // as added; find() tells the set now
    bool forward;
  };
  struct Use {  // of an edge, by a set
    std::uint32_t edge;
    std::uint32_t face;
    std::uint8_t end;
  };
  struct ActualEdge {
    std::uint32_t edge;
    Set low;
    Set high;
    bool operator==(const ActualEdge&) const = default;
  };
  struct ActualEdgeHash {
    std::size_t operator()(const ActualEdge& e) const;
  };

  Set find(Set set) const;
  ActualEdge actual_edge(std::uint32_t edge, std::uint32_t face) const;
  bool is_open(std::uint32_t edge, std::uint32_t face) const;
  bool can_join(Set a, Set b) const;
  bool join_sets(Set a, Set b);
  bool try_pair(std::uint32_t edge, std::uint32_t f, std::uint32_t g);
  void pair_faces(std::uint32_t edge, bool need_common_end);
  void follow();

  std::unordered_map<Index, Set> set_of_;
  mutable std::vector<Set> parent_;
  std::vector<Index> lowest_;
  std::vector<std::vector<Use>> uses_;  // of each set
  std::vector<std::vector<Face>> edges_;
  std::unordered_map<ActualEdge, std::uint32_t, ActualEdgeHash> faces_at_;
  std::vector<std::uint32_t> to_follow_;  // edges at which sets were joined
};

}  // namespace whittle::io
