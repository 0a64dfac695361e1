#pragma once

#include <optional>
#include <span>
#include <vector>

#include "complex/triangle_complex.hh"
#include "whittle/engine/formula/flip_limit.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/reach.hh"

namespace whittle {

/// What ranks and places contractions, as the order of contractions sees it.
class PairCost {
 public:
  virtual ~PairCost() = default;

  /// Of pairs whose lower original vertex comes first, edges before threshold pairs. Several threads may ask at once.
  virtual void evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const = 0;
  PairEvaluation evaluate(const Pair& pair) const {
    PairEvaluation evaluation;
    evaluate({&pair, 1}, {&evaluation, 1});
    return evaluation;
  }

  /// Where the merged vertex would best go, now that the faces around are gathered.
  virtual Vec3 place(const Pair&, const PairEvaluation& evaluation, const PairStar&) { return evaluation.position; }

  /// Whether a face around the pair placed last would turn too far with the merged vertex there; nullopt if the cost
  /// has not looked at the faces.
  virtual std::optional<bool> turns_a_face(const Vec3& /*position*/, const FlipLimit&) { return std::nullopt; }

  /// What contracting the pair placed last costs there: what it was evaluated to, or more.
  virtual double final_cost(const PairEvaluation& evaluation) const { return evaluation.cost; }

  /// Told that the pair placed last is to be contracted, to where its faces were looked at last. \param star as it was
  /// then \return what its vertex is to keep
  virtual PlacedQuadric merge(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) = 0;

  /// The power of a length that is the cost's unit.
  virtual double dimension() const = 0;

  /// Which pairs a contraction may make cheaper.
  virtual Reach reach() const = 0;

  /// Which vertices evaluations look at, beside the two of the pair: those around it need tidy lists.
  virtual Reach sight() const { return Reach::none; }

  /// Whether `merge` changes the quadrics of the merged vertex' neighbours.
  virtual bool changes_neighbours() const { return false; }

  /// Told after each contraction. \param changed vertices within reach or sight, the merged one first, all with tidy
  /// lists; none if not asked for
  virtual void note_contraction(std::span<const Index> /*changed*/) {}
};

}  // namespace whittle
