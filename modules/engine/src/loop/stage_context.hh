#pragma once

#include <optional>
#include <span>

#include "complex/areas_of_faces.hh"
#include "loop/contraction_log.hh"
#include "whittle/engine/host.hh"

namespace whittle {

class ErrorBound;

/// Which contractions a loop makes, if it has a part of the mesh.
enum class Role {
  alone,          ///< those that it would make if there were no other parts
  in_exact_order  ///< those of them that one loop for the whole mesh would make, too. For costs that only rise
};

/// What guards of a stage keep, besides what options say.
struct StageLimits {
  std::optional<double> displacement{};      ///< of the surface by one contraction, in the frame
  std::span<const double> displacements{};   ///< if there is one: of each vertex, in its place; or empty
  const ErrorBound* error_bound = nullptr;   ///< with supports among the faces that the stage begins with
  const ErrorBound* border_bound = nullptr;  ///< with supports among their border edges
};

/// What a stage works with, besides its surface. What it points to must outlive the stage.
struct StageContext {
  const DecimateOptions& options;
  Frame frame{};  ///< of the model, in whose units costs and contractions are told
  DecimationHost* host = nullptr;
  StageLimits limits{};
  Role role = Role::alone;
  double feature_tolerance = 0;            ///< in the frame
  std::span<const std::uint8_t> locked{};  ///< per vertex, or empty
  std::span<const std::uint8_t> frozen{};  ///< per vertex, or empty: those that take part in no contraction
  AreasOfFaces areas{};
  bool keeps_steps = false;       ///< whether the report has them
  ContractionLog* log = nullptr;  ///< gets each contraction, by the surface's vertices and in the frame; or null
};

}  // namespace whittle
