#pragma once

#include <optional>
#include <span>

#include "complex/areas_of_faces.hh"
#include "loop/contraction_log.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/engine/decimate.hh"

namespace whittle {

class ErrorBound;

/// A pair that a guard refused.
struct GuardedPair {
  VertexPair pair;                ///< by number in the input of the pass that is told
  std::optional<Refusal> reason;  ///< that of the guard
};

/// Which contractions a loop makes, if it has a part of the mesh.
enum class Role {
  alone,          ///< those that it would make if there were no other parts
  in_exact_order  ///< those of them that one loop for the whole mesh would make, too. For costs that only rise
};

/// What a loop knows of those before and beside it.
struct LoopContext {
  Role role = Role::alone;
  std::span<const GuardedPair> refusals;       ///< that still hold, of passes before
  std::optional<double> displacement_limit{};  ///< of the surface by one contraction, in the frame
  std::span<const double>
      displacement_limits{};                 ///< if there is one: of each vertex of the pass, in its place; or empty
  const ErrorBound* error_bound = nullptr;   ///< with supports among the faces that the pass begins with
  const ErrorBound* border_bound = nullptr;  ///< with supports among their border edges
  AreasOfFaces areas{};
  ContractionLog* log = nullptr;  ///< gets each contraction, by the pass's vertices and in the frame; or null
};

}  // namespace whittle
