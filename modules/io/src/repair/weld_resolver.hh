#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// Decides which vertices at the ends of doubtful edges become one, such that no edge gets a third face.
///
/// Vertices are joined in sets. A doubtful edge is a pair of positions. At each end its faces use one or more sets, and
/// every pair of sets that a face uses is an *actual edge*. `join` refuses to merge actual edges that have more than
/// two faces together. Only doubtful edges are known here: no other edge can get a third face.
class WeldResolver {
 public:
  /// Adds a vertex of the mesh. \pre vertices ascend and come before the first edge.
  void add_vertex(Index vertex);
  /// Adds a doubtful edge. The faces added next belong to it.
  void begin_edge() { edges_.emplace_back(); }
  /// Adds a face of the current edge. \param ends the face's vertices at the lower and at the higher position.
  /// \param forward the face runs along the edge from lower to higher. \param normal of unit length, or zero
  void add_face(const std::array<Index, 2>& ends, bool forward, const Vec3& normal);

  /// Makes one of two vertices at the same position, unless an edge would get a third face. \return whether they are
  /// one.
  bool join(Index a, Index b);

  /// Joins pairs of faces at doubtful edges where both faces are still open. First come faces that have one end in
  /// common already. Then come, edge by edge, the first faces that fit; after each, again all with an end in common.
  /// Pairs that run in opposite directions along the edge come before pairs in the same direction. Edges with more than
  /// 16 faces stay as they are. \param folds whether faces may be joined that lie on each other, as the front and the
  /// back of a sheet do
  void join_open_edges(bool folds);

  /// The lowest vertex of the set.
  Index lowest_joined(Index vertex) const { return lowest_[find(set_of_.at(vertex))]; }

 private:
  using Set = std::uint32_t;
  struct Face {
    std::array<Set, 2> ends;  // As added. find() gives the present set.
    bool forward;
    Vec3 normal;
  };
  struct Use {  // An end of a face that uses a set.
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
  bool lie_on_each_other(std::uint32_t edge, std::uint32_t f, std::uint32_t g) const;
  bool try_pair(std::uint32_t edge, std::uint32_t f, std::uint32_t g);
  void pair_faces(std::uint32_t edge, bool need_common_end);
  void follow();

  std::unordered_map<Index, Set> set_of_;
  mutable std::vector<Set> parent_;
  std::vector<Index> lowest_;
  std::vector<std::vector<Use>> uses_;  // Of each set.
  std::vector<std::vector<Face>> edges_;
  std::unordered_map<ActualEdge, std::uint32_t, ActualEdgeHash> faces_at_;
  bool folds_ = false;                    // As `join_open_edges` has it.
  std::vector<std::uint32_t> to_follow_;  // Edges at which sets were joined.
};

}  // namespace whittle::io
