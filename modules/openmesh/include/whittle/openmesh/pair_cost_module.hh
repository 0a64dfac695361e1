#pragma once

#include <OpenMesh/Core/Mesh/Handles.hh>
#include <OpenMesh/Tools/Decimater/CollapseInfoT.hh>
#include <optional>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/memoryless_term.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/reach.hh"

namespace whittle {

/// What a contraction costs and where it goes, as the engine is told: these fields of `DecimateOptions`.
struct CostOptions {
  Cost cost = Cost::quadric;
  QuadricOptions quadric{};
  double isotropy = 0;
  double valence_weight = 0;
};

/// Whether threshold pairs go with the cost, in exact order.
inline bool takes_threshold_pairs(const CostOptions& options) {
  const CostConflicts& why_not = cost_traits(options.cost).why_not;
  return why_not.threshold.empty() && why_not.threshold_in_exact_order.empty() && options.isotropy == 0 &&
         options.valence_weight == 0;
}

/// Whether a type is exactly one of our cost modules, which the engine knows.
template <class ModuleT>
inline constexpr bool is_engine_cost = false;

/// What a cost module of ours knows beyond OpenMesh's interface: cost *and place* of a pair, in double.
///
/// A decimater can't be asked for the interfaces of its modules; `PairDecimaterT` looks for this one when a module is
/// added, and guards of ours are told. Positions are in the module's frame, costs in its unit.
template <class MeshT>
class PairCostModuleT {
 public:
  virtual ~PairCostModuleT() = default;

  /// Whether the module places the merged vertex. If not, it is to be used through OpenMesh's interface alone.
  virtual bool has_placement() const = 0;

  virtual const Frame& frame() const = 0;
  /// The power of a length that is the unit of costs: 4 for distance² · area, 2 for distance², say.
  virtual double cost_dimension() const = 0;
  /// Largest cost allowed, model units.
  virtual std::optional<double> max_cost() const = 0;
  /// Which pairs a contraction may make cheaper.
  virtual Reach reach() const = 0;

  /// Where a vertex is, before its coordinates were rounded to the scalar of the mesh.
  virtual Vec3 position(OpenMesh::VertexHandle v) const = 0;
  /// That, and what the module remembers at the vertex.
  virtual PlacedQuadric quadric(OpenMesh::VertexHandle v) const { return {position(v), {}}; }
  /// What memoryless costs know of the mesh as it was at first.
  virtual MeanFaceArea face_area() const { return {}; }
  /// Whether options were set since `initialize()`, so that they have no effect yet.
  virtual bool has_new_options() const { return false; }
  /// Cost and place of merging two vertices that share an edge. \pre first < second
  virtual PairEvaluation evaluate(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second, Pinned pinned) const = 0;
  /// The same for a collapse in one of OpenMesh's decimaters, where v1 stays in its place if it is locked or a feature;
  /// the position is the best there is, the cost that of going there.
  virtual PairEvaluation evaluate(const OpenMesh::Decimater::CollapseInfoT<MeshT>& collapse) const = 0;

  /// Where the merged vertex would best go; where that is refused, the place of the evaluation will do.
  virtual Vec3 place(OpenMesh::VertexHandle /*first*/, OpenMesh::VertexHandle /*second*/,
                     const PairEvaluation& evaluation) const {
    return evaluation.position;
  }
  /// What that costs at `position`: what it was evaluated to, or more. Falls only where the cost reaches, but may rise
  /// with any contraction.
  virtual double final_cost(OpenMesh::VertexHandle /*first*/, OpenMesh::VertexHandle /*second*/,
                            const PairEvaluation& evaluation, const Vec3& /*position*/) const {
    return evaluation.cost;
  }
  /// The next collapse has this evaluation and goes to `position`, and not where `evaluate(collapse)` says.
  /// \param first the vertex that the evaluation took as first
  virtual void place_next(const PairEvaluation& evaluation, const Vec3& position, OpenMesh::VertexHandle first) = 0;

  /// What the engine needs to contract by the same costs; nothing if it can't.
  virtual std::optional<CostOptions> engine_options() const = 0;
  /// The engine has contracted by them: instead of `preprocess_collapse` and `postprocess_collapse` for each collapse.
  /// \param vertices those left, but for isolated ones, as handle indices \param quadrics theirs, in the module's frame
  /// \param were_collapses whether the mesh could have made all these contractions itself
  virtual void adopt(const std::vector<Index>& vertices, std::vector<PlacedQuadric> quadrics, bool were_collapses) = 0;
};

}  // namespace whittle
