#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "blocks/block.hh"
#include "blocks/shared_progress.hh"
#include "loop/stage_report.hh"

namespace whittle {

/// What all levels have in common.
struct LevelContext {
  const StageContext& stage;
  const IndexedMesh& input;
  double target_share = 0;  ///< of the input's faces or vertices
  SharedProgress& progress;
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
  /// Non-manifold edges and vertices of the input. If there are more, by a sample of the blocks, nothing is done.
  double most_nonmanifold = std::numeric_limits<double>::infinity();
};

/// The cost that a sample of the blocks finds. \pre the plan is a trial
double find_cost(const LevelContext& context, const LevelPlan& plan, double surplus, WorkingSurface& surface);

/// Contracts what lies within blocks, all up to the same cost, and puts together what is left.
/// \param surface with cost state \param report gets what was done. `before` are counts of the surface, if it is the
///        input, unless the level was cancelled
/// \return the cost, in the frame; none if nothing was done
std::optional<double> run_level(const LevelContext& context, const LevelPlan& plan, const LevelGoal& goal,
                                WorkingSurface& surface, StageReport& report);

/// Contracts the surface as one block in rounds, until a target is reached, or nothing more can be contracted.
/// \param surface, report as those of `run_level`
void contract_in_rounds(const LevelContext& context, const DecimateTarget& target, WorkingSurface& surface,
                        StageReport& report);

}  // namespace whittle
