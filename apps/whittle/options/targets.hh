#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// The title of these options in the help.
inline constexpr char target_group[] = "Targets (at least one; the first reached stops)";

/// How far to simplify; at least one, the first reached stops.
struct TargetOptions {
  std::optional<std::uint64_t> faces;     ///< at least 1
  std::optional<std::uint64_t> vertices;  ///< at least 1
  std::optional<double> ratio;            ///< share of the vertices to keep, (0, 1)
  std::optional<double> max_cost;         ///< distance² · area in model units; at least 0
};
void add_target_options(CLI::App& app, TargetOptions& options);

/// \throw UsageError without any target.
void check_targets(const TargetOptions& options);

/// The targets for a mesh of `n_vertices`. Of --vertices and --ratio, the one reached first: the greater number.
DecimateTarget resolve(const TargetOptions& options, std::uint64_t n_vertices);

/// Whether what was asked for is reached. A cost limit is a target like the others when it stops the run; on its own it
/// asks for nothing beyond being kept.
bool is_met(const DecimateTarget& target, StopReason stop);

/// "5120 faces or 2560 vertices or cost 0.001"
std::string to_string(const DecimateTarget& target);

/// Key `target` of the reports, without `met`: "faces", "vertices", "ratio", "max_cost", those that are set.
nlohmann::ordered_json target_json(const TargetOptions& options, const DecimateTarget& target);

}  // namespace whittle::app
