#pragma once

#include <algorithm>  // before OpenMesh's headers, which use std::find without it

#include <OpenMesh/Tools/Decimater/BaseDecimaterT.hh>
#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/openmesh/detail/attached_module.hh"
#include "whittle/openmesh/detail/feature_bits.hh"
#include "whittle/openmesh/mod_flip_guard.hh"
#include "whittle/openmesh/mod_radius_ratio.hh"
#include "whittle/openmesh/pair_cost_module.hh"

// A decimater over pairs for OpenMesh meshes: exact order, placement, and the same contractions with both drivers.
//
//   both drivers:  the engine's loop on a copy of the geometry (pseudo-code: contraction_loop.hh)
//   mesh driver:   modules rank, place and refuse; each contraction is made on the mesh at once
//   engine driver: the engine's own costs and guards; all contractions are made on the mesh at the end
//
// With a pair threshold, close vertices that no edge joins are pairs, too. Where half-edges can't hold the result, it
// is cut into copies of vertices (vertex_copies.hh).

namespace whittle {

/// What makes the contractions in `PairDecimaterT`.
enum class Driver {
  automatic,  ///< the engine driver where it can run, else the mesh driver
  engine,     ///< many times faster; takes only our cost modules, `ModFlipGuardT`, `ModRadiusRatioT` and
              ///< `ModMaxErrorT`, and no types derived from them
  mesh        ///< takes any modules, and calls what derived ones override, their `collapse_priority` too
};

/// A bool, and nothing that converts to one: the 0.8 in `decimate_to_faces(0, 500, 0.8F)` is a share of the collapses
/// in OpenMesh's `MixedDecimaterT`.
class ExactlyBool {
 public:
  template <std::same_as<bool> Bool>
  ExactlyBool(Bool value) : value_(value) {}
  operator bool() const { return value_; }

 private:
  bool value_;
};

/// How often a module refused a contraction.
struct ModuleRefusals {
  std::string module;  ///< its name
  std::uint64_t count = 0;
};

template <class MeshT>
class EngineRunT;
template <class MeshT>
class MeshRunT;

/// Has the calls of OpenMesh's `DecimaterT` and takes the same modules. The main differences
/// (docs/dev/openmesh.md and docs/user/from-openmesh.md have more):
///   - The cost module is one of ours (`ModGarlandHeckbertT`, `ModMemorylessT`, `ModLindstromTurkT`, `ModMidpointT`) or
///     any non-binary module of OpenMesh's. With the latter v1 keeps its position, both directions of an edge are
///     candidates, and OpenMesh's own legality rules hold.
///   - A flip guard over both stars is always on. Its angle is the default of the cost (`CostTraits`: 75°, with
///     `ModMemorylessT` 60°, with `ModLindstromTurkT` 110°), or that of a `ModFlipGuardT`. A class derived from that
///     takes its place. Other binary modules get v̄ as `p1`. If v1 moves, they are asked about both stars.
///   - A `collapse_priority` that overrides ours is asked about both directions of a pair. `ILLEGAL_COLLAPSE` refuses a
///     direction, another value ranks. The vertex goes where the module places it, and limits of the cost hold.
///   - Of a pair with one locked vertex the other one vanishes. With `only_selected`, vertices that aren't selected
///     count as locked.
///   - A vertex with two feature edges moves along them only, from vertex to vertex. A vertex with one, three or more
///     stays, and so does one with the feature bit and no feature edge. Lines keep their loops and stay near to where
///     they were.
///   - Counts leave out deleted elements and vertices without a face. Copies of a vertex count as one.
///   - The engine driver takes copies of a vertex (`vertex_copies.hh`) at one position as one vertex. The mesh driver
///     can't move them together, so it neither moves nor removes them.
///
/// As in the stock decimater, surviving handles and their properties persist. Removed elements are marked deleted until
/// `garbage_collection()`. *The engine driver writes to the mesh only at the end (or when aborted):* until then an
/// observer or listener sees the mesh as it was. If threshold pairs were contracted or vertices have copies, the engine
/// driver may add copies at the end: `FaceRelinker` says what persists.
template <class MeshT>
class PairDecimaterT : public OpenMesh::Decimater::BaseDecimaterT<MeshT> {
 public:
  using Base = OpenMesh::Decimater::BaseDecimaterT<MeshT>;
  using Mesh = MeshT;
  using Module = OpenMesh::Decimater::ModBaseT<MeshT>;
  using CollapseInfo = OpenMesh::Decimater::CollapseInfoT<MeshT>;

