#pragma once

#include <array>
#include <span>
#include <vector>

#include "complex/neighbour_lists.hh"
#include "whittle/engine/formula/merged_ring.hh"
#include "whittle/engine/formula/pair_evaluation.hh"

namespace whittle {

/// A face at a vertex v, by its other two corners: the face is (v, x, y), counter-clockwise. It is the edge of v's link
/// in that face.
struct LinkEdge {
  Index x, y;
};

/// Faces at a vertex, each as a link edge.
class StarFaces {
 public:
  StarFaces() = default;
  /// Each two consecutive neighbours in `fan` make a face.
  static StarFaces of_fan(std::span<const Neighbour> fan) { return {fan, 1, fan.empty() ? 0 : fan.size() - 1}; }
  /// Neighbours 0 and 1 make a face, then 2 and 3, and so on.
  static StarFaces of_pairs(std::span<const Neighbour> pairs) { return {pairs, 2, pairs.size() / 2}; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  LinkEdge operator[](std::size_t i) const {
    return {neighbours_[i * stride_].vertex, neighbours_[i * stride_ + 1].vertex};
  }
  std::span<const Neighbour> neighbours() const { return neighbours_; }
  /// The other two corners of face i.
  std::span<const Neighbour> corners_of(std::size_t i) const { return neighbours_.subspan(i * stride_, 2); }

 private:
  StarFaces(std::span<const Neighbour> neighbours, std::size_t stride, std::size_t size)
      : neighbours_(neighbours), stride_(stride), size_(size) {}

  std::span<const Neighbour> neighbours_;
  std::size_t stride_ = 1;
  std::size_t size_ = 0;
};

/// Two vertices that may become one: joined by an edge, or closer than a threshold. a has the lower original number.
struct Pair {
  Index id;
  Index a, b;
};

/// Everything that costs and guards look at before a contraction: the pair's two stars.
///
///             o1                o0, o1: opposite vertices, the third corners of the faces that vanish
///           / |  \ .            first:  the faces at a without b, from o1 counter-clockwise to o0
///     x1 - a--+---b - y1        second: the faces at b without a, from o0 counter-clockwise to o1
///           \ |  / .
///     x2      o0      y2
///
/// Valid until the next contraction.
struct ContractionProfile {
  /// A common neighbour of the pair.
  struct Common {
    Index vertex;
    std::array<Index, 2> edges;  ///< from a and from b to it; an edge that was merged leads to the live one
  };

  Pair pair;
  PairEvaluation ranked;  ///< its rank, now that its turn has come
  Index survivor;         ///< which of both is to survive, once the position is known

  StarFaces first;                ///< faces at a without b
  StarFaces second;               ///< faces at b without a
  std::vector<Common> opposites;  ///< the third corner of each face of a and b

  /// What a contraction does to the one-rings where the link condition does not hold (nonmanifold_contraction.hh).
  struct NonmanifoldPlan {
    std::vector<Common> common;                 ///< all common neighbours, ascending
    std::vector<std::vector<Neighbour>> faces;  ///< at each of them afterwards, in pairs; the merged vertex is called a
    std::array<std::vector<Neighbour>, 2> left;  ///< faces at a and at b that do not vanish, in pairs
    std::vector<LinkEdge> coincident;            ///< faces that vanish because they would coincide with others
    std::vector<Index> lost_edges;               ///< edges that lose all their faces
  };
  bool is_nonmanifold = false;  ///< If so, `first` and `second` are without the coincident faces.
  NonmanifoldPlan nonmanifold;

  /// The faces around the pair as one ring, if the cost has looked at them (`MergedRing`); guards look there, too.
  bool has_ring = false;
  MergedRing ring;

  /// Common neighbours of which edges become one.
  const std::vector<Common>& merged_neighbours() const { return is_nonmanifold ? nonmanifold.common : opposites; }
  /// Calls `use` with each neighbour of the pair, with some several times.
  template <class Use>
  void for_each_neighbour(const Use& use) const {
    for (const StarFaces& faces : {first, second}) {
      for (const Neighbour& neighbour : faces.neighbours()) use(neighbour.vertex);
    }
    for (const Common& common : merged_neighbours()) use(common.vertex);
  }
};

/// What a contraction did. Everyone who keeps something about vertices or pairs is told by this record.
struct Change {
  /// Two edges that became one.
  struct MergedEdges {
    Index vertex;                ///< their common end, a neighbour of both vertices
    std::array<Index, 2> edges;  ///< the live edges of a and of b before; equal if they were one already
    Index kept;                  ///< the one that lives on
  };

  Pair pair;                       ///< the pair before
  Index survivor, removed;         ///< one is a, the other is b
  std::array<Vec3, 2> before;      ///< positions of a and b before
  Vec3 position;                   ///< of the merged vertex
  std::vector<MergedEdges> edges;  ///< a and b as in `pair`
  std::vector<Index> touched;      ///< the merged vertex and the neighbours that costs asked for; lists are compact
};

}  // namespace whittle
