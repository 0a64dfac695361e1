#pragma once

#include <algorithm>  // before OpenMesh's headers, which use std::find without it

#include <OpenMesh/Tools/Decimater/BaseDecimaterT.hh>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/openmesh/detail/feature_bits.hh"
#include "whittle/openmesh/mod_flip_guard.hh"
#include "whittle/openmesh/mod_radius_ratio.hh"
#include "whittle/openmesh/pair_cost_module.hh"

// A decimater over pairs for OpenMesh meshes: exact order, placement, both drivers the same contractions.
//
//   both drivers:  the engine's loop on a copy of the geometry (contraction_loop.hh has it as pseudo-code)
//   mesh driver:   modules rank, place and refuse; each contraction is made on the mesh at once
//   engine driver: the engine's own costs and guards; the contractions are made on the mesh in the end, all at once
//
// With a pair threshold vertices that no edge joins are pairs, too, and what they leave is cut into copies where
// half-edges can't hold it (vertex_copies.hh).

namespace whittle {

/// What does the work in `PairDecimaterT`.
enum class Driver {
  automatic,  ///< the engine where it can, else the mesh driver
  engine,  ///< many times faster. Exactly our cost modules, `ModFlipGuardT` and `ModRadiusRatioT`, nothing derived from
           ///< them, and no others
  mesh     ///< any modules; what a derived one overrides counts
};

/// How often a module refused a contraction.
struct ModuleRejections {
  std::string module;  ///< its name
  std::uint64_t count = 0;
};

template <class MeshT>
class EngineRunT;
template <class MeshT>
class MeshRunT;

/// Has the calls of OpenMesh's `DecimaterT` and takes the same modules. Differences in short (docs/dev/openmesh.md has
/// them all):
///   - The cost module is `ModGarlandHeckbertT`, `ModMemorylessT`, `ModLindstromTurkT` or `ModMidpointT`, or any
///     non-binary module of OpenMesh's: then v1 keeps its place, both directions of an edge are candidates, and
///     OpenMesh's own legality rules hold.
///   - A flip guard over both stars is always on. Its angle is the default of the cost (`CostTraits`: 75°, with
///     `ModMemorylessT` 60°, with `ModLindstromTurkT` 110°) unless a `ModFlipGuardT` says otherwise. Other binary
///     modules are asked about both stars where the merged vertex moves, with v̄ as `p1`.
///   - Of a pair with one locked vertex the other one vanishes; with `only_selected`, vertices that aren't selected
///     count as locked.
///   - A vertex with two feature edges moves along them only, from vertex to vertex; one with another number of them
///     stays, and so does one with the feature bit and none. Lines keep their loops and stay near to where they were.
///   - Counts are those of what isn't deleted. Vertices without a face don't count, copies of a vertex as one.
///   - Copies of a vertex (`vertex_copies.hh`) that are at one position are one vertex to the engine driver. The mesh
///     driver can't move them together, so it neither moves nor removes them.
///
/// As in the stock, surviving handles and their properties persist, and removed elements are marked deleted until
/// `garbage_collection()`. *The engine driver writes to the mesh at the end only (or when aborted):* until then an
/// observer or listener sees it as it was. Where it contracted threshold pairs or vertices have copies, new copies may
/// come at the end: `FaceRelinkerT` says what persists.
template <class MeshT>
class PairDecimaterT : public OpenMesh::Decimater::BaseDecimaterT<MeshT> {
 public:
  using Base = OpenMesh::Decimater::BaseDecimaterT<MeshT>;
  using Mesh = MeshT;
  using Module = OpenMesh::Decimater::ModBaseT<MeshT>;
  using CollapseInfo = OpenMesh::Decimater::CollapseInfoT<MeshT>;

  /// \param mesh must outlive the decimater
  explicit PairDecimaterT(MeshT& mesh) : Base(mesh), mesh_(mesh) {}

  /// As the base's. What is added through a reference to the base is refused by `initialize`.
  template <class ModuleT>
  bool add(OpenMesh::Decimater::ModHandleT<ModuleT>& handle);
  template <class ModuleT>
  bool remove(OpenMesh::Decimater::ModHandleT<ModuleT>& handle);

  /// Initializes every module for the mesh as it is; a second call starts anew. Needed after adding modules, setting
  /// their options, or changing the mesh; *not* between calls of `decimate`, the next goes on where the last one ended.
  /// \return false unless exactly one module ranks (isn't binary)
  /// \throw std::logic_error if modules were added through a reference to the base: their types are unknown then
  bool initialize();

  /// Default automatic.
  void set_driver(Driver driver) { driver_ = driver; }
  Driver driver() const { return driver_; }
  /// Why the engine driver can't run now; empty if it can.
  std::string engine_obstacle() const;
  /// The one that ran last: engine or mesh.
  Driver last_driver() const { return last_driver_; }

