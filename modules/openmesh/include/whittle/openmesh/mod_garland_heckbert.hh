#pragma once

#include <optional>

#include "whittle/openmesh/detail/stock_quadric.hh"
#include "whittle/openmesh/quadric_module.hh"

// Garland–Heckbert cost and placement as a module for OpenMesh's decimaters: the engine's term (quadric_term.hh), with
// the same numbers in every bit.
//
//   cost = E₀(v̄) + E₁(v̄);  unit: distance² · area, or distance² with uniform weights (no length, as ModQuadricT's
//   isn't).
//   With isotropy W:  cost^(1−W) (L²)^W, L the length of the edge (edge_length_term.hh); in its unit, too.
//   With a valence weight: times a penalty (valence_term.hh).
//
// Rejects what costs more than `max_cost`, nothing else: add ModFlipGuardT beside it.
// \cite garland_1997_surface (sections 4 and 6)

namespace whittle {

enum class Arithmetic {
  local,  ///< Whittle's: centred, scaled, each quadric about its vertex, costs in double
  stock  ///< ModQuadricT's to the last bit, to be checked against; weights, placement and the other options don't count
};

/// What it does in which decimater, and the options it shares with our other cost modules: `PlacingModuleT`.
template <class MeshT>
class ModGarlandHeckbertT : public QuadricModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModGarlandHeckbertT, MeshT, GarlandHeckbert);

  explicit ModGarlandHeckbertT(MeshT& mesh) : QuadricModuleT<MeshT>(mesh) {}

  /// W of the blend with the length of the edge: at 0 the quadric's cost and placement alone, at 1 the order is by
  /// length and v̄ the middle; between, triangles get more even the higher it is. [0, 1], default 0. Used from the next
  /// `initialize()` on.
  /// \throw std::invalid_argument outside
  void set_isotropy(double isotropy);
  double isotropy() const { return isotropy_; }

  /// Used from the next `initialize()` on. Default local.
  void set_arithmetic(Arithmetic arithmetic) {
    arithmetic_ = arithmetic;
    this->note_new_options();
  }
  Arithmetic arithmetic() const { return arithmetic_; }

  // `set_max_cost`: distance² · area, or distance² with uniform weights; with isotropy, (1−W) times that power of a
  // length and W times its square. With stock arithmetic what costs as much is refused, too.

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

  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, Pinned pinned) const override;
  Reach plain_reach() const override { return active_isotropy_ > 0 ? Reach::ends : Reach::none; }
  CostOptions plain_options() const override { return {Cost::quadric, active(), active_isotropy_, 0}; }

  double isotropy_ = 0;
  Arithmetic arithmetic_ = Arithmetic::local;

  double active_isotropy_ = 0;                 ///< that of the last `initialize()`
  std::optional<StockQuadricT<MeshT>> stock_;  ///< with stock arithmetic, in place of all that
};

template <class MeshT>
inline constexpr bool is_engine_cost<ModGarlandHeckbertT<MeshT>> = true;

}  // namespace whittle

#include "whittle/openmesh/mod_garland_heckbert_impl.hh"
