#include "openmesh/openmesh_engine.hh"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "openmesh/double_mesh.hh"
#include "terminal/errors.hh"
#include "terminal/table.hh"
#include "whittle/openmesh/conversions.hh"
#include "whittle/openmesh/mod_flip_guard.hh"
#include "whittle/openmesh/mod_garland_heckbert.hh"
#include "whittle/openmesh/mod_lindstrom_turk.hh"
#include "whittle/openmesh/mod_memoryless.hh"
#include "whittle/openmesh/mod_midpoint.hh"

namespace whittle::app {
namespace {

using StockDecimater = OpenMesh::Decimater::DecimaterT<DoubleMesh>;
using CostModule = PlacingModuleT<DoubleMesh>;

template <class ModuleT>
ModuleT& add_module(StockDecimater& decimater) {
  typename ModuleT::Handle handle;
  decimater.add(handle);
  return decimater.module(handle);
}

CostModule& add_plain_cost(StockDecimater& decimater, const DecimateOptions& options) {
  QuadricOptions quadric = options.quadric;
  if (options.boundary == Boundary::free) quadric.boundary_weight = 0;
  switch (options.effective_cost()) {
    case Cost::lindstrom_turk:
      return add_module<ModLindstromTurkT<DoubleMesh>>(decimater);
    case Cost::midpoint:
      return add_module<ModMidpointT<DoubleMesh>>(decimater);
    case Cost::memoryless: {
      auto& module = add_module<ModMemorylessT<DoubleMesh>>(decimater);
      module.set_options(quadric);
      return module;
    }
    case Cost::quadric:
      break;
    default:
      throw UsageError("--engine openmesh has no module for --cost " +
                       std::string(to_string(options.effective_cost())));
  }
  auto& module = add_module<ModGarlandHeckbertT<DoubleMesh>>(decimater);
  module.set_options(quadric);
  module.set_isotropy(options.isotropy);
  return module;
}

CostModule& add_cost(StockDecimater& decimater, const DecimateOptions& options) {
  CostModule& cost = add_plain_cost(decimater, options);
  cost.set_valence_weight(options.valence_weight);
  return cost;
}

void add_flip_guard(StockDecimater& decimater, const CostModule& cost, const DecimateOptions& options) {
  auto& flip_guard = add_module<ModFlipGuardT<DoubleMesh>>(decimater);
  flip_guard.set_max_normal_flip_deg(options.effective_max_normal_flip_deg());
  flip_guard.set_cost_module(&cost);
}

/// A module that refuses nothing. It records which vertex each one was merged into, and the greatest cost.
template <class MeshT>
class ModCollapseLogT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModCollapseLogT, MeshT, CollapseLog);

  explicit ModCollapseLogT(MeshT& mesh) : Base(mesh, true), merged_into_(mesh.n_vertices(), invalid_index) {}

  void set_cost_module(const CostModule& module) { cost_ = &module; }

  /// Evaluates the cost again, as the cost in OpenMesh's heap may be out of date. Binary modules are called before the
  /// ranking module, so the quadrics are from before the collapse.
  void preprocess_collapse(const CollapseInfo& collapse) override {
    max_cost_ = std::max(max_cost_, cost_->evaluate(collapse).cost);
    merged_into_[static_cast<std::size_t>(collapse.v0.idx())] = static_cast<Index>(collapse.v1.idx());
    ++n_collapses_;
  }

  std::size_t n_collapses() const { return n_collapses_; }
  /// The greatest cost of a collapse, by model units.
  double max_cost() const { return cost_->frame().cost_to_model(max_cost_, cost_->cost_dimension()); }
  /// The vertex that v has been merged into, or v.
  Index survivor(Index v) const {
    while (merged_into_[v] != invalid_index) v = merged_into_[v];
    return v;
  }

 private:
  const CostModule* cost_ = nullptr;
  std::vector<Index> merged_into_;
  std::size_t n_collapses_ = 0;
  double max_cost_ = 0;
};
using CollapseLog = ModCollapseLogT<DoubleMesh>;

