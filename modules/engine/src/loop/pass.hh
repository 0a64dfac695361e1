#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "complex/restraints.hh"
#include "cost/pair_cost.hh"
#include "loop/contraction_loop.hh"
#include "whittle/engine/host.hh"

namespace whittle {

/// A surface to contract pairs of.
struct Surface {
  std::span<const Vec3> positions;
  Frame frame;  ///< takes `positions` to the frame; of no effect if they are in it
  std::span<const Triangle> faces;
};

/// What a pass begins with. Vertices are those of `surface`.
struct PassInput {
  Surface surface;
  std::span<const VertexPair> threshold_pairs;
  const FeatureLines* lines = nullptr;
  CostState cost_state;                  ///< of stages before; moved from
  double feature_tolerance = 0;          ///< in the frame
  std::span<const std::uint8_t> locked;  ///< per vertex, or empty
  std::span<const std::uint8_t> frozen;  ///< per vertex, or empty: those that take part in no contraction
  LoopContext context;                   ///< its refusals must outlive the pass
  DecimationHost* host = nullptr;
};

/// One run of the contraction loop over a surface, with all that it needs.
class Pass {
 public:
  /// \param options must outlive the pass
  Pass(PassInput& input, const DecimateOptions& options);

  /// Ranks all pairs. \param frame that the listener and the target's cost are told in
  void start(const DecimateTarget& target, const Frame& frame);
  /// Contracts. Once it has stopped at a cost it may go on. \pre start
  DecimateResult run() { return loop_->run(); }
  /// \param cost in the frame
  void set_cost_limit(double cost) { loop_->set_cost_limit(cost); }

  /// \pre start
  std::vector<GuardedPair> refusals() { return loop_->refusals(); }

  TriangleComplex& complex() { return complex_; }
  const TriangleComplex& complex() const { return complex_; }
  const PairCost& cost() const { return *cost_; }
  /// The feature lines that there are now. \param numbers vertices of the complex → vertices of the result
  FeatureLines feature_lines(const std::vector<Index>& numbers) { return restraints_.lines(complex_, numbers); }

 private:
  const DecimateOptions& options_;
  DecimationHost* host_;
  LoopContext context_;
  TriangleComplex complex_;
  Restraints restraints_;
  std::unique_ptr<PairCost> cost_;
  std::optional<ContractionLoop> loop_;
};

inline Triangle mapped(const Triangle& face, const std::vector<Index>& vertex_map) {
  return {vertex_map[face[0]], vertex_map[face[1]], vertex_map[face[2]]};
}

/// Where each vertex of the pass's surface went, as a vertex of the complex; `invalid_index` for those without a face.
std::vector<Index> representatives(TriangleComplex& complex);

/// Numbers of the surface's faces that are left, ascending. \param representatives as above
std::vector<Index> surviving_faces(std::span<const Triangle> faces, const std::vector<Index>& representatives,
                                   TriangleComplex& complex);

}  // namespace whittle