  /// \param mesh must outlive the decimater
  explicit PairDecimaterT(MeshT& mesh) : Base(mesh), mesh_(mesh) {}

  /// As the base's. `initialize` throws if modules were added through a reference to the base.
  template <class ModuleT>
  bool add(OpenMesh::Decimater::ModHandleT<ModuleT>& handle);
  template <class ModuleT>
  bool remove(OpenMesh::Decimater::ModHandleT<ModuleT>& handle);

  /// Initializes every module for the mesh as it is. A second call starts anew. Call it after adding modules, setting
  /// their options, or changing the mesh. Don't call it between calls of `decimate`: the next one goes on where the
  /// last one ended.
  /// \return false unless exactly one module ranks (isn't binary)
  /// \throw std::logic_error if modules were added through a reference to the base: their types are unknown then
  bool initialize();

  /// Default automatic.
  void set_driver(Driver driver) { driver_ = driver; }
  Driver driver() const { return driver_; }
  /// Why the engine driver can't run now; empty if it can.
  std::string engine_obstacle() const;
  /// The driver that ran last: engine or mesh.
  Driver last_driver() const { return last_driver_; }

  /// Two vertices closer than this are a pair even if no edge joins them. So parts that lie side by side can become
  /// one. Model units, [0, inf]; empty (default) = no such pairs. These are the valid pairs of Garland & Heckbert.
  /// \cite garland_1997_surface
  ///
  /// Afterwards the mesh may have copies of vertices (`vertex_copies.hh`). `geometry_of(mesh)` joins them: it gives the
  /// indexed mesh that the engine made. The next `initialize()` and `decimate` go on from that.
  /// Only the engine driver contracts such pairs. `decimate` throws with foreign modules, with `Driver::mesh`, with
  /// other costs than the quadric's, with isotropy and with a valence weight. Locked vertices and `only_selected` have
  /// the same effect as for edges.
  /// \throw std::invalid_argument if negative or not a number
  void set_pair_threshold(std::optional<double> threshold);
  std::optional<double> pair_threshold() const { return pairs_.threshold; }
  /// Sets the threshold together with the other options of such pairs. \throw as above
  void set_pair_options(const PairOptions& options);
  const PairOptions& pair_options() const { return pairs_; }

  /// How far a feature line may move from where it was when `decimate` was called, as a share of the diagonal of the
  /// mesh's bounding box. [0, inf]; default 5e-4, that of the engine.
  /// \throw std::invalid_argument if negative or not a number
  void set_feature_tolerance(double tolerance);
  double feature_tolerance() const { return feature_tolerance_; }

  /// Threads of the engine driver, 0 (default) = all cores. The result doesn't depend on it.
  void set_threads(unsigned threads) { threads_ = threads; }

  /// Called after each contraction, in order; vertices are handle indices. (The observer gets only counts, but can
  /// abort.) With `max_error` as a target it is called at the end, for the contractions that stand.
  void set_listener(std::function<void(const Contraction&)> listener) { listener_ = std::move(listener); }

  /// Contracts until a target is reached. The `max_cost` of the cost module counts as one.
  ///
  /// Only the engine driver takes `max_error`. It is measured from the mesh as it is now, and proven of the mesh that
  /// it leaves, with the rounding to its scalar. The run begins anew, as after `initialize()`. `ModMaxErrorT` measures
  /// from the mesh at `initialize()`, and works in either driver. Contractions are taken back where a proof fails; so
  /// the observer's numbers may fall.
  /// \param only_selected vertices that aren't selected neither move nor vanish
  /// \throw std::logic_error if not initialized, or if the engine driver was asked for or is needed for a pair
  ///        threshold or `max_error`, and can't run (see `engine_obstacle`)
  /// \throw std::invalid_argument if the target's cost limit is negative or not a number, if the cost module isn't ours
  ///        and the target has a cost limit, or if an error limit isn't positive, finite, and above what rounding to
  ///        the scalar of the mesh may move a vertex
  DecimateResult decimate(const DecimateTarget& target, ExactlyBool only_selected = false);

