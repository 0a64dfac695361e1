#pragma once

#include <cstdint>
#include <optional>

#include "whittle/engine/decimate.hh"
#include "whittle/pipeline/option.hh"

namespace whittle {

/// Targets of a simplification, before the mesh is read. At least one is needed; the first one reached stops.
struct Targets {
  std::optional<std::uint64_t> faces;      ///< at least 1
  std::optional<std::uint64_t> vertices;   ///< at least 1
  std::optional<double> ratio;             ///< share of the vertices to keep, (0, 1)
  std::optional<double> face_ratio;        ///< share of the faces to keep, (0, 1)
  std::optional<double> max_cost;          ///< at least 0; in the unit of the cost (`Cost`), by model units
  std::optional<Length> max_error;         ///< above 0
  std::optional<Length> max_border_error;  ///< above 0; default: `max_error`

  bool has_count() const { return faces || vertices || ratio || face_ratio; }
  bool any() const { return has_count() || max_cost || max_error; }
};

/// The title of these options in help.
inline constexpr char target_group[] = "Targets (at least one; the first reached stops)";

/// Options for faces, vertices, shares of both, and the largest cost. \param cost_unit a clause on the unit of costs
OptionRows target_rows(Targets& targets, const std::string& cost_unit);
/// Options for the largest error, and for the largest error between borders.
OptionRows error_rows(Targets& targets);

/// The targets for a mesh with these counts. With both `vertices` and `ratio` the larger number counts, as it is
/// reached first; the same for `faces` and `face_ratio`.
/// \param diagonal of the mesh's bounding box
DecimateTarget resolve(const Targets& targets, std::uint64_t n_vertices, std::uint64_t n_faces, double diagonal);

/// Whether a run met its target: it reached the requested number of faces or vertices. Without such a number every run
/// does.
bool is_met(const DecimateTarget& target, StopReason stop);

/// The target with limits of faces and vertices alone.
DecimateTarget counts_of(const DecimateTarget& target);

/// "5120 faces or 2560 vertices or cost 0.001 or error 0.1"
std::string to_string(const DecimateTarget& target);

/// The option whose limit ended a run, or empty.
std::string_view option_that_ended(StopReason stop);

}  // namespace whittle
