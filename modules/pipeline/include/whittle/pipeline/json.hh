#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "whittle/metrics/distance.hh"
#include "whittle/metrics/line_distance.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/metrics/topology.hh"
#include "whittle/pipeline/run.hh"

// The JSON reports: schema 1. Keys are never renamed nor removed within a schema; more may be added. docs/user has
// them.

namespace whittle {

using Json = nlohmann::ordered_json;

/// {"schema": 1, "program": "whittle 0.1.0"}
Json new_report();

/// The values of options, by the keys of their rows.
Json options_json(const OptionRows& rows);

/// Key `repairs`: a count for each kind of repair.
Json repairs_json(const io::Repairs& repairs);

/// Adds "manifold", "closed", "components", "boundary_loops", "genus", "nonmanifold_edges", "nonmanifold_vertices".
void add_topology(Json& json, const metrics::Topology& topology);

/// Adds "mean", "rms", "max", "garland_heckbert", each with "…_rel", "forward", "backward", "normal_deviation_deg",
/// "flipped_percent".
void add_distance(Json& json, const metrics::SurfaceDistance& distance);

/// Adds a length, and as `…_rel` its share of the diagonal; null if that is 0.
void add_length(Json& json, const std::string& key, double length, double diagonal);

/// {"at_least", "at_most", each with "…_rel", "point", "face"}
Json largest_json(const metrics::LargestDistance& largest, double diagonal);

/// {"mean", "max", each with "…_rel", "forward", "backward"}; null if there is no distance.
Json lines_json(const std::optional<metrics::LineDistance>& distance, double diagonal);

/// Adds "radius_ratio", "min_angle_deg", "valence", "edge_length_cv", "folds", "degenerate_faces".
void add_shape(Json& json, const metrics::Shape& shape);

/// {"passes", "moved", "rms_before", "rms_after"}
Json polish_json(const PolishResult& polish);

/// {"path", "vertices", "faces", "diagonal", "repairs"}
Json input_json(const Scene& input, double diagonal);

/// Key `target` of the reports, without `met`: "faces", "vertices", "ratio", "face_ratio", "max_cost", "max_error" and
/// "max_error_borders", if set.
Json target_json(const Targets& targets, const DecimateTarget& target);

/// Key `max_error`, without `certificate_bytes`.
Json max_error_json(const DistancesAsWritten& distances, const DecimateTarget& target, double diagonal);

/// What is reported of a run, but for its files and times. \param options key `options`
Json run_json(const Plan& plan, const Outcome& outcome, Json options);

}  // namespace whittle
