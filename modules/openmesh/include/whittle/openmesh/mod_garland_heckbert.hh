#pragma once

#include <optional>

#include "whittle/openmesh/detail/quadric_module.hh"
#include "whittle/openmesh/detail/stock_quadric.hh"

// Garland–Heckbert cost and placement as a module for OpenMesh's decimaters. It computes the engine's term
// (quadric_term.hh), bit for bit.
//
//   cost = E₀(v̄) + E₁(v̄)
//   with isotropy W: cost^(1−W) (L²)^W, L the length of the edge (edge_length_term.hh)
//   with a valence weight: times a penalty (valence_term.hh)
//
// The unit is distance² · area, or distance² with uniform weights. It is no length, nor is ModQuadricT's. Isotropy
// blends the unit in the same way as the cost.
//
// The module refuses only collapses that cost more than `max_cost`. Add ModFlipGuardT beside it.
// \cite garland_1997_surface (sections 4 and 6)

namespace whittle {

enum class Arithmetic {
  local,  ///< Whittle's: centred, scaled, each quadric about its vertex, costs in double
  stock   ///< ModQuadricT's to the last bit, for comparisons; ignores all other options but `max_cost`
};

/// `PlacingModuleT` says what the module does in which decimater, and has the options that all our cost modules share.
template <class MeshT>
class ModGarlandHeckbertT : public QuadricModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModGarlandHeckbertT, MeshT, GarlandHeckbert);

  explicit ModGarlandHeckbertT(MeshT& mesh) : QuadricModuleT<MeshT>(mesh) {}

  /// W of the blend with the length of the edge. At 0 the quadric alone gives cost and placement. At 1 the order is by
  /// length, and v̄ is the middle of the edge. In between, triangles are more even the higher W is.
  /// [0, 1], default 0. Takes effect at the next `initialize()`.
  /// \throw std::invalid_argument outside this range
  void set_isotropy(double isotropy);
  double isotropy() const { return isotropy_; }

  /// Default local. Takes effect at the next `initialize()`.
  void set_arithmetic(Arithmetic arithmetic) {
    arithmetic_ = arithmetic;
    this->note_new_options();
  }
  Arithmetic arithmetic() const { return arithmetic_; }

  // The unit of `set_max_cost` is distance² · area, or distance² with uniform weights: a length to the power p = 4 or
  // 2. With isotropy W the power is (1−W) p + 2 W. With stock arithmetic a collapse that costs exactly `max_cost` is
  // refused, too.

  /// \throw std::invalid_argument for a coordinate that is not finite
  void initialize() override;
  float collapse_priority(const CollapseInfo& collapse) override;
  void preprocess_collapse(const CollapseInfo& collapse) override;
  void postprocess_collapse(const CollapseInfo& collapse) override;

  bool has_placement() const override { return !stock_; }
  double cost_dimension() const override;
  std::optional<CostOptions> engine_options() const override;

 private:
  using QuadricModule = QuadricModuleT<MeshT>;
  using QuadricModule::active;
  using QuadricModule::placed;
  using typename QuadricModule::VertexHandle;

  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, PairConstraint constraint) const override;
  Reach plain_reach() const override { return active_isotropy_ > 0 ? Reach::ends : Reach::none; }
  CostOptions plain_options() const override { return {Cost::quadric, active(), active_isotropy_, 0}; }

  double isotropy_ = 0;
  Arithmetic arithmetic_ = Arithmetic::local;

  double active_isotropy_ = 0;                 ///< that of the last `initialize()`
  std::optional<StockQuadricT<MeshT>> stock_;  ///< set with stock arithmetic; then nothing else is used
};

template <class MeshT>
inline constexpr bool is_engine_cost<ModGarlandHeckbertT<MeshT>> = true;

}  // namespace whittle

#include "whittle/openmesh/mod_garland_heckbert_impl.hh"