  /// Two vertices closer than this are a pair though no edge joins them: parts that lie side by side can become one.
  /// Model units, [0, inf]; empty (default) = no such pairs. Garland & Heckbert's valid pairs.
  /// \cite garland_1997_surface
  ///
  /// Afterwards the mesh may have copies of vertices (`vertex_copies.hh`), and `geometry_of(mesh)` gives the indexed
  /// mesh in which they are one, as the engine made it; the next `initialize()` and `decimate` go on from that.
  /// Only the engine driver contracts such pairs. Where it can't run, `decimate` throws: with foreign modules or
  /// `Driver::mesh`; and so it does with other costs than the quadric's, or with isotropy or a valence weight. Locked
  /// vertices and `only_selected` count as for edges.
  /// \throw std::invalid_argument if negative or not a number
  void set_pair_threshold(std::optional<double> threshold);
  std::optional<double> pair_threshold() const { return pairs_.threshold; }
  /// The same, with how many pairs a vertex may have, and which are left out. \throw as above
  void set_pair_options(const PairOptions& options);
  const PairOptions& pair_options() const { return pairs_; }

  /// How far a feature line may come to lie from what it was when `decimate` was called, of the diagonal of the mesh's
  /// bounding box. [0, inf]; default that of the engine, 5e-4.
  /// \throw std::invalid_argument if negative or not a number
  void set_feature_tolerance(double tolerance);
  double feature_tolerance() const { return feature_tolerance_; }

  /// Threads of the engine driver, 0 (default) = all cores. No result depends on it.
  void set_threads(unsigned threads) { threads_ = threads; }

  /// Called after each contraction, in order; vertices are handle indices. (The observer is told counts, and may
  /// abort.)
  void set_listener(std::function<void(const Contraction&)> listener) { listener_ = std::move(listener); }

  /// Contracts until a target is reached; the cost module's `max_cost` counts as one.
  /// \param only_selected vertices that aren't selected neither move nor vanish
  /// \throw std::logic_error if not initialized, or if the engine was asked for, or a pair threshold set, and it can't
  ///        run (see `engine_obstacle`)
  /// \throw std::invalid_argument if the target's limit of the cost is negative, not a number, or given with a cost
  ///        module that isn't ours
  DecimateResult decimate(const DecimateTarget& target, bool only_selected = false);

  /// At most `n_contractions`, 0 = as many as possible, as in the stock. \return how many there were
  std::size_t decimate(std::size_t n_contractions = 0, bool only_selected = false);
  /// Until at most `n_vertices` are left. \return the number of contractions
  std::size_t decimate_to(std::size_t n_vertices, bool only_selected = false);
  /// Until at most `n_vertices` or at most `n_faces` are left. \return the number of contractions
  std::size_t decimate_to_faces(std::size_t n_vertices = 0, std::size_t n_faces = 0, bool only_selected = false);

  /// Of the last run.
  const DecimateResult& result() const { return result_; }
  /// Of the last run: what modules other than `ModFlipGuardT` and `ModRadiusRatioT` refused; those that did.
  const std::vector<ModuleRejections>& module_rejections() const { return module_rejections_; }

 private:
  friend class EngineRunT<MeshT>;
  friend class MeshRunT<MeshT>;
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;

  /// A module, with the interfaces of ours that it has.
  struct Attached {
    Module* module;
    PairCostModuleT<MeshT>* cost;
    bool is_engine_cost;  ///< exactly one of our cost modules
    ModFlipGuardT<MeshT>* flip_guard;
    ModRadiusRatioT<MeshT>* radius_guard;
  };
  struct Counts {
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
  };

  void require_known_modules();
  void assign_roles();
  DecimateOptions engine_options_but_cost() const;
  void require_initialized() const;
  Driver choose_driver() const;
  DecimateTarget checked(const DecimateTarget& target) const;
  Counts count_elements() const;
  double max_normal_flip_deg() const;
  double min_radius_ratio() const { return radius_guard_ ? radius_guard_->min_radius_ratio() : 0; }
  bool is_fixed(VertexHandle v, bool only_selected) const;

  void count_rejection(const Module& module);

  MeshT& mesh_;
  std::vector<Attached> attached_;
  bool is_ready_ = false;  ///< our side of `is_initialized()`
  bool is_fresh_ = false;  ///< nothing contracted since `initialize()`

  // Roles, since `initialize()`. One of the first two is null.
  PairCostModuleT<MeshT>* cost_ = nullptr;
  bool is_engine_cost_ = false;
  Module* foreign_cost_ = nullptr;
  ModFlipGuardT<MeshT>* flip_guard_ = nullptr;
  ModRadiusRatioT<MeshT>* radius_guard_ = nullptr;
  std::vector<Module*> foreign_guards_;

  Driver driver_ = Driver::automatic;
  Driver last_driver_ = Driver::automatic;
  PairOptions pairs_;
  double feature_tolerance_ = DecimateOptions().feature_tolerance;
  unsigned threads_ = 0;
  std::function<void(const Contraction&)> listener_;
  DecimateResult result_;
  std::vector<ModuleRejections> module_rejections_;
};

}  // namespace whittle

#include "whittle/openmesh/pair_decimater_impl.hh"
