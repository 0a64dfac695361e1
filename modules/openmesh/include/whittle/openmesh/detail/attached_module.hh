#pragma once

#include <concepts>
#include <type_traits>

#include "whittle/openmesh/detail/error_guard.hh"
#include "whittle/openmesh/mod_flip_guard.hh"
#include "whittle/openmesh/mod_radius_ratio.hh"
#include "whittle/openmesh/pair_cost_module.hh"

namespace whittle {

template <class MeshT>
class PlacingModuleT;
template <class MeshT>
class ModGarlandHeckbertT;
template <class MeshT>
class ModMaxErrorT;

namespace detail {

/// The class that declares a member function.
template <class Class, class Result, class... Arguments>
Class& declaring_class(Result (Class::*)(Arguments...));

template <class ModuleT, class Class>
concept HasPriorityOf = requires {
  { declaring_class(&ModuleT::collapse_priority) } -> std::same_as<Class&>;
};

/// Whether a module has another `collapse_priority` than our cost modules have: it isn't derived from one, or a derived
/// class overrides it. What can't be told, because it is private or overloaded, counts as overridden.
template <class ModuleT, class MeshT>
inline constexpr bool has_own_priority =
    !HasPriorityOf<ModuleT, PlacingModuleT<MeshT>> && !HasPriorityOf<ModuleT, ModGarlandHeckbertT<MeshT>>;

}  // namespace detail

/// A module of a `PairDecimaterT`, and those of our classes that it is, or is derived from.
template <class MeshT>
struct AttachedModuleT {
  OpenMesh::Decimater::ModBaseT<MeshT>* module = nullptr;
  bool is_of_engine = false;      ///< whether the engine knows its type
  bool has_own_priority = false;  ///< of a cost module
  PairCostModuleT<MeshT>* cost = nullptr;
  FaceGuardT<MeshT>* face_guard = nullptr;
  ModFlipGuardT<MeshT>* flip_guard = nullptr;
  ModRadiusRatioT<MeshT>* radius_guard = nullptr;
  ErrorGuardT<MeshT>* error_guard = nullptr;

  /// \param module of exactly this type
  template <class ModuleT>
  static AttachedModuleT of(ModuleT& module) {
    AttachedModuleT attached;
    attached.module = &module;
    attached.is_of_engine = is_engine_cost<ModuleT> || std::is_same_v<ModFlipGuardT<MeshT>, ModuleT> ||
                            std::is_same_v<ModRadiusRatioT<MeshT>, ModuleT> ||
                            std::is_same_v<ModMaxErrorT<MeshT>, ModuleT>;
    attached.has_own_priority = detail::has_own_priority<ModuleT, MeshT>;
    if constexpr (std::is_base_of_v<PairCostModuleT<MeshT>, ModuleT>) attached.cost = &module;
    if constexpr (std::is_base_of_v<FaceGuardT<MeshT>, ModuleT>) attached.face_guard = &module;
    if constexpr (std::is_base_of_v<ModFlipGuardT<MeshT>, ModuleT>) attached.flip_guard = &module;
    if constexpr (std::is_base_of_v<ModRadiusRatioT<MeshT>, ModuleT>) attached.radius_guard = &module;
    if constexpr (std::is_base_of_v<ErrorGuardT<MeshT>, ModuleT>) attached.error_guard = &module;
    return attached;
  }
};

}  // namespace whittle
