#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Tools/Decimater/CollapseInfoT.hh>
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/memoryless_term.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/reach.hh"

namespace whittle {

/// The fields of `DecimateOptions` that say how contractions are ranked and placed.
struct CostOptions {
  Cost cost = Cost::quadric;
  QuadricOptions quadric{};
  double isotropy = 0;
  double valence_weight = 0;
};

/// Whether the cost can rank threshold pairs in exact order.
inline bool takes_threshold_pairs(const CostOptions& options) {
  const CostConflicts& why_not = cost_traits(options.cost).why_not;
  return why_not.threshold.empty() && why_not.threshold_in_exact_order.empty() && options.isotropy == 0 &&
         options.valence_weight == 0;
}

/// Whether it is a cost, and doesn't refuse the pair.
inline bool is_cost(double cost) { return cost >= 0 && std::isfinite(cost); }

/// The float by which OpenMesh's decimaters rank a cost in the frame. Costs in length⁵ or length⁶ would be 0 as floats
/// on a fine mesh, so it is their cube root. \param dimension the cost's unit is a length to this power
inline float priority_of_cost(double cost, double dimension) {
  const double priority = dimension > 4 ? std::cbrt(cost) : cost;
  return static_cast<float>(std::min(priority, 0.5 * double{FLT_MAX}));  // DecimaterT needs less than FLT_MAX
}
/// The cost that ranks like this float.
inline double cost_of_priority(float priority, double dimension) {
  const double p = priority;
  return dimension > 4 ? p * p * p : p;
}

/// Whether a type is exactly one of our cost modules, which the engine knows.
template <class ModuleT>
inline constexpr bool is_engine_cost = false;

/// The interface of our cost modules beside OpenMesh's: cost *and placement* of a pair, in double.
///
/// OpenMesh's decimaters don't tell modules about each other. `PairDecimaterT` looks for this interface when a module
/// is added. Our guards get it by `FaceGuardT::set_cost_module`. Positions are in the module's frame, costs in the unit
/// of the frame.
template <class MeshT>
class PairCostModuleT {
 public:
  virtual ~PairCostModuleT() = default;

  /// Whether the module places the merged vertex. If not, only OpenMesh's interface is to be used.
  virtual bool has_placement() const = 0;

  virtual const Frame& frame() const = 0;
  /// The power of a length that is the unit of costs: 4 for distance² · area, 2 for distance², say.
  virtual double cost_dimension() const = 0;
  /// Largest cost allowed, model units; empty = no limit.
  virtual std::optional<double> max_cost() const = 0;
  /// Which pairs a contraction may make cheaper.
  virtual Reach reach() const = 0;

  /// The position of a vertex, not rounded to the scalar of the mesh.
  virtual Vec3 position(OpenMesh::VertexHandle v) const = 0;
  /// The position and the quadric of a vertex.
  virtual PlacedQuadric quadric(OpenMesh::VertexHandle v) const = 0;
  /// The mean face area of the mesh at `initialize()`. Only memoryless costs have it.
  virtual MeanFaceArea face_area() const { return {}; }
  /// Whether options were set since `initialize()`, so that they have no effect yet.
  virtual bool has_new_options() const = 0;
  /// Cost and placement of merging two vertices that share an edge. A cost that is infinite, negative or not a number
  /// refuses the pair. \pre first < second
  virtual PairEvaluation evaluate(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second,
                                  PairConstraint constraint) const = 0;
  /// The same for a collapse in one of OpenMesh's decimaters, by the functions of this interface. v1 keeps its position
  /// if it is locked or a feature, or if v0 is a feature. The position is that of `place`, the cost that of
  /// `final_cost`.
  virtual PairEvaluation evaluate(const OpenMesh::Decimater::CollapseInfoT<MeshT>& collapse) const = 0;

  /// The best position of the merged vertex. If it is refused, the position of the evaluation is tried.
  virtual Vec3 place(OpenMesh::VertexHandle /*first*/, OpenMesh::VertexHandle /*second*/,
                     const PairEvaluation& evaluation) const {
    return evaluation.position;
  }
  /// What merging at `position` costs: the cost of the evaluation, or more. It may rise with any contraction, but falls
  /// only for pairs within `reach()`.
  virtual double final_cost(OpenMesh::VertexHandle /*first*/, OpenMesh::VertexHandle /*second*/,
                            const PairEvaluation& evaluation, const Vec3& /*position*/) const {
    return evaluation.cost;
  }
  /// What `collapse_priority` of the class itself has returned, which a derived class may have overridden; empty if it
  /// wasn't called since this was asked last. By it `PairDecimaterT` knows which values are the class's own.
  virtual std::optional<float> take_own_priority() { return std::nullopt; }

  /// The next collapse uses this evaluation and `position` instead of those of `evaluate(collapse)`.
  /// \param first the vertex that the evaluation took as first
  virtual void place_next(const PairEvaluation& evaluation, const Vec3& position, OpenMesh::VertexHandle first) = 0;

  /// Options with which the engine has the same costs; empty if it has no such cost.
  virtual std::optional<CostOptions> engine_options() const = 0;
  /// Takes over the result of a run of the engine. It replaces `preprocess_collapse` and `postprocess_collapse` of each
  /// collapse.
  /// \param vertices handle indices of the vertices left, without isolated ones
  /// \param quadrics of these vertices, in the module's frame
  /// \param were_collapses whether all contractions were legal collapses on the mesh
  virtual void adopt(const std::vector<Index>& vertices, std::vector<PlacedQuadric> quadrics, bool were_collapses) = 0;
};

}  // namespace whittle
