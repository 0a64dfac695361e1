#pragma once

#include <optional>
#include <vector>

#include "attributes/kept_areas.hh"
#include "blocks/contract_in_blocks.hh"
#include "loop/contractor.hh"
#include "loop/stage_report.hh"

namespace whittle {

class Preparation;

/// A run of `decimate`, stage by stage. Each takes the surface as the one before has left it, and adds to the report:
///
///   contract_in_blocks   what lies within blocks of a large mesh
///   contract             down to a count, or as far as limits allow
///   checkpoint           what `Pauses::adjust` does between two of them
///   finish               the mesh with its attributes, and what became of the input
class StagedRun {
 public:
  /// What the stages so far have left and done.
  struct State {
    WorkingSurface surface;
    StageReport report;
  };

  /// Before the first stage. All but the target must outlive it. \param host null for none
  StagedRun(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
            DecimationHost* host);

  const IndexedMesh& mesh() const { return mesh_; }
  const DecimateTarget& target() const { return target_; }
  const DecimateOptions& options() const { return options_; }
  const Frame& frame() const { return frame_; }
  const WorkingSurface& surface() const { return state_.surface; }
  StageReport& report() { return state_.report; }
  bool is_cancelled() const { return state_.report.result.stop == StopReason::cancelled; }
  std::size_t n_faces_left() const { return surface().faces.size(); }
  std::size_t n_vertices_left() const { return surface().positions.size(); }
  /// Where to stop for a checkpoint, and at last the target.
  std::vector<DecimateTarget> stops() const;

  const State& state() const { return state_; }
  void return_to(State state) { state_ = std::move(state); }
  /// \param progress that has been told
  void begin_anew(double progress);
  /// That of the options; of `automatic` what it comes to on this mesh.
  Topology topology();
  /// The target with counts at which none of the parts need vanish. \pre `topology` was asked for, and is automatic
  DecimateTarget target_with_parts() const;
  /// Whether stages from now on keep their steps, whatever the options say.
  void keep_steps_of_all(bool keeps) { keeps_steps_of_all_ = keeps; }

  // Stages. What they return is of the stage alone.

  /// \return with `why_in_one_pass` if blocks have contracted nothing
  DecimateResult contract_in_blocks(const DecimateTarget& target, const BlockPlan& plan,
                                    const StageLimits& limits = {});
  /// \param is_last whether nothing is contracted afterwards
  DecimateResult contract(const DecimateTarget& stop, bool is_last, const StageLimits& limits = {});
  /// \return whether to go on
  bool checkpoint();
  /// After the last stage. \param positions of all vertices, in the frame
  void move_vertices(std::vector<Vec3> positions);
  /// \param keeps_in_charts as that of `carry_attributes`
  Decimation finish(bool keeps_in_charts);

 private:
  WorkingSurface input() const;
  bool may_parts_matter();
  double n_faces_wanted() const;
  const KeptAreas& areas();
  bool is_listener_told_at_end() const { return options_.listener && target_.error_limit(); }
  bool keeps_steps() const { return options_.keep_steps || is_listener_told_at_end() || keeps_steps_of_all_; }
  bool is_told() const { return options_.listener || keeps_steps(); }
  std::vector<PassEnd::MovedVertex> put_vertices(std::vector<Vec3> positions);
  void note_nonmanifold(const DecimateResult& result);
  // contraction_stage.cc
  double way_to(const DecimateTarget& stop) const;
  static void tell_part_of_progress(double begin, double end, DecimateOptions& options);
  bool is_at(const DecimateTarget& stop) const;
  DecimateResult end_at_once(StageReport report);
  DecimateOptions options_of_stage(double end);
  ThresholdPairCounts prepare_input(const DecimateOptions& options, Preparation& preparation);
  void look_at_attributes_of_input();
  void count_before(Contractor& contractor);
  NonmanifoldCounts count_nonmanifold(const WorkingSurface& surface) const;
  DecimateResult run(Contractor& contractor, const DecimateTarget& stop, Preparation& preparation) const;
  void keep_steps_of_stage(std::span<Contraction> log, StageReport& report) const;
  std::vector<RefusedPair> refused_pairs(Contractor& contractor) const;

  const IndexedMesh& mesh_;
  DecimateTarget target_;
  const DecimateOptions& options_;
  DecimationHost* host_;
  Frame frame_;
  State state_;
  bool keeps_steps_of_all_ = false;
  std::optional<Topology> topology_;                     ///< once it is asked for
  double n_parts_ = 0;                                   ///< likewise, if the options' is automatic
  std::optional<NonmanifoldCounts> nonmanifold_before_;  ///< of the input
  std::optional<KeptAreas> areas_;                       ///< of the input, once they are asked for
};

/// The mesh and the maps of a decimation, without its attributes; `result` is left to the caller.
Decimation geometry_of(const IndexedMesh& input, WorkingSurface left, const Frame& frame);

}  // namespace whittle