  /// Makes at most `n_contractions`, 0 = as many as possible, as in the stock. \return how many were made
  std::size_t decimate(std::size_t n_contractions = 0, ExactlyBool only_selected = false);
  /// Contracts until at most `n_vertices` are left. \return the number of contractions
  std::size_t decimate_to(std::size_t n_vertices, ExactlyBool only_selected = false);
  /// Contracts until at most `n_vertices` or at most `n_faces` are left. \return the number of contractions
  std::size_t decimate_to_faces(std::size_t n_vertices = 0, std::size_t n_faces = 0, ExactlyBool only_selected = false);

  /// The result of the last run.
  const DecimateResult& result() const { return result_; }
  /// Refusals in the last run by modules other than `ModFlipGuardT`, `ModRadiusRatioT` and `ModMaxErrorT`, for those
  /// that refused.
  const std::vector<ModuleRefusals>& module_refusals() const { return module_refusals_; }

 private:
  friend class EngineRunT<MeshT>;
  friend class MeshRunT<MeshT>;
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;

  using Attached = AttachedModuleT<MeshT>;
  /// Who does what, said by `initialize()`.
  struct Roles {
    Module* cost_module = nullptr;                   ///< the one that ranks
    PairCostModuleT<MeshT>* cost = nullptr;          ///< the same, if it places vertices
    bool is_engine_cost = false;                     ///< whether the engine knows its type
    bool has_own_priority = false;                   ///< whether a `collapse_priority` of its own ranks
    bool has_own_flip_guard = false;                 ///< whether a class derived from `ModFlipGuardT` takes part
    ModFlipGuardT<MeshT>* flip_guard = nullptr;      ///< exactly of this type
    ModRadiusRatioT<MeshT>* radius_guard = nullptr;  ///< exactly of this type
    ErrorGuardT<MeshT>* error_guard = nullptr;       ///< a `ModMaxErrorT`, or derived
    Module* foreign_guard = nullptr;                 ///< the first that the engine doesn't know
    std::vector<Module*> asked_guards;               ///< by the mesh driver
  };
  void require_known_modules();
  void assign_roles();
  void assign_guard(const Attached& guard);
  DecimateOptions engine_options_but_cost() const;
  void require_initialized() const;
  Driver choose_driver(const DecimateTarget& target) const;
  bool has_error_limit() const { return roles_.error_guard && roles_.error_guard->max_error(); }
  DecimateTarget with_error_limits(const DecimateTarget& target) const;
  DecimateResult run_engine(const DecimateTarget& target, bool only_selected);
  DecimateResult run_on_mesh(const DecimateTarget& target, bool only_selected);
  DecimateTarget checked(const DecimateTarget& target) const;
  double max_normal_flip_deg() const;
  double min_radius_ratio() const { return roles_.radius_guard ? roles_.radius_guard->min_radius_ratio() : 0; }
  bool is_fixed(VertexHandle v, bool only_selected) const;

  void count_refusal(const Module& module);

  MeshT& mesh_;
  std::vector<Attached> attached_;
  bool is_ready_ = false;  ///< since `initialize()`; the base has its own `is_initialized()`
  bool is_fresh_ = false;  ///< nothing contracted since `initialize()`

  Roles roles_;

  Driver driver_ = Driver::automatic;
  Driver last_driver_ = Driver::automatic;
  PairOptions pairs_;
  double feature_tolerance_ = DecimateOptions().feature_tolerance;
  unsigned threads_ = 0;
  std::function<void(const Contraction&)> listener_;
  DecimateResult result_;
  std::vector<ModuleRefusals> module_refusals_;
};

}  // namespace whittle

#include "whittle/openmesh/detail/pair_decimater_impl.hh"
