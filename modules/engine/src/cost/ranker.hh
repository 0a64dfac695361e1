#pragma once

#include <cstddef>
#include <span>

#include "complex/contraction_profile.hh"
#include "whittle/core/detail/compiler.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/reach.hh"

namespace whittle {

/// What a cost keeps of each vertex to rank pairs by. Queues prefetch it.
struct KeptOfVertices {
  const std::byte* begin = nullptr;
  std::size_t stride = 0;              ///< bytes a vertex; 0 = nothing is kept
  bool changes_around_merged = false;  ///< whether a contraction changes that of neighbours, too

  void prefetch(Index v) const { prefetch_line(begin + stride * v); }
};

/// What queues ask of a cost: the ranks of pairs. It keeps nothing of pairs.
class Ranker {
 public:
  virtual ~Ranker() = default;

  /// Looks at what is kept of vertices alone. Several threads may ask at once.
  /// \param pairs each with the vertex of the lower original number first, edges before threshold pairs
  /// \param enough a pair that costs at least so much may get a lower rank, of at least so much
  virtual void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double enough) const = 0;

  /// Which pairs a contraction may make cheaper.
  virtual Reach affects() const = 0;

  /// Around which vertices `rank` looks at lists, which must be compact there.
  virtual Reach reads() const { return Reach::none; }

  virtual KeptOfVertices kept() const { return {}; }
};

}  // namespace whittle
