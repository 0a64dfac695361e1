#pragma once

#include <sstream>
#include <stdexcept>
#include <utility>

#include "whittle/openmesh/detail/drivers/engine_run.hh"
#include "whittle/openmesh/detail/drivers/mesh_run.hh"

namespace whittle {

// Modules -------------------------------------------------------------------------------------------------------------

template <class MeshT>
template <class ModuleT>
bool PairDecimaterT<MeshT>::add(OpenMesh::Decimater::ModHandleT<ModuleT>& handle) {
  if (!Base::add(handle)) return false;
  attached_.push_back(Attached::of(Base::module(handle)));
  is_ready_ = false;
  return true;
}

template <class MeshT>
template <class ModuleT>
bool PairDecimaterT<MeshT>::remove(OpenMesh::Decimater::ModHandleT<ModuleT>& handle) {
  const Module* module = handle.is_valid() ? &Base::module(handle) : nullptr;
  if (!Base::remove(handle)) return false;
  std::erase_if(attached_, [module](const Attached& attached) { return attached.module == module; });
  is_ready_ = false;
  return true;
}

template <class MeshT>
bool PairDecimaterT<MeshT>::initialize() {
  require_known_modules();
  this->set_uninitialized();  // else the base does nothing a second time; after a mere reset() it lists modules twice
  is_ready_ = Base::initialize();
  is_fresh_ = is_ready_;
  if (is_ready_) assign_roles();
  return is_ready_;
}

/// The base's `add` can't be overridden, and its list of modules is private. Only `info` gives their number, in words.
template <class MeshT>
void PairDecimaterT<MeshT>::require_known_modules() {
  this->set_uninitialized();
  std::ostringstream info;
  Base::info(info);
  const std::string text = info.str();
  const std::string label = "available modules: ";
  const std::size_t place = text.find(label);
  if (place == std::string::npos || std::stoul(text.substr(place + label.size())) == attached_.size()) return;
  throw std::logic_error(
      "PairDecimaterT: a module was added or removed through a reference to BaseDecimaterT; call add() and remove() on "
      "the PairDecimaterT itself");
}

template <class MeshT>
void PairDecimaterT<MeshT>::assign_roles() {
  roles_ = {};
  // The base's rule: the module that isn't binary, or else the one called "Quadric".
  auto ranking =
      std::find_if(attached_.begin(), attached_.end(), [](const Attached& a) { return !a.module->is_binary(); });
  if (ranking == attached_.end()) {
    const auto is_quadric = [](const Attached& a) { return a.module->name() == "Quadric"; };
    ranking = std::find_if(attached_.begin(), attached_.end(), is_quadric);
  }
  roles_.cost_module = ranking->module;
  if (ranking->cost && ranking->cost->has_placement()) {
    roles_.cost = ranking->cost;
    roles_.is_engine_cost = ranking->is_of_engine;
    roles_.has_own_priority = ranking->has_own_priority;
  }
  for (auto it = attached_.begin(); it != attached_.end(); ++it) {
    if (it->flip_guard && !it->is_of_engine) roles_.has_own_flip_guard = true;
    if (it != ranking) assign_guard(*it);
  }
  // Proofs take the most time: those that need them are asked last.
  const auto needs_no_proof = [this](const Module* module) { return module != roles_.error_guard; };
  std::stable_partition(roles_.asked_guards.begin(), roles_.asked_guards.end(), needs_no_proof);
}

template <class MeshT>
void PairDecimaterT<MeshT>::assign_guard(const Attached& guard) {
  if (guard.face_guard)
    guard.face_guard->set_cost_module(nullptr);  // the mesh driver says where the merged vertex goes
  const bool is_error_guard = guard.error_guard && !roles_.error_guard;
  if (is_error_guard) roles_.error_guard = guard.error_guard;
  if (guard.is_of_engine && guard.flip_guard && !roles_.flip_guard) {
    roles_.flip_guard = guard.flip_guard;
  } else if (guard.is_of_engine && guard.radius_guard && !roles_.radius_guard) {
    roles_.radius_guard = guard.radius_guard;
  } else {
    roles_.asked_guards.push_back(guard.module);
    const bool is_known = guard.is_of_engine && is_error_guard;
    if (!is_known && !roles_.foreign_guard) roles_.foreign_guard = guard.module;
  }
}

template <class MeshT>
std::string PairDecimaterT<MeshT>::engine_obstacle() const {
  if (!is_ready_) return "not initialized";
  if (!roles_.cost) return "the costs are those of module " + roles_.cost_module->name();
  if (roles_.foreign_guard) return "module " + roles_.foreign_guard->name() + " works on the mesh alone";
  if (!roles_.is_engine_cost) return "the cost module is not one of Whittle's own, but may be derived from one";
  if (!roles_.cost->engine_options()) return "the engine doesn't know these costs";
  if (has_error_limit() && !is_fresh_) {
    return "module MaxError measures from the mesh at initialize(), and contractions were made since";
  }
  return {};
}

template <class MeshT>
void PairDecimaterT<MeshT>::set_pair_options(const PairOptions& options) {
  if (options.threshold && !(*options.threshold >= 0)) {
    throw std::invalid_argument("PairDecimaterT: the pair threshold is negative or not a number");
  }
  pairs_ = options;
}

template <class MeshT>
void PairDecimaterT<MeshT>::set_pair_threshold(std::optional<double> threshold) {
  PairOptions options = pairs_;
  options.threshold = threshold;
  set_pair_options(options);
}

template <class MeshT>
void PairDecimaterT<MeshT>::set_feature_tolerance(double tolerance) {
  if (!(tolerance >= 0)) {
    throw std::invalid_argument("PairDecimaterT: the feature tolerance is negative or not a number");
  }
  feature_tolerance_ = tolerance;
}

// Runs ----------------------------------------------------------------------------------------------------------------

template <class MeshT>
void PairDecimaterT<MeshT>::require_initialized() const {
  if (!is_ready_ || !this->is_initialized()) {
    throw std::logic_error(
        "PairDecimaterT: not initialized; initialize() must have returned true since the last add()");
  }
  if (roles_.cost && roles_.cost->has_new_options()) {
    throw std::logic_error(
        "PairDecimaterT: options of the cost module were set after initialize(); call initialize() again");
  }
}

template <class MeshT>
DecimateTarget PairDecimaterT<MeshT>::checked(const DecimateTarget& target) const {
  const std::optional<double> asked = target.cost_limit();
  if (asked && !(*asked >= 0)) {
    throw std::invalid_argument("PairDecimaterT: max_cost is negative or not a number");
  }
  if (asked && !roles_.cost) {
    throw std::invalid_argument("PairDecimaterT: max_cost needs a cost module of ours; limit " +
                                roles_.cost_module->name() + " by its own settings");
  }
  const std::optional<double> limit = roles_.cost ? roles_.cost->max_cost() : std::nullopt;
  return limit ? target.or_max_cost(std::min(*limit, asked.value_or(*limit))) : target;
}

template <class MeshT>
DecimateResult PairDecimaterT<MeshT>::decimate(const DecimateTarget& target, ExactlyBool only_selected) {
  require_initialized();
  const DecimateTarget effective = checked(target);
  last_driver_ = choose_driver(effective);
  module_refusals_.clear();
  result_ =
      last_driver_ == Driver::engine ? run_engine(effective, only_selected) : run_on_mesh(effective, only_selected);
  return result_;
}

template <class MeshT>
DecimateResult PairDecimaterT<MeshT>::run_engine(const DecimateTarget& target, bool only_selected) {
  const DecimateTarget effective = with_error_limits(target);
  if (effective.error_limit() && !is_fresh_) initialize();
  DecimateResult result = EngineRunT<MeshT>(*this, effective, only_selected).run();
  if (roles_.error_guard) roles_.error_guard->note_new_surface();
  return result;
}

template <class MeshT>
DecimateResult PairDecimaterT<MeshT>::run_on_mesh(const DecimateTarget& target, bool only_selected) {
  DecimateResult result = MeshRunT<MeshT>(*this, target, only_selected).run();
  if (!has_error_limit()) return result;
  if (roles_.error_guard->is_proven()) result.proven_error = roles_.error_guard->max_error();
  if (result.stop == StopReason::exhausted && result.refusals[Refusal::error] > 0) result.stop = StopReason::error;
  return result;
}

/// The limits of a `ModMaxErrorT` count as limits of the target.
template <class MeshT>
DecimateTarget PairDecimaterT<MeshT>::with_error_limits(const DecimateTarget& target) const {
  if (!has_error_limit()) return target;
  const double surface = *roles_.error_guard->max_error();
  const double border = *roles_.error_guard->max_border_error();
  return target.or_max_error(std::min(surface, target.error_limit().value_or(surface)),
                             std::min(border, target.border_error_limit().value_or(border)));
}

template <class MeshT>
Driver PairDecimaterT<MeshT>::choose_driver(const DecimateTarget& target) const {
  std::string obstacle = driver_ == Driver::mesh ? "the mesh driver was asked for" : engine_obstacle();
  if (obstacle.empty() && pairs_.threshold > 0 && !takes_threshold_pairs(*roles_.cost->engine_options())) {
    obstacle = "such pairs go with the plain quadric cost alone";
  }
  if (obstacle.empty()) return Driver::engine;
  if (target.error_limit()) {
    throw std::logic_error(
        "PairDecimaterT: only the engine driver takes max_error as a target, and it can't be used: " + obstacle +
        ". ModMaxErrorT works in both drivers");
  }
  if (pairs_.threshold > 0) {
    throw std::logic_error("PairDecimaterT: only the engine driver contracts threshold pairs, and it can't be used: " +
                           obstacle);
  }
  if (driver_ == Driver::engine) {
    throw std::logic_error("PairDecimaterT: the engine driver can't be used: " + obstacle);
  }
  return Driver::mesh;
}

template <class MeshT>
std::size_t PairDecimaterT<MeshT>::decimate(std::size_t n_contractions, ExactlyBool only_selected) {
  require_initialized();
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  const std::uint64_t n_vertices = count_vertices(mesh_, first_copies(mesh_));
  if (n_contractions > 0 && n_contractions < n_vertices) target = DecimateTarget::vertices(n_vertices - n_contractions);
  return decimate(target, only_selected).n_contractions;
}

template <class MeshT>
std::size_t PairDecimaterT<MeshT>::decimate_to(std::size_t n_vertices, ExactlyBool only_selected) {
  return decimate(DecimateTarget::vertices(n_vertices), only_selected).n_contractions;
}

template <class MeshT>
std::size_t PairDecimaterT<MeshT>::decimate_to_faces(std::size_t n_vertices, std::size_t n_faces,
                                                     ExactlyBool only_selected) {
  return decimate(DecimateTarget::vertices(n_vertices).or_faces(n_faces), only_selected).n_contractions;
}

/// Without a `ModFlipGuardT` the cost's default. A class derived from it says itself which angles it allows. Costs that
/// the engine doesn't know have the default of plain quadrics.
template <class MeshT>
double PairDecimaterT<MeshT>::max_normal_flip_deg() const {
  if (roles_.flip_guard) return roles_.flip_guard->max_normal_flip_deg();
  if (roles_.has_own_flip_guard) return 180;
  const std::optional<CostOptions> known = roles_.cost ? roles_.cost->engine_options() : std::nullopt;
  return cost_traits(known ? known->cost : Cost::quadric).default_max_normal_flip_deg;
}

template <class MeshT>
bool PairDecimaterT<MeshT>::is_fixed(VertexHandle v, bool only_selected) const {
  const auto& status = mesh_.status(v);
  return status.locked() || (only_selected && !status.selected());
}

/// The engine's options in both drivers. The order is exact in both.
template <class MeshT>
DecimateOptions PairDecimaterT<MeshT>::engine_options_but_cost() const {
  DecimateOptions options;
  options.order = Order::exact;
  options.pairs = pairs_;
  options.max_normal_flip_deg = max_normal_flip_deg();
  options.min_radius_ratio = min_radius_ratio();
  options.feature_tolerance = feature_tolerance_;
  options.threads = threads_;
  return options;
}

template <class MeshT>
void PairDecimaterT<MeshT>::count_refusal(const Module& module) {
  const auto has_name = [&module](const ModuleRefusals& entry) { return entry.module == module.name(); };
  auto entry = std::find_if(module_refusals_.begin(), module_refusals_.end(), has_name);
  if (entry == module_refusals_.end()) entry = module_refusals_.insert(entry, {module.name(), 0});
  ++entry->count;
}

}  // namespace whittle
