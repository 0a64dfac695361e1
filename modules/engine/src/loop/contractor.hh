#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "complex/constraints.hh"
#include "cost/pair_cost.hh"
#include "loop/contraction_loop.hh"
#include "loop/stage_context.hh"
#include "loop/working_surface.hh"

namespace whittle {

/// Contracts pairs of a surface: the contraction loop, with all that it needs.
class Contractor {
 public:
  /// Takes positions, threshold pairs, cost state and refusals away from the surface.
  /// \param context its options must outlive the contractor
  Contractor(WorkingSurface& surface, const StageContext& context);

  /// Ranks all pairs.
  void start(const DecimateTarget& target);
  /// Contracts. Once it has stopped at a cost it may go on. \pre start
  DecimateResult run() { return loop_->run(); }
  /// \param cost in the frame
  void set_cost_limit(double cost) { loop_->set_cost_limit(cost); }

  /// \pre start
  std::vector<GuardedPair> refusals() { return loop_->refusals(); }
  /// Makes the surface, with which it began, what it is now. \param goes_on whether another stage is to go on from it
  void write_back(WorkingSurface& surface, bool goes_on);

  TriangleComplex& complex() { return complex_; }
  const TriangleComplex& complex() const { return complex_; }
  const PairCost& cost() const { return *cost_; }

 private:
  StageContext context_;
  TriangleComplex complex_;
  Constraints constraints_;
  std::unique_ptr<PairCost> cost_;
  std::vector<GuardedPair> refusals_before_;
  std::optional<ContractionLoop> loop_;
};

inline Triangle mapped(const Triangle& face, const std::vector<Index>& vertex_map) {
  return {vertex_map[face[0]], vertex_map[face[1]], vertex_map[face[2]]};
}

/// Numbers of the surface's faces that are left, ascending.
/// \param representatives where each vertex of the surface went, as a vertex of the complex
std::vector<Index> surviving_faces(std::span<const Triangle> faces, const std::vector<Index>& representatives,
                                   TriangleComplex& complex);

}  // namespace whittle
