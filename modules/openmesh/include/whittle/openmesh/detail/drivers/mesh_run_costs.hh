#pragma once

#include <algorithm>
#include <array>
#include <cfloat>
#include <limits>
#include <optional>
#include <utility>

#include "whittle/engine/decimate.hh"
#include "whittle/engine/host.hh"
#include "whittle/openmesh/pair_cost_module.hh"

// How the module that ranks takes part in a run of the mesh driver, a `MeshRunT`.

namespace whittle {

/// What the kinds of costs have in common.
template <class RunT>
class ModuleCostT : public HostedCost {
 public:
  explicit ModuleCostT(RunT& run) : run_(run) {}

  /// What the engine shall stop at.
  virtual DecimateTarget target() const { return run_.target_; }
  virtual Frame frame() const = 0;
  /// A position in the frame, not rounded to the scalar of the mesh.
  virtual Vec3 position_at_start(Index v) const = 0;
  /// Called before a contraction is made on the mesh.
  virtual void announce(const HostedContraction& /*made*/) const {}
  /// What that contraction costs in model units. \param told by the engine: what it ranked by
  virtual double cost_of(const Contraction& told) { return told.cost; }
  /// Corrects what the engine says of the costs of a run.
  virtual void complete(DecimateResult& /*result*/) const {}

 protected:
  static constexpr double never = std::numeric_limits<double>::infinity();

  OpenMesh::VertexHandle handle(Index v) const { return run_.input_.handle(v); }
  auto collapse(Index removed, Index survivor) const {
    return typename RunT::CollapseInfo(run_.mesh_, run_.halfedge(removed, survivor));
  }

  RunT& run_;
};

/// Our cost modules rank pairs in double, and place the merged vertex.
template <class RunT>
class PlacingCostT : public ModuleCostT<RunT> {
 public:
  explicit PlacingCostT(RunT& run) : ModuleCostT<RunT>(run), module_(*run.roles().cost) {}

  Frame frame() const override { return module_.frame(); }
  Vec3 position_at_start(Index v) const override { return module_.position(this->handle(v)); }

  PairEvaluation rank(Index first, Index second, PairConstraint constraint) override {
    return module_.evaluate(this->handle(first), this->handle(second), constraint);
  }
  CandidatePositions place(Index first, Index second, PairConstraint /*constraint*/,
                           const PairEvaluation& rank) override {
    return place_at(first, second, rank, invalid_index);
  }
  double final_cost(const HostedContraction& contraction) override { return final_cost(contraction, contraction.rank); }
  Reach reach() const override { return module_.reach(); }
  double dimension() const override { return module_.cost_dimension(); }
  bool stays_at_vertices() const override {
    const std::optional<CostOptions> options = module_.engine_options();
    return options && cost_traits(options->cost).has_quadrics && options->quadric.placement == Placement::endpoint;
  }
  void announce(const HostedContraction& made) const override { announce(made, made.rank); }

 protected:
  /// The second choice is the position of least cost.
  CandidatePositions place_at(Index first, Index second, const PairEvaluation& evaluation, Index survivor) const {
    CandidatePositions candidates;
    const Vec3 best = module_.place(this->handle(first), this->handle(second), evaluation);
    if (best != evaluation.position) candidates.add(best, survivor);
    candidates.add(evaluation.position, survivor);
    return candidates;
  }
  /// A cost that is infinite, negative or not a number refuses the pair.
  double final_cost(const HostedContraction& contraction, const PairEvaluation& evaluation) const {
    const double cost = module_.final_cost(this->handle(contraction.first), this->handle(contraction.second),
                                           evaluation, contraction.position);
    if (is_cost(evaluation.cost) && is_cost(cost)) return cost;
    this->run_.count_refusal_by_cost();
    return this->never;
  }
  void announce(const HostedContraction& made, const PairEvaluation& evaluation) const {
    module_.place_next(evaluation, made.position, this->handle(made.first));
  }

