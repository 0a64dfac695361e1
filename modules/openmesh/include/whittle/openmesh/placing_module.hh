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

#include "whittle/engine/formula/valence_term.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/pair_cost_module.hh"

namespace whittle {

/// What our cost modules have in common: OpenMesh's interface, in the words of `PairCostModuleT`; where vertices are,
/// in double; the limit of the cost; and the penalty for valences.
///
/// In the stock `DecimaterT`, `McDecimaterT` and `MixedDecimaterT`, over meshes of floats or doubles, the merged vertex
/// moves to v̄ before other modules see the collapse done, and face normals are right. v1 keeps its place where it is
/// locked or a feature, or v0 is a feature. An edge that is merged with a feature edge becomes one. The float priority
/// is taken from the cost in the module's frame (a mesh of size 1), so that small units don't make it 0. For exact
/// costs and order there is `PairDecimaterT`.
///
/// Between `initialize()` and the end of decimating nobody else may change the mesh.
template <class MeshT>
class PlacingModuleT : public OpenMesh::Decimater::ModBaseT<MeshT>, public PairCostModuleT<MeshT> {
 public:
  using ModBase = OpenMesh::Decimater::ModBaseT<MeshT>;
  using CollapseInfo = typename ModBase::CollapseInfo;

  /// Collapses that cost more are refused. [0, inf], model units, as the module has them. Default: none are.
  /// \throw std::invalid_argument if negative or not a number
  void set_max_cost(double max_cost);
  void unset_max_cost() { max_cost_.reset(); }

  /// The same under the names of OpenMesh's `ModQuadricT`.
  void set_max_err(double max_err) { set_max_cost(max_err); }
  /// \throw std::invalid_argument for a binary one: our cost modules always rank
  void set_max_err(double max_err, bool is_binary) {
    require(!is_binary, "the module ranks, and can't be binary");
    set_max_cost(max_err);
  }
  void unset_max_err() { unset_max_cost(); }

  /// W of a penalty for valences far from 6, on borders from 4, times the cost (valence_term.hh): vertices get about
  /// six edges, and inside the surface none is left with three as long as any other contraction is allowed.
  /// [0, inf), default 0 = off. Used from the next `initialize()` on.
  /// \throw std::invalid_argument if negative or not finite
  void set_valence_weight(double weight);
  double valence_weight() const { return valence_weight_; }

  // OpenMesh's interface ----------------------------------------------------------------------------------------------

  /// \throw std::invalid_argument for a coordinate that is not finite
  void initialize() override;
  float collapse_priority(const CollapseInfo& collapse) override;
  void preprocess_collapse(const CollapseInfo& collapse) override;
  void postprocess_collapse(const CollapseInfo& collapse) override;

  // PairCostModuleT ---------------------------------------------------------------------------------------------------

  bool has_placement() const override { return true; }
  const Frame& frame() const override { return frame_; }
  /// As set, times the error tolerance factor of the decimater.
  std::optional<double> max_cost() const override;
  Reach reach() const override { return active_valence_weight_ > 0 ? Reach::opposite_rings : plain_reach(); }
  Vec3 position(OpenMesh::VertexHandle v) const override { return placed(v).position; }
  PlacedQuadric quadric(OpenMesh::VertexHandle v) const override { return placed(v); }
  bool has_new_options() const override { return has_new_options_; }
  PairEvaluation evaluate(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second, Pinned pinned) const override;
  PairEvaluation evaluate(const CollapseInfo& collapse) const override;
  void place_next(const PairEvaluation& evaluation, const Vec3& position, OpenMesh::VertexHandle first) override {
    pending_ = Pending{evaluation, position, first};
  }
  std::optional<CostOptions> engine_options() const override;
  void adopt(const std::vector<Index>& vertices, std::vector<PlacedQuadric> quadrics, bool were_collapses) override;

 protected:
  using VertexHandle = OpenMesh::VertexHandle;

  explicit PlacingModuleT(MeshT& mesh) : ModBase(mesh, false), mesh_(mesh), numbers_(mesh) {}

  // The cost, but for valences.
  virtual PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, Pinned pinned) const = 0;
  virtual Reach plain_reach() const = 0;
  /// As the engine knows the cost; only asked of our own modules.
  virtual CostOptions plain_options() const { return {}; }
  /// What the merged vertex is to keep at `position`. Called while the mesh is as it was.
  virtual PlacedQuadric merge(VertexHandle, VertexHandle, const PairEvaluation&, const Vec3& position) {
    return {position, {}};
  }
  /// Adds to the quadrics of all vertices, which are zero so far.
  virtual void add_planes() const {}

  const MeshT& surface() const { return mesh_; }
  /// Makes them when first asked for one: the engine can do without.
  PlacedQuadric& placed(VertexHandle v) const {
    if (!has_quadrics_) make_quadrics();
    return quadrics_[numbers_[v]];
  }
  /// The next to ask for quadrics gets those of the mesh as it is.
  void forget_quadrics() { has_quadrics_ = false; }
  /// To be called by setters of options that `initialize` takes over.
  void note_new_options() { has_new_options_ = true; }
  /// To be called by an `initialize` that does without this class's.
  void forget_new_options() { has_new_options_ = false; }
  /// \throw std::invalid_argument with the module's and the option's name
  void require(bool condition, const std::string& what) const;

 private:
  struct Pending {
    PairEvaluation evaluation;
    Vec3 position;       ///< where the merged vertex goes
    VertexHandle first;  ///< the one of the pair that the evaluation took as first
  };
  void set_binary(bool) {}  // it ranks: never binary

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
  // Lazy: the quadrics of the mesh as it was at `initialize()`, and of what has been merged since.
  mutable bool has_quadrics_ = false;
  mutable std::vector<PlacedQuadric> quadrics_;
  mutable OpenMesh::VProp<Index> numbers_;  ///< of vertices in `quadrics_`; goes along with garbage collection
  std::optional<Pending> pending_;          ///< the collapse under way
  PlacedQuadric merged_;                    ///< what it leaves
};

}  // namespace whittle

#include "whittle/openmesh/placing_module_impl.hh"
