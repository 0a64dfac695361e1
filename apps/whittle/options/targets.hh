#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "options/values.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// The title of these options in the help.
inline constexpr char target_group[] = "Targets (at least one; the first reached stops)";

/// How far to simplify. At least one target is required; the first one reached stops the run.
struct TargetOptions {
  std::optional<std::uint64_t> faces;      ///< at least 1
  std::optional<std::uint64_t> vertices;   ///< at least 1
  std::optional<double> ratio;             ///< share of the vertices to keep, (0, 1)
  std::optional<double> face_ratio;        ///< share of the faces to keep, (0, 1)
  std::optional<double> max_cost;          ///< at least 0; in the unit of the cost (`Cost`), by model units
  std::optional<Length> max_error;         ///< above 0
  std::optional<Length> max_border_error;  ///< above 0; as `max_error` if not set
  std::optional<std::string> tolerances;   ///< file with the tolerance of each vertex
};
/// \param cost_unit what the help says of the unit of --max-cost
void add_target_options(CLI::App& app, TargetOptions& options, const std::string& cost_unit);

/// Adds an option with a length E above 0; without it there is none.
/// \param names as `add_value`
CLI::Option* add_length_above_zero(CLI::App& app, const std::string& names, std::optional<Length>& length,
                                   const std::string& description);

/// Adds `--max-error`, `--max-error-borders` and `--tolerance-map`.
void add_max_error(CLI::App& app, TargetOptions& options);

/// \param all how the targets that there are are named in the message
/// \throw UsageError without any target.
void check_targets(const TargetOptions& options, const std::string& all);

/// The targets for a mesh with these counts. With both --vertices and --ratio the greater number counts: it is reached
/// first. So it is with --faces and --face-ratio.
/// \param diagonal of the mesh's bounding box
DecimateTarget resolve(const TargetOptions& options, std::uint64_t n_vertices, std::uint64_t n_faces, double diagonal);

/// Whether the target is met: a number of faces or vertices that was asked for is reached, whatever else ended the run.
/// Without such a number a run has met it where it ended.
bool is_met(const DecimateTarget& target, StopReason stop);

/// The limits of faces and vertices alone.
DecimateTarget counts_of(const DecimateTarget& target);

/// The option whose limit ended a run; empty if none did.
std::string_view option_that_ended(StopReason stop);

/// "5120 faces or 2560 vertices or cost 0.001 or error 0.1"
std::string to_string(const DecimateTarget& target);

/// Key `target` of the reports, without `met`: those of "faces", "vertices", "ratio", "face_ratio", "max_cost",
/// "max_error", "max_error_borders",
/// "tolerance_map" that are set.
nlohmann::ordered_json target_json(const TargetOptions& options, const DecimateTarget& target);

}  // namespace whittle::app
