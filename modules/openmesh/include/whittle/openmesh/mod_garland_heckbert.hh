#pragma once

#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/pair_cost_module.hh"
#include "whittle/openmesh/stock_quadric.hh"

// Garland–Heckbert cost and placement as a module for OpenMesh's decimaters: the engine's term (quadric_term.hh), with
// the same numbers in every bit.
//
//   cost = E₀(v̄) + E₁(v̄);  unit: distance² · area, or distance² with uniform weights (no length, as ModQuadricT's
//   isn't).
//
// Rejects what costs more than `max_cost`, nothing else: add ModFlipGuardT beside it.
// \cite garland_1997_surface (sections 4 and 6)

namespace whittle {

enum class Arithmetic {
  local,  ///< Whittle's: centred, scaled, each quadric about its vertex, costs in double
  stock  ///< ModQuadricT's to the last bit, to be checked against; weights, placement and the other options don't count
};

/// In the stock `DecimaterT`, `McDecimaterT` and `MixedDecimaterT`, over meshes of floats or doubles, the merged vertex
/// moves to v̄ before other modules see the collapse done, and face normals are right. v1 keeps its place where it is
/// locked or a feature, or the edge is one. The float priority is the cost in the module's frame (a mesh of size 1),
/// so that small units don't make it 0. For exact costs and order there is `PairDecimaterT`.
///
/// Between `initialize()` and the end of decimating nobody else may change the mesh.
template <class MeshT>
class ModGarlandHeckbertT : public OpenMesh::Decimater::ModBaseT<MeshT>, public PairCostModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModGarlandHeckbertT, MeshT, GarlandHeckbert);

  explicit ModGarlandHeckbertT(MeshT& mesh);

  /// Used from the next `initialize()` on.
  /// \throw std::invalid_argument where regularization or boundary_weight is negative or not finite
  void set_options(const QuadricOptions& options);
  const QuadricOptions& options() const { return options_; }

  /// Used from the next `initialize()` on. Default local.
  void set_arithmetic(Arithmetic arithmetic) { arithmetic_ = arithmetic; }
  Arithmetic arithmetic() const { return arithmetic_; }

  /// Collapses that cost more are refused (with stock arithmetic those that cost as much, too). [0, inf], model units:
  /// distance² · area, or distance² with uniform weights. Default: none are.
  /// \throw std::invalid_argument if negative or not a number
  void set_max_cost(double max_cost);
  void unset_max_cost() { max_cost_.reset(); }

  // OpenMesh's interface ----------------------------------------------------------------------------------------------

  /// \throw std::invalid_argument for a coordinate that is not finite
  void initialize() override;
  float collapse_priority(const CollapseInfo& collapse) override;
  void preprocess_collapse(const CollapseInfo& collapse) override;
  void postprocess_collapse(const CollapseInfo& collapse) override;

  // PairCostModuleT ---------------------------------------------------------------------------------------------------

  bool has_placement() const override { return !stock_; }
  const Frame& frame() const override { return frame_; }
  double cost_dimension() const override { return active_.weights == Weights::uniform ? 2 : 4; }
  /// As set, times the error tolerance factor of the decimater.
  std::optional<double> max_cost() const override;
  Vec3 position(OpenMesh::VertexHandle v) const override { return placed(v).position; }
  PairEvaluation evaluate(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second, Pinned pinned) const override;
  PairEvaluation evaluate(const CollapseInfo& collapse) const override;
  void place_next(const PairEvaluation& evaluation) override { pending_ = evaluation; }
  std::optional<QuadricOptions> engine_options() const override;
  void adopt(const std::vector<Index>& vertices, std::vector<PlacedQuadric> quadrics) override;

 private:
  using VertexHandle = OpenMesh::VertexHandle;

  void set_binary(bool) {}  // it ranks: never binary

  /// Makes them when first asked for one: the engine can do without.
  PlacedQuadric& placed(VertexHandle v) const {
    if (!has_quadrics_) make_quadrics();
    return quadrics_[numbers_[v]];
  }
  Frame frame_of_mesh() const;
  void make_quadrics() const;
  void add_vertex(VertexHandle v) const;
  void add_face_planes() const;
  void add_border_planes() const;

  MeshT& mesh_;
  QuadricOptions options_;
  Arithmetic arithmetic_ = Arithmetic::local;
  std::optional<double> max_cost_;

  QuadricOptions active_;  ///< those of the last `initialize()`
  Frame frame_;
  // Lazy: the quadrics of the mesh as it was at `initialize()`, and of what has been merged since.
  mutable bool has_quadrics_ = false;
  mutable std::vector<PlacedQuadric> quadrics_;
  mutable OpenMesh::VProp<Index> numbers_;     ///< of vertices in `quadrics_`; goes along with garbage collection
  std::optional<PairEvaluation> pending_;      ///< of the collapse under way
  std::optional<StockQuadricT<MeshT>> stock_;  ///< with stock arithmetic, in place of all that
};

}  // namespace whittle

#include "whittle/openmesh/mod_garland_heckbert_impl.hh"