void fill(DoubleMesh& mesh, const IndexedMesh& input, const std::string& name) {
  IndexedMesh geometry;
  geometry.positions = input.positions;
  geometry.faces = input.faces;
  const std::size_t n_refused = to_open_mesh(geometry, mesh, NonManifold::refuse).size();
  if (n_refused == 0) return;
  throw UnsupportedMesh(name + ": OpenMesh's mesh can't hold " + std::to_string(n_refused) + " of the " +
                        faces_text(input.faces.size()) + "; use --engine flat");
}

void lock_border(DoubleMesh& mesh) {
  for (const auto v : mesh.vertices()) {
    if (mesh.is_boundary(v)) mesh.status(v).set_locked(true);
  }
}

Progress progress_after(std::size_t n_collapses, const IndexedMesh& input, const DecimateTarget& target) {
  // A collapse takes two faces, except at borders.
  const std::size_t n_faces = input.faces.size() - std::min(input.faces.size(), 2 * n_collapses);
  const auto share = [n_collapses](std::size_t initial, std::uint64_t wanted, std::size_t each) {
    return initial > wanted ? static_cast<double>(each * n_collapses) / static_cast<double>(initial - wanted) : 1.0;
  };
  double fraction = 0;
  if (target.n_faces()) fraction = share(input.faces.size(), *target.n_faces(), 2);
  if (target.n_vertices()) fraction = std::max(fraction, share(input.positions.size(), *target.n_vertices(), 1));
  return {input.positions.size() - n_collapses, n_faces, std::min(1.0, fraction)};
}

/// The result and the vertex map. \pre the garbage of `mesh` has not been collected
Decimation extract(const DoubleMesh& mesh, const IndexedMesh& input, const CollapseLog& log) {
  Decimation out;
  out.mesh = geometry_of(mesh);
  std::vector<Index>& origins = out.mesh.origins;
  std::vector<Index> number_of(input.positions.size(), invalid_index);
  for (std::size_t v = 0; v < out.mesh.positions.size(); ++v) {
    number_of[origins.empty() ? v : origins[v]] = static_cast<Index>(v);
  }
  for (Index v = 0; v < input.positions.size(); ++v) out.vertex_map.push_back(number_of[log.survivor(v)]);
  if (!input.origins.empty()) {
    if (origins.empty())
      origins = input.origins;
    else
      for (Index& origin : origins) origin = input.origins[origin];
  }
  return out;
}

}  // namespace

Decimation decimate_in_openmesh(const IndexedMesh& input, const std::string& name, const DecimateTarget& target,
                                const DecimateOptions& options) {
  DoubleMesh mesh;
  fill(mesh, input, name);
  const HeldStatus status(mesh);
  if (options.boundary == Boundary::locked) lock_border(mesh);

  StockDecimater decimater(mesh);
  const CostModule& cost = add_cost(decimater, options);
  add_flip_guard(decimater, cost, options);
  auto& log = add_module<CollapseLog>(decimater);
  log.set_cost_module(cost);

  bool cancelled = false;
  ContractionObserver observer([&](std::size_t n_collapses) {
    cancelled = options.progress && !options.progress(progress_after(n_collapses, input, target));
    return !cancelled;
  });
  decimater.set_observer(&observer);
  decimater.initialize();
  decimater.decimate_to_faces(target.n_vertices().value_or(0), target.n_faces().value_or(0));

  Decimation out = extract(mesh, input, log);
  out.result.n_contractions = log.n_collapses();
  out.result.n_vertices = out.mesh.positions.size();
  out.result.n_faces = out.mesh.faces.size();
  out.result.max_cost = log.max_cost();
  out.result.why_in_one_pass = "OpenMesh's decimater has one heap";
  const bool is_reached = target.is_reached_at(out.result.n_faces, out.result.n_vertices);
  out.result.stop = cancelled ? StopReason::cancelled : is_reached ? StopReason::target : StopReason::exhausted;
  return out;
}

}  // namespace whittle::app
