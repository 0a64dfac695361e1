#pragma once

#include <span>
#include <utility>
#include <vector>

#include "complex/contraction_profile.hh"
#include "cost/attributes/surface_attributes.hh"
#include "cost/attributes/wedge_pairs.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/engine/formula/pair_evaluation.hh"

namespace whittle {

/// What a pair's attributes cost.
struct PairAttributes {
  Quadric quadric;  ///< about the first vertex
  double most = 0;  ///< they cost no more than that
  /// Whether the minimum, together with the planes, never falls as vertices merge. Where an end has several wedges, one
  /// may find a better match then.
  bool never_falls = true;
};

/// The same of four pairs.
struct PairAttributesLanes {
  QuadricSumLanes<Double4> quadric;
  Double4 most;
};

/// The cost and placement of contracting two vertices with attributes, which move the merged one, too, unless they
/// would cost more than they may.
PairEvaluation evaluate_with_attributes(const PlacedQuadric& v0, const PlacedQuadric& v1,
                                        const PairAttributes& attributes, Placement placement,
                                        PairConstraint constraint);

/// The attributes of vertices, a quadric for each wedge.
class AttributeQuadrics {
 public:
  /// None.
  AttributeQuadrics() = default;
  AttributeQuadrics(SurfaceAttributes attributes, std::size_t n_vertices);

  bool any() const { return wedges_.any(); }

  /// Each wedge of the end that has fewer joins that of the other end to which its values are nearest in the middle of
  /// the pair. Wedges of threshold pairs stay apart. \param a_to_b the way between both
  PairAttributes of(const Pair& pair, bool is_edge, const Vec3& a_to_b) const;
  /// Whether `of_four` takes a pair: each end has one wedge.
  bool is_simple(const VertexPair& pair) const { return has_one(pair.a) && has_one(pair.b); }
  /// As `of`, to the bit. \param pairs four edges that are simple
  WHITTLE_INLINE PairAttributesLanes of_four(const VertexPair* pairs, const PointLanes<Double4>& a_to_b) const {
    const auto numbers_at = [&](Index v) WHITTLE_INLINE_LAMBDA { return wedges_.numbers(first_[v]); };
    const FourWedges first{numbers_at(pairs[0].a), numbers_at(pairs[1].a), numbers_at(pairs[2].a),
                           numbers_at(pairs[3].a)};
    const FourWedges second{numbers_at(pairs[0].b), numbers_at(pairs[1].b), numbers_at(pairs[2].b),
                            numbers_at(pairs[3].b)};
    const PointLanes<Float4> b_to_a{rounded(-a_to_b.x), rounded(-a_to_b.y), rounded(-a_to_b.z)};
    const auto q = quadric_of_both<Float4>(first, second, wedges_.n_components(), b_to_a);
    const Double4 weight = widened(first(WedgeLayout::weight)[0]) + widened(second(WedgeLayout::weight)[0]);
    return {{widened(q.xx), widened(q.xy), widened(q.xz), widened(q.yy), widened(q.yz), widened(q.zz), widened(q.bx),
             widened(q.by), widened(q.bz), widened(q.c)},
            farthest_ * farthest_ * weight};
  }
  /// What `of` looks at, where there is no seam.
  void prefetch(const Pair& pair) const {
    for (const Index v : {pair.a, pair.b}) {
      if (first_[v] != invalid_index) wedges_.prefetch(first_[v]);
    }
  }
  void merge(const Change& change, bool is_edge);

  /// Those of some vertices, which get their places as numbers. None if there are none.
  SurfaceAttributes at(std::span<const Index> vertices) const;

 private:
  struct Match {
    Index wedge;
    std::size_t place;  ///< among those at its vertex
  };
  Match best_match(Index wedge, const Vec3& to_middle, Index many, std::uint64_t used) const;
  /// Calls `joined` with the wedges at a and at b that become one, `alone` with a vertex and a wedge there that joins
  /// none.
  template <class Joined, class Alone>
  void match(const Pair& pair, bool is_edge, const Vec3& a_to_b, const Joined& joined, const Alone& alone) const;
  std::size_t n_wedges_at(Index v) const;
  bool has_one(Index v) const { return first_[v] != invalid_index && next_[first_[v]] == invalid_index; }

  WedgeQuadrics wedges_;
  double farthest_ = 0;
  std::vector<Index> first_;                     ///< of the wedges at each vertex
  std::vector<Index> next_;                      ///< of those at the same vertex, after each wedge
  std::vector<Index> kept_;                      ///< scratch
  std::vector<std::pair<Index, Index>> joined_;  ///< scratch
};

}  // namespace whittle
