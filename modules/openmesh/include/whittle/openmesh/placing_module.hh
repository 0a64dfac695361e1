#pragma once

#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "whittle/engine/formula/valence_term.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/detail/attributes/vertex_properties.hh"
#include "whittle/openmesh/pair_cost_module.hh"

namespace whittle {

/// Base of our cost modules. It implements OpenMesh's interface by means of `PairCostModuleT`. It keeps positions in
/// double, limits the cost, and applies the penalty for valences.
///
/// Works in OpenMesh's `DecimaterT`, `McDecimaterT` and `MixedDecimaterT`, over meshes of floats or doubles:
/// - The merged vertex moves to v̄ before the collapse. Face normals and other modules' `postprocess_collapse` see it
///   there.
/// - v1 keeps its position if it is locked or a feature, or if v0 is a feature.
/// - An edge that is merged with a feature edge becomes one.
/// - The float priority is computed from the cost in the module's frame (a mesh of size 1). So small units don't make
///   it 0.
///
/// For exact costs and order use `PairDecimaterT`.
///
/// Nobody else may change the mesh between `initialize()` and the end of the decimation.
template <class MeshT>
class PlacingModuleT : public OpenMesh::Decimater::ModBaseT<MeshT>, public PairCostModuleT<MeshT> {
 public:
  using ModBase = OpenMesh::Decimater::ModBaseT<MeshT>;
  using CollapseInfo = typename ModBase::CollapseInfo;

  /// Collapses that cost more are refused. [0, inf], in the unit of the cost, model units. Default: no limit.
  /// \throw std::invalid_argument if negative or not a number
  void set_max_cost(double max_cost);
  void unset_max_cost() { max_cost_.reset(); }

  /// `set_max_cost` under its name in OpenMesh's `ModQuadricT`.
  void set_max_err(double max_err) { set_max_cost(max_err); }
  /// \throw std::invalid_argument if `is_binary`: our cost modules always rank
  void set_max_err(double max_err, bool is_binary) {
    require(!is_binary, "the module ranks, and can't be binary");
    set_max_cost(max_err);
  }
  void unset_max_err() { unset_max_cost(); }

  /// Weight W of a factor on the cost that penalises valences far from 6, or far from 4 on borders (valence_term.hh).
  /// Vertices then get about six edges. Inside the surface no vertex is left with three while any other contraction is
  /// allowed.
  /// [0, inf), default 0 = off. Takes effect at the next `initialize()`.
  /// \throw std::invalid_argument if negative or not finite
  void set_valence_weight(double weight);
  double valence_weight() const { return valence_weight_; }

  // OpenMesh's interface ----------------------------------------------------------------------------------------------

  /// \throw std::invalid_argument for a coordinate that is not finite
  void initialize() override;
  /// A derived class may override it, to refuse collapses (`ILLEGAL_COLLAPSE`) or to rank them by other values.
  /// `PairDecimaterT` then asks about both directions of a pair. Where the value is the one that this class returns, it
  /// goes by the cost in double.
  float collapse_priority(const CollapseInfo& collapse) override;
  void preprocess_collapse(const CollapseInfo& collapse) override;
  void postprocess_collapse(const CollapseInfo& collapse) override;

  void set_binary(bool) = delete;  // never binary, as it ranks

  // PairCostModuleT ---------------------------------------------------------------------------------------------------

  bool has_placement() const override { return true; }
  const Frame& frame() const override { return frame_; }
  /// As set, times the error tolerance factor of the decimater.
  std::optional<double> max_cost() const override;
  Reach reach() const override { return active_valence_weight_ > 0 ? Reach::opposite_rings : plain_reach(); }
  Vec3 position(OpenMesh::VertexHandle v) const override { return placed(v).position; }
  PlacedQuadric quadric(OpenMesh::VertexHandle v) const override { return placed(v); }
  bool has_new_options() const override { return has_new_options_; }
  PairEvaluation evaluate(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second,
                          PairConstraint constraint) const override;
  PairEvaluation evaluate(const CollapseInfo& collapse) const final;
  std::optional<float> take_own_priority() override { return std::exchange(own_priority_, std::nullopt); }
  void place_next(const PairEvaluation& evaluation, const Vec3& position, OpenMesh::VertexHandle first) override {
    pending_ = Pending{evaluation, position, first};
  }
  std::optional<CostOptions> engine_options() const override;
  void adopt(const std::vector<Index>& vertices, std::vector<PlacedQuadric> quadrics, bool were_collapses) override;

 protected:
  using VertexHandle = OpenMesh::VertexHandle;

  explicit PlacingModuleT(MeshT& mesh) : ModBase(mesh, false), mesh_(mesh), numbers_(mesh) {}

  // The cost without the penalty for valences.
  virtual PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, PairConstraint constraint) const = 0;
  virtual Reach plain_reach() const = 0;
  /// The engine's options for this cost. The engine driver uses them for our own modules only.
  virtual CostOptions plain_options() const { return {}; }
  /// The position and quadric of the merged vertex. Called before the collapse.
  virtual PlacedQuadric merge(VertexHandle, VertexHandle, const PairEvaluation&, const Vec3& position) {
    return {position, {}};
  }
  /// Adds the planes of the mesh to the quadrics of all vertices, which are zero before.
  virtual void add_planes() const {}

  const MeshT& surface() const { return mesh_; }
  /// Quadrics are computed at the first call: the engine driver doesn't need them.
  PlacedQuadric& placed(VertexHandle v) const {
    if (!has_quadrics_) make_quadrics();
    return quadrics_[numbers_[v]];
  }
  /// The next call of `placed` computes all quadrics again, from the mesh as it is.
  void forget_quadrics() { has_quadrics_ = false; }
  /// Setters of options that take effect in `initialize` call this.
  void note_new_options() { has_new_options_ = true; }
  /// An `initialize` that doesn't call the one of this class calls this.
  void forget_new_options() { has_new_options_ = false; }
  /// \throw std::invalid_argument with the module's and the option's name
  void require(bool condition, const std::string& what) const;

 private:
  struct Pending {
    PairEvaluation evaluation;
    Vec3 position;       ///< where the merged vertex goes
    VertexHandle first;  ///< the vertex that was `first` in the evaluation
  };

  Frame frame_of_mesh() const;
  void make_quadrics() const;
  void add_vertex(VertexHandle v) const;
  PairEvaluation evaluate_cheapest(const CollapseInfo& collapse) const;
  ValenceChange valence_change(VertexHandle first, VertexHandle second) const;

  MeshT& mesh_;
  std::optional<double> max_cost_;
  double valence_weight_ = 0;
  double active_valence_weight_ = 0;  ///< that of the last `initialize()`
  bool has_new_options_ = false;

  Frame frame_;
  // Computed on demand: the quadrics of the mesh at `initialize()`, updated with each collapse since.
  mutable bool has_quadrics_ = false;
  mutable std::vector<PlacedQuadric> quadrics_;
  mutable OpenMesh::VProp<Index> numbers_;  ///< index in `quadrics_`; garbage collection moves it along
  std::optional<float> own_priority_;
  std::optional<Pending> pending_;  ///< the collapse under way
  PlacedQuadric merged_;            ///< the merged vertex of that collapse
  std::optional<VertexProperties> attributes_;
};

}  // namespace whittle

#include "whittle/openmesh/placing_module_impl.hh"
