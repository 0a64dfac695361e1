#pragma once

#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "decimate/plain_run.hh"
#include "decimate/staged_run.hh"
#include "error/error_bounds.hh"

namespace whittle {

/// Contracts as far as the target's error limit allows, and proves that what is left keeps it (docs/dev/max-error.md).
class ErrorLimitedRun {
 public:
  /// \param run before the first stage; with an error limit. It is left to be finished
  explicit ErrorLimitedRun(StagedRun& run) : run_(run), limit_(*run.target().error_limit() * run.frame().scale) {}

  /// \return what the proofs were made with
  std::unique_ptr<ErrorBounds> contract(const BlockPlan& plan);

 private:
  const DecimateTarget& target() const { return run_.target(); }
  /// \pre something was contracted
  const WorkingSurface& left() const { return run_.surface(); }
  bool is_target_reached() const { return target().is_reached_at(run_.n_faces_left(), run_.n_vertices_left()); }
  bool has_tolerances() const { return !run_.options().tolerances.empty(); }
  std::future<std::unique_ptr<ErrorBounds>> begin_bounds();
  void contract_to_coarse_copy(const BlockPlan& plan);
  DecimateTarget least_left_in_blocks() const;
  void contract_to_shares_of_limit(const std::vector<double>& shares, const BlockPlan& plan);
  void lower_shares_at(const std::vector<Index>& vertices, std::vector<double>& shares) const;
  void contract_what_moves_little(const StageLimits& limits, const BlockPlan& plan);
  std::vector<Index> map_from_start() const;
  void make_coarse_bound(const WorkingSurface& start);
  ErrorBound& guarding_bound() { return coarse_bound_ ? *coarse_bound_ : error_bounds_->surface(); }
  ErrorBound::Violations find_violations_before_guarding();
  bool contract_guarded();
  bool may_move_vertices() const;
  bool move_to_far_points(IndexedMesh surface, ErrorBound::Violations violations);
  bool contract_guarded_from_input(const BlockPlan& plan);
  bool end_with(const StagedRun::State& state);
  void contract_nothing();
  bool contract_in_steps(const BlockPlan& plan);
  void make_plain_run(bool begins_with_input, const BlockPlan& plan);
  bool has_plain_level_far_below(const BlockPlan& plan);
  bool has_plain_level_near();
  bool contract_from_plain_level(const BlockPlan& plan);
  void contract_no_more();
  std::unique_ptr<ErrorBounds> end();

  StagedRun& run_;
  double limit_;  ///< of the error, in the frame
  std::unique_ptr<ErrorBounds> error_bounds_;
  std::optional<PlainRun> plain_run_;
  std::unique_ptr<ErrorBound> coarse_bound_;  ///< of the surface, to a coarse copy of the input; or null
  std::vector<Index>
      start_origins_;  ///< vertices that the second step begins with → those of the input; empty if these
};

}  // namespace whittle
