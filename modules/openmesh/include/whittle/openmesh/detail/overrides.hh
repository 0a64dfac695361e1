#pragma once

#include <concepts>

namespace whittle {

template <class MeshT>
class PlacingModuleT;
template <class MeshT>
class ModGarlandHeckbertT;

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
}  // namespace whittle
