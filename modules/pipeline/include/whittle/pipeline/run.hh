#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "whittle/metrics/certify.hh"
#include "whittle/pipeline/plan.hh"

namespace whittle {

/// The largest distances, both ways, of all points between a scene and the file that a result is to be written to: as
/// the file is read again, with rounded coordinates.
struct DistancesAsWritten {
  IndexedMesh written;            ///< the file
  std::vector<Index> vertex_map;  ///< vertices of the scene → those of the file, if it has as many as the result
  metrics::LargestDistances surface;
  std::optional<metrics::LargestDistances> borders;  ///< none if neither has open borders
};
/// The greater of both, as far as it is proven.
double proven_distance(const metrics::LargestDistances& largest);

/// What the scene has and the result hasn't.
struct Vanished {
  std::vector<std::string> regions;  ///< materials, groups and the like: "material red", "g wheel", "label 7"
  std::size_t n_charts = 0;          ///< areas between seams, in regions that are left
};

/// Which option gets nearer to a target that was missed. What is said of it was tried: on the input, or from the result
/// on if the input is large.
struct Advice {
  std::vector<std::string> reaching;   ///< options, each of which reaches the target
  std::string nearest;                 ///< if none does: the one that gets furthest; empty if none gets further
  std::optional<std::size_t> n_faces;  ///< that `nearest` leaves; none if that was not tried, as the mesh is large
  bool has_options = false;            ///< whether an option lifts one of the reasons

  /// Whether `to_string` names the option.
  bool names(std::string_view option) const;
};
/// "'--topology free' reaches it"
std::string to_string(const Advice& advice);

/// Why a count was missed, and what helps.
struct Shortfall {
  std::vector<std::string> meshes_above;  ///< with targets per mesh: those that have more than theirs
  std::string_view ended_by;              ///< the option whose limit ended the run; or empty
  std::optional<Advice> advice;           ///< none with targets per mesh, or where no pair is left
};

enum class RunWarningKind {
  no_triangles,
  decimation,          ///< of `DecimateResult::warnings`
  nothing_contracted,  ///< within a limit of the error
  vanished,            ///< regions, or charts
  folded_texture,
  three_edges,       ///< vertices with three edges, though valences are penalized
  border_gaps,       ///< that `SceneReadOptions::weld_tolerance` would weld
  new_intersections  ///< that the input doesn't have
};
struct RunWarning {
  RunWarningKind kind;
  std::string text;  ///< a line, with the name of the scene in front
};

struct RunSeconds {
  double decimate = 0;
  double polish = 0;
  double certify = 0;
};

/// What a run has done.
struct Outcome {
  Simplification simplified;
  bool met = false;                                   ///< whether the target is met (`is_met`)
  std::optional<Shortfall> shortfall;                 ///< if it isn't
  std::optional<DistancesAsWritten> distances;        ///< if they are to be proven
  std::string certificate;                            ///< if it is wanted
  std::optional<std::size_t> n_intersections_before;  ///< pairs of faces, if they were counted
  std::optional<std::size_t> n_intersections_after;
  Vanished vanished;
  std::vector<RunWarning> warnings;
  RunSeconds seconds;
};

/// "12 by topology, 3 by turning a face": the most frequent reason first; empty if there is none.
std::string reasons_at_end(const RefusalCounts& refused);

/// "refused: 12 by topology, 3 by turning a face, 0 locked"
std::string refusals_text(const Plan& plan, const RefusalCounts& refused);
/// "in.ply: target not met: 100 faces asked, …": a line. \pre it is not met
std::string shortfall_text(const Plan& plan, const Outcome& outcome);
/// A sentence for regions, and one for charts, if there are any; without full stops.
std::vector<std::string> texts_of(const Vanished& vanished);

/// All warnings of a scene, a plan and its outcome, in the order in which they came up: a line each.
std::vector<std::string> all_warnings(const Plan& plan, const Outcome& outcome);

/// Simplifies a scene, and proves what is asked. A scene without faces stays as it is.
/// \throw Cancelled if the observer ends it
/// \throw std::runtime_error if a limit of the error can't be kept, not even by the scene as it is, or the steps of the
/// proof aren't found
Outcome run(const Plan& plan, const RunObserver& observer = {});

}  // namespace whittle
