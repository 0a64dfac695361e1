#pragma once

#include "whittle/engine/formula/quadric_term.hh"
#include "whittle/openmesh/placing_module.hh"

namespace whittle {

/// Base of our cost modules with quadrics: their options, the planes of the mesh, costs and sums.
template <class MeshT>
class QuadricModuleT : public PlacingModuleT<MeshT> {
 public:
  /// Takes effect at the next `initialize()`.
  /// \throw std::invalid_argument if regularization or boundary_weight is negative or not finite
  void set_options(const QuadricOptions& options);
  const QuadricOptions& options() const { return options_; }

  void initialize() override {
    use_options();
    PlacingModuleT<MeshT>::initialize();
  }
  double cost_dimension() const override { return active_.weights == Weights::uniform ? 2 : 4; }

 protected:
  using PlacingModuleT<MeshT>::placed;
  using PlacingModuleT<MeshT>::surface;
  using typename PlacingModuleT<MeshT>::VertexHandle;

  explicit QuadricModuleT(MeshT& mesh) : PlacingModuleT<MeshT>(mesh) {}

  /// Those of the last `initialize()`.
  const QuadricOptions& active() const { return active_; }
  void use_options() { active_ = options_; }

  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, PairConstraint constraint) const override;
  PlacedQuadric merge(VertexHandle first, VertexHandle second, const PairEvaluation& evaluation,
                      const Vec3& position) override;

 private:
  void add_planes() const override;
  void add_face_planes() const;
  void add_border_planes() const;

  QuadricOptions options_;
  QuadricOptions active_;
};

}  // namespace whittle

#include "whittle/openmesh/detail/quadric_module_impl.hh"
