#pragma once

#include <cstddef>
#include <span>

#include "complex/triangle_complex.hh"
#include "cost/memory.hh"
#include "whittle/core/detail/compiler.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/host.hh"
#include "whittle/engine/reach.hh"

namespace whittle {

/// What a cost keeps about a vertex, as memory to be fetched before it is asked for.
struct VertexState {
  const std::byte* begin = nullptr;
  std::size_t stride = 0;  ///< bytes a vertex; 0 = nothing is kept

  void prefetch(Index v) const { prefetch_line(begin + stride * v); }
};

/// Ranks pairs, then settles where the merged vertex goes and what that costs. A cost keeps what it needs to know about
/// vertices. Between calls it remembers nothing about pairs; the profile has room for what several calls share.
///
/// Life of a cost, told by the loop:
///
///   see_faces()                    the faces of each vertex are listed
///   see_seams(planes)              only if there are some, and nothing is to be recalled; faces are still listed
///   see_attributes(attributes)         only if some count
///   start()                        neighbours and edges are known
///   resume(state)                  only if the run goes on from another one
///   recall(memory)                 only if others worked on the surface before
///   rank(pairs)                    whenever the queue asks; looks at vertices alone
///   settle(profile, ranked)        a pair's turn has come: positions to try, the best first
///   final_cost(profile, ranked, p) the guards accept position p
///   merge(profile, ranked, change) the pair was contracted
class PairCost {
 public:
  virtual ~PairCost() = default;

  virtual void see_faces(unsigned /*threads*/) {}
  /// \param planes of seams and rims (`seam_planes`), by number in the input
  virtual void see_seams(std::span<const Memory::Remembered> /*planes*/) {}
  virtual void see_attributes(SurfaceAttributes&& /*attributes*/) {}
  virtual void start(unsigned /*threads*/) {}
  /// Takes what was kept about vertices from an earlier run. Called after `start`. \param state by number in the input
  virtual void resume(const DecimationState& /*state*/) {}

  /// Takes what is known from passes over the same surface before. Called after `start`.
  virtual void recall(const Memory& /*memory*/) {}
  /// Whether what is kept about v can't be told from its faces.
  virtual bool remembers(Index /*v*/) const { return false; }
  /// The planes of seams that v remembers, if these are all that it remembers; or null.
  virtual const Quadric* remembered_seams(Index /*v*/) const { return nullptr; }
  /// What is kept about the attributes of some vertices, which get their places as numbers.
  virtual SurfaceAttributes attributes_at(std::span<const Index> /*vertices*/) const { return {}; }
  /// What is remembered about the faces as they were at the start.
  virtual MeanFaceArea face_area() const { return {}; }

  /// \param pairs each with the vertex of the lower original number first, edges before threshold pairs. Several
  /// threads
  ///        may ask at once.
  virtual void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const = 0;
  /// Likewise, with less work where a pair costs at least `enough`: its rank may cost less than it does, but that much.
  virtual void rank_up_to(double /*enough*/, std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const {
    rank(pairs, ranks);
  }
  PairEvaluation rank(const Pair& pair) const {
    PairEvaluation ranked;
    rank({&pair, 1}, {&ranked, 1});
    return ranked;
  }

  /// Where the merged vertex may go, the best position first.
  virtual Settlement settle(ContractionProfile& /*profile*/, const PairEvaluation& ranked) const {
    Settlement settlement;
    settlement.add(ranked.position);
    return settlement;
  }

  /// What a contraction to `position` costs: its rank, or more.
  virtual double final_cost(const ContractionProfile& /*profile*/, const PairEvaluation& ranked,
                            const Vec3& /*position*/) const {
    return ranked.cost;
  }

  /// Updates what is kept about vertices. \param profile as it was before the contraction
  virtual void merge(ContractionProfile& /*profile*/, const PairEvaluation& /*ranked*/, const Change& /*change*/) {}

  /// What is kept about v as a quadric: nothing, unless the cost has quadrics.
  virtual PlacedQuadric quadric(Index v) const = 0;

  /// What `rank` looks at.
  virtual VertexState vertex_state() const { return {}; }

  /// Which pairs a contraction may make cheaper.
  virtual Reach reach() const = 0;

  /// Around which vertices `rank` looks at lists, which must be compact there.
  virtual Reach sight() const { return Reach::none; }

  /// Whether `merge` changes what is kept about the merged vertex' neighbours.
  virtual bool changes_neighbours() const { return false; }
};

}  // namespace whittle
