#pragma once

#include <optional>
#include <vector>

#include "blocks/block.hh"
#include "blocks/shared_progress.hh"
#include "loop/remainder.hh"

namespace whittle {

/// What levels have left of the input.
struct LevelRemainder : Remainder {
  DecimateResult result;          ///< what was done; counts of what is left are not filled in
  double cost_limit = 0;          ///< that the blocks ran up to, in the frame
  NonmanifoldCounts nonmanifold;  ///< of the input, unless the levels were cancelled
  double progress = 0;            ///< [0, 1]
  bool is_cancelled = false;
  bool is_futile = false;  ///< in exact order blocks can't do enough; nothing else here is filled in
};

/// What all levels have in common.
struct LevelContext {
  const DecimateOptions& options;
  const IndexedMesh& input;
  Frame frame;
  double target_share = 0;                   ///< of the input's faces or vertices
  std::optional<double> displacement_limit;  ///< as that of `LoopContext`
  RunSteps* steps;                           ///< gets what is done; or null
  SharedProgress& progress;
  std::span<const Index> areas{};  ///< of the input's faces, as those of `AreasOfFaces`

  bool is_told() const { return steps != nullptr || options.listener; }
};

struct LevelPlan {
  std::size_t faces_per_block;
  double first_share;     ///< `make_partition`
  Role role;              ///< of each block
  bool is_trial = false;  ///< whether what is contracted is forgotten
};

/// Up to which cost the blocks contract.
struct LevelGoal {
  std::optional<double> cost;  ///< in the frame; empty: a sample of the blocks finds it
  double surplus = 1;          ///< how many times the target's share the sample is to leave
  double least_done = 0;       ///< share of what the target asks for; if two blocks do less, nothing is done
};

/// The cost that a sample of the blocks finds. \pre the plan is a trial
double find_cost(const LevelContext& context, const LevelPlan& plan, double surplus, const CostState& cost_state);

/// Contracts what lies within blocks, all up to the same cost, and puts together what is left.
/// \param cost_state of the input, if there were no levels before
/// \param before what levels before have left; null for none
LevelRemainder run_level(const LevelContext& context, const LevelPlan& plan, const LevelGoal& goal,
                         CostState cost_state, const LevelRemainder* before);

}  // namespace whittle
