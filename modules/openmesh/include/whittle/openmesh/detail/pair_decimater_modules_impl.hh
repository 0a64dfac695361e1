#pragma once

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "whittle/openmesh/detail/overrides.hh"
#include "whittle/openmesh/pair_decimater.hh"

// The modules of a `PairDecimaterT`, and what each of them does there.

namespace whittle {

template <class MeshT>
template <class ModuleT>
bool PairDecimaterT<MeshT>::add(OpenMesh::Decimater::ModHandleT<ModuleT>& handle) {
  if (!Base::add(handle)) return false;
  ModuleT& module = Base::module(handle);
  constexpr bool is_engine_guard = std::is_same_v<ModFlipGuardT<MeshT>, ModuleT> ||
                                   std::is_same_v<ModRadiusRatioT<MeshT>, ModuleT> ||
                                   std::is_same_v<ModMaxErrorT<MeshT>, ModuleT>;
  Attached attached;
  attached.module = &module;
  attached.is_of_engine = is_engine_cost<ModuleT> || is_engine_guard;
  attached.has_own_priority = detail::has_own_priority<ModuleT, MeshT>;
  if constexpr (std::is_base_of_v<PairCostModuleT<MeshT>, ModuleT>) attached.cost = &module;
  if constexpr (std::is_base_of_v<FaceGuardT<MeshT>, ModuleT>) attached.face_guard = &module;
  if constexpr (std::is_base_of_v<ModFlipGuardT<MeshT>, ModuleT>) attached.flip_guard = &module;
  if constexpr (std::is_base_of_v<ModRadiusRatioT<MeshT>, ModuleT>) attached.radius_guard = &module;
  if constexpr (std::is_base_of_v<ModMaxErrorT<MeshT>, ModuleT>) attached.error_guard = &module;
  attached_.push_back(attached);
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

}  // namespace whittle