  PairCostModuleT<typename RunT::Mesh>& module_;
};

/// A `collapse_priority` that overrides ours is asked about both directions of a pair, and says which are allowed and
/// how they rank. Where it returns what ours returns, the pair ranks by its cost in double, as if nothing was
/// overridden. The place of the merged vertex and the limits of the cost are the module's in any case.
template <class RunT>
class PriorityCostT final : public PlacingCostT<RunT> {
 public:
  explicit PriorityCostT(RunT& run) : Placing(run) {
    if (const auto limit = run.target_.cost_limit()) {
      limit_ = this->module_.frame().cost_to_frame(*limit, this->module_.cost_dimension());
    }
  }

  /// Without a limit of the cost: what the engine knows as costs may be other values.
  DecimateTarget target() const override {
    const DecimateTarget& whole = this->run_.target_;
    DecimateTarget target = DecimateTarget::as_far_as_possible();
    if (const auto n = whole.n_faces()) target = target.or_faces(*n);
    if (const auto n = whole.n_vertices()) target = target.or_vertices(*n);
    return target;
  }

  PairEvaluation rank(Index first, Index second, PairConstraint constraint) override {
    const Choice choice = choose(first, second, constraint);
    return {choice.rank, choice.rank, choice.evaluation.position, choice.evaluation.is_minimum};
  }
  CandidatePositions place(Index first, Index second, PairConstraint constraint,
                           const PairEvaluation& /*rank*/) override {
    choice_ = choose(first, second, constraint);
    if (!(choice_.rank < this->never)) return {};
    return this->place_at(first, second, choice_.evaluation, choice_.survivor);
  }
  double final_cost(const HostedContraction& contraction) override {
    cost_ = Placing::final_cost(contraction, choice_.evaluation);
    if (limit_ && cost_ > *limit_) {
      if (cost_ < this->never) is_limited_ = true;
      return this->never;
    }
    return cost_ < this->never && !choice_.is_by_cost ? choice_.rank : cost_;
  }
  /// Modules may look at anything around.
  Reach reach() const override { return Reach::opposite_rings; }
  /// Directions decide who survives.
  bool stays_at_vertices() const override { return false; }
  void announce(const HostedContraction& made) const override { Placing::announce(made, choice_.evaluation); }
  double cost_of(const Contraction& /*told*/) override {
    const double cost = this->module_.frame().cost_to_model(cost_, this->module_.cost_dimension());
    max_cost_ = std::max(max_cost_, cost);
    return cost;
  }
  void complete(DecimateResult& result) const override {
    result.max_cost = max_cost_;
    if (result.stop == StopReason::exhausted && is_limited_) result.stop = StopReason::cost;
  }

 private:
  using Placing = PlacingCostT<RunT>;
  struct Choice {
    double rank = Placing::never;
    bool is_by_cost = false;         ///< whether that is what the pair costs
    Index survivor = invalid_index;  ///< if it matters
    PairEvaluation evaluation{};
  };

  Choice choose(Index first, Index second, PairConstraint constraint) const {
    const bool is_at_ends = Placing::stays_at_vertices();
    const PairEvaluation best = this->module_.evaluate(this->handle(first), this->handle(second), constraint);
    const auto into = [&](Index survivor) -> Choice {
      const bool is_first = survivor == first;
      if (constraint == (is_first ? PairConstraint::second : PairConstraint::first)) return {};
      const PairEvaluation evaluation =
          is_at_ends ? this->module_.evaluate(this->handle(first), this->handle(second),
                                              is_first ? PairConstraint::first : PairConstraint::second)
                     : best;
      return choose_direction(is_first ? second : first, survivor, evaluation);
    };
    Choice into_first = into(first);
    Choice into_second = into(second);
    if (into_first.rank == into_second.rank && !is_at_ends) into_first.survivor = invalid_index;
    return into_first.rank <= into_second.rank ? into_first : into_second;
  }

  Choice choose_direction(Index removed, Index survivor, const PairEvaluation& evaluation) const {
    this->module_.take_own_priority();
    const float priority = this->run_.roles().cost_module->collapse_priority(this->collapse(removed, survivor));
    if (this->module_.take_own_priority() == priority) return {evaluation.cost, true, survivor, evaluation};
    if (priority >= 0 && priority < FLT_MAX) {  // as DecimaterT has it
      return {cost_of_priority(priority, this->module_.cost_dimension()), false, survivor, evaluation};
    }
    this->run_.count_refusal_by_cost();
    return {};
  }

