#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "complex/constraints.hh"
#include "complex/uncertain_vertices.hh"
#include "cost/pair_cost.hh"
#include "guard/guard.hh"
#include "loop/pairs_at_once.hh"
#include "loop/stage_context.hh"
#include "loop/working_surface.hh"
#include "pairs/threshold_pair_filter.hh"
#include "queue/pair_queue.hh"
#include "queue/refused_pairs.hh"
#include "whittle/engine/decimate.hh"

namespace whittle {

/// Contracts pairs in order of cost until a target is reached:
///
///   while no target is reached:
///     take the next pair from the queue, and gather its profile
///     if the order is exact, in a block that doesn't know all around the pair: leave it to a later stage
///     if a guard refuses the pair: count that; the pair waits until something that the guard looks at changes
///     the cost places the merged vertex; if a guard refuses that, the one where the pair was ranked is tried
///     if the final cost is above the rank: queue the pair again
///     else contract, and tell the change to cost, constraints, queue, waiting pairs and listener
///     if no pair is left: queue those again that were refused by guards that give way
///
/// With a bound of the error several pairs are taken at a time, far enough from each other, and error guards look at
/// them at once.
class ContractionLoop {
 public:
  /// \param refusals of stages before, that still hold
  ContractionLoop(TriangleComplex& complex, Constraints& constraints, PairCost& cost, const DecimateTarget& target,
                  std::span<const GuardedPair> refusals, const StageContext& context);

  /// Goes on from where it stopped, if it did. \return all that was done so far
  DecimateResult run();
  /// Replaces the target's. \param cost in the frame
  void set_cost_limit(double cost) { cost_limit_ = cost; }
  /// The refusals that hold now.
  std::vector<GuardedPair> refusals();

 private:
  void begin_with(std::span<const GuardedPair> refusals);
  bool target_reached() const;
  bool report_progress() const;
  IndexedMesh surface_now() const;
  bool take_next();
  void take(const RankedPair& ranked);
  bool take_several();
  void finish(PairsAtOnce::Entry& entry);
  void refuse_for_error(const Pair& pair);
  bool gather(const RankedPair& ranked);
  bool gather_if_certain(const Pair& pair);
  void leave_to_later(const Pair& pair);
  void list_affected(Index v);
  bool stop_at_cost(const Pair& pair, double cost);
  bool find_places(const RankedPair& ranked, std::size_t most);
  void find_nearer_places(PairsAtOnce::Entry& entry);
  bool may_place_anywhere(const Pair& pair) const;
  double cost_at(const Vec3& position, const PairEvaluation& rank) const;
  std::optional<double> settle_cost(const RankedPair& ranked, const Vec3& position);
  std::optional<std::size_t> find_refusal();
  std::optional<std::size_t> find_refusal_at(const Vec3& position);
  bool is_refused(const Pair& pair) const;
  void refuse(std::size_t guard);
  bool ask_guards_to_give_way();
  void note_refusal(const Pair& pair, std::size_t guard);
  template <class Use>
  void for_each_refused(const Use& use) const;
  RefusalCounts count_refused_pairs() const;
  bool is_told() const { return host_ != nullptr || options_.listener != nullptr || log_ != nullptr; }
  void tell_others(const HostedContraction& made, double cost);
  void contract(const RankedPair& ranked, const Vec3& position, double cost);
  void list_touched();
  void wake_around();
  void wake(Index v) {
    if (refused_.any_at(v)) wake_pairs_at(v);
  }
  void wake_pairs_at(Index v);
  void reveal_at(Index v);

  TriangleComplex& complex_;
  Constraints& constraints_;
  Placer& placer_;
  const DecimateOptions& options_;
  DecimateTarget target_;
  std::optional<double> cost_limit_;  ///< that of the target, in the frame
  Frame frame_;
  double cost_dimension_;
  Frame::CostUnit cost_unit_;  ///< of the model
  DecimationHost* host_;
  ContractionLog* log_;
  std::uint64_t n_initial_vertices_;
  std::uint64_t n_initial_faces_;

  ThresholdPairFilter filter_;
  Guards guards_;
  PairsAtOnce at_once_;
  std::vector<Guard*> followers_;               ///< the guards that are told of each contraction
  int n_rings_ = 1;                             ///< how far the guards look
  std::optional<UncertainVertices> uncertain_;  ///< of a block in exact order
  PairRanks ranks_;
  std::unique_ptr<PairQueue> queue_;
  Reach touched_;  ///< which vertices `Change::touched` lists
  RefusedPairs refused_;
  std::vector<Index> woken_;     ///< scratch
  std::vector<Index> affected_;  ///< scratch
  std::vector<Pair> put_off_;    ///< scratch

  ContractionProfile profile_;
  std::vector<MergedPlace> places_;  ///< of its merged vertex, that no guard refuses
  Change change_;
  std::optional<HostedContraction> told_;  ///< scratch
  std::optional<StopReason> stop_;
  DecimateResult result_;
};

}  // namespace whittle
