#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "attributes/kept_areas.hh"
#include "blocks/decimate_in_blocks.hh"
#include "loop/pass.hh"
#include "loop/remainder.hh"

namespace whittle {

/// What has been done, in blocks and in passes.
struct Done {
  std::optional<Remainder> left;  ///< before the first contraction: none
  DecimateResult result;
  double progress = 0;                           ///< that has been told
  std::optional<double> max_cost_in_blocks;      ///< none if there are none
  double max_cost_of_pass = 0;                   ///< of the last one
  bool is_cancelled = false;                     ///< in blocks
  std::optional<NonmanifoldCounts> nonmanifold;  ///< of what is left; none if it was to go on
  RunSteps steps;                                ///< where they are wanted, or are told in the end
  std::vector<RefusedPair> refused;              ///< of the last pass, if it could do no more; by the input's vertices
};

/// What guards of a pass keep, besides what options say.
struct PassLimits {
  std::optional<double> displacement{};      ///< of the surface by one contraction, in the frame
  std::vector<double> displacements{};       ///< of the vertices that the pass begins with, where they differ
  const ErrorBound* error_bound = nullptr;   ///< as that of `LoopContext`
  const ErrorBound* border_bound = nullptr;  ///< likewise
};

struct PassStart;
class Preparation;

/// Contracts in blocks and in passes over all, one after the other, and makes the output of what they leave.
class Passes {
 public:
  /// All but the target must outlive it. \param host null for none
  Passes(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options, DecimationHost* host);

  const IndexedMesh& mesh() const { return mesh_; }
  const DecimateTarget& target() const { return target_; }
  const DecimateOptions& options() const { return options_; }
  const Frame& frame() const { return frame_; }

  /// Done so far. It may be set to what was done earlier.
  Done& done() { return done_; }
  const Done& done() const { return done_; }
  bool is_cancelled() const { return done_.result.stop == StopReason::cancelled; }
  std::size_t n_faces_left() const { return done_.left ? done_.left->faces.size() : mesh_.faces.size(); }
  std::size_t n_vertices_left() const { return done_.left ? done_.left->positions.size() : mesh_.positions.size(); }
  /// Of blocks and passes from now on.
  void set_limits(PassLimits limits) { limits_ = std::move(limits); }
  /// Whether blocks and passes from now on keep their steps, whatever the options say.
  void keep_steps_of_all(bool keeps) { keeps_steps_of_all_ = keeps; }

  /// \return why it was done otherwise; empty if blocks have contracted
  std::string_view contract_in_blocks(const DecimateTarget& target, const BlockPlan& plan);
  /// Contracts what is left, or the input, in one pass. \param is_last whether no other pass follows
  void contract_to(const DecimateTarget& stop, bool is_last);
  /// Where to pause, and at last the target.
  std::vector<DecimateTarget> stops() const;
  /// Lets the pause change what is left. \return whether to go on
  bool adjust();
  /// Whether blocks may have made contractions in exact order that come after the last one.
  bool is_beyond_target() const;
  void forget_all();
  Decimation output(bool keeps_in_charts);

 private:
  double way_to(const DecimateTarget& stop) const;
  void begin_with_input(PassStart& start, const DecimateOptions& options, Preparation& preparation);
  void begin_with_remainder(PassStart& start);
  void begin_with_attributes(PassStart& start);
  void begin_with_areas(PassStart& start, const DecimateTarget& stop);
  const KeptAreas& areas();
  DecimateResult run(Pass& pass, const DecimateTarget& stop, Preparation& preparation) const;
  void count_before(Pass& pass);
  NonmanifoldCounts count_nonmanifold(const Surface& surface) const;
  bool is_listener_told_at_end() const { return options_.listener && target_.error_limit(); }
  bool keeps_steps() const { return options_.keep_steps || is_listener_told_at_end() || keeps_steps_of_all_; }
  DecimateOptions options_of_pass(double end);
  void keep_steps_of_pass(std::span<Contraction> log);
  void keep_refused_pairs(Pass& pass);

  const IndexedMesh& mesh_;
  DecimateTarget target_;
  const DecimateOptions& options_;
  DecimationHost* host_;
  Frame frame_;
  PassLimits limits_;
  bool keeps_steps_of_all_ = false;
  Done done_;
  std::optional<NonmanifoldCounts> nonmanifold_before_;  ///< of the input
  std::optional<KeptAreas> areas_;                       ///< of the input, once they are asked for
  ThresholdPairCounts pairs_;                            ///< of the input
};

}  // namespace whittle
