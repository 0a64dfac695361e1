#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "files/input.hh"
#include "files/output.hh"
#include "options/command_line.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/metrics/certify.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/line_distance.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/metrics/topology.hh"
#include "whittle/polish/polish.hh"

// The JSON reports: schema 1. Keys are never renamed nor removed within a schema; more may be added.

namespace whittle::app {

using Json = nlohmann::ordered_json;

/// "whittle 0.1.0"
std::string program_and_version();

/// {"schema": 1, "program": …}
Json new_report();

/// JSON text with a line break at the end. Bytes that aren't UTF-8 (in file names) become U+FFFD.
std::string to_text(const Json& json);

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

/// "2 passes, 1234 vertices moved, rms distance 0.1 -> 0.09"
std::string polish_text(const PolishResult& polish);

/// {"path", "vertices", "faces", "diagonal", "repairs"}
Json input_json(const Scene& input, double diagonal);

/// If verbose, prints the run's time and peak memory.
void say_effort(const Talk& talk, double seconds);

/// The name in messages: the path, or "standard output".
std::string shown_output(const std::string& path);

/// Completes the files of a run (`OutputFiles::commit`), with the report where --json says.
/// \param json called if a report is wanted
/// \param text the same for people, printed unless the report goes to standard output
void commit_with_report(OutputFiles& files, const CommonOptions& options, const std::function<Json()>& json,
                        const std::string& text = {});
/// Likewise for a run without other files.
void write_report(const CommonOptions& options, const std::function<Json()>& json, const std::string& text = {});

}  // namespace whittle::app