  std::optional<double> limit_;  ///< of the cost, in the frame
  bool is_limited_ = false;      ///< whether it refused a pair
  double max_cost_ = 0;          ///< of the contractions, in model units
  // Of the pair whose turn it is.
  Choice choice_;
  double cost_ = 0;
};

/// A cost module of OpenMesh's ranks collapses. v1 keeps its position.
template <class RunT>
class ForeignCostT final : public ModuleCostT<RunT> {
 public:
  explicit ForeignCostT(RunT& run) : ModuleCostT<RunT>(run), frame_(Frame::of_points(run.input_.mesh.positions)) {}

  Frame frame() const override { return frame_; }
  Vec3 position_at_start(Index v) const override { return frame_.to_frame(this->run_.input_.mesh.positions[v]); }

  PairEvaluation rank(Index first, Index second, PairConstraint constraint) override {
    const Collapses collapses = legal_collapses(first, second, constraint);
    if (collapses.n == 0) return {this->never, this->never, this->run_.position(first), false};
    const auto& [priority, survivor] = collapses.legal[0];
    return {priority, priority, this->run_.position(survivor), false};
  }
  /// The second choice is the collapse in the other direction.
  CandidatePositions place(Index first, Index second, PairConstraint constraint,
                           const PairEvaluation& /*rank*/) override {
    CandidatePositions candidates;
    const Collapses collapses = legal_collapses(first, second, constraint);
    for (std::size_t i = 0; i < collapses.n; ++i) {
      const Index survivor = collapses.legal[i].survivor;
      candidates.add(this->run_.position(survivor), survivor);
    }
    return candidates;
  }
  double final_cost(const HostedContraction& contraction) override {
    const std::optional<Collapse> collapse = legal_collapse(contraction.removed, contraction.survivor);
    return collapse ? collapse->priority : contraction.rank.cost;
  }
  /// Such costs may look at whole stars.
  Reach reach() const override { return Reach::opposite_rings; }
  double dimension() const override { return 0; }

 private:
  struct Collapse {
    double priority;
    Index survivor;
  };
  struct Collapses {
    std::array<Collapse, 2> legal;  ///< the cheaper one first
    std::size_t n = 0;
  };

  Collapses legal_collapses(Index first, Index second, PairConstraint constraint) {
    Collapses result;
    const auto add = [&](Index removed, Index survivor) {
      if (const std::optional<Collapse> collapse = legal_collapse(removed, survivor))
        result.legal[result.n++] = *collapse;
    };
    const auto count_constrained = [this](Index removed) {
      RefusalCounts& refusals = this->run_.refusals_;
      ++(this->run_.is_fixed(this->handle(removed)) ? refusals[Refusal::locked] : refusals[Refusal::feature]);
    };
    constraint != PairConstraint::second ? add(second, first) : count_constrained(second);
    constraint != PairConstraint::first ? add(first, second) : count_constrained(first);
    if (result.n == 2 && result.legal[1].priority < result.legal[0].priority) {
      std::swap(result.legal[0], result.legal[1]);
    }
    return result;
  }

  /// OpenMesh's modules are written for collapses that its decimaters call legal: v1 keeps its position, and a border
  /// vertex stays on the border. So they are asked about legal collapses only.
  std::optional<Collapse> legal_collapse(Index removed, Index survivor) {
    const auto info = this->collapse(removed, survivor);
    if (this->run_.is_fixed(info.v0)) {
      ++this->run_.refusals_[Refusal::locked];
      return std::nullopt;
    }
    if (!this->run_.is_collapse_legal(info)) {
      ++this->run_.refusals_[Refusal::link];
      return std::nullopt;
    }
    const float priority = this->run_.roles().cost_module->collapse_priority(info);
    if (priority >= 0) return Collapse{priority, survivor};
    this->run_.count_refusal_by_cost();
    return std::nullopt;
  }

  Frame frame_;
};

}  // namespace whittle
