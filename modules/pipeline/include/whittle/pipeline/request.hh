#pragma once

#include <functional>
#include <optional>
#include <string>

#include "whittle/core/attribute_kinds.hh"
#include "whittle/pipeline/option.hh"
#include "whittle/pipeline/targets.hh"
#include "whittle/scene/format.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle {

/// Treatment of new self-intersections.
enum class SelfIntersections {
  allow,  ///< warn if parts newly intersect
  count,  ///< also count all intersections before and after
  refuse  ///< also refuse contractions that make new ones
};

/// Decimates in place of `decimate`. It counts no refusals, and needs the cost to be settled.
using Decimater = std::function<Decimation(const Scene&, const DecimateTarget&, const DecimateOptions&)>;

/// The request for a run, before the mesh is read.
struct Request {
  Targets targets;
  Effort effort = Effort::normal;
  SimplifyOptions simplify;   ///< Fields that depend on the mesh are set after reading.
  AutomaticLength threshold;  ///< Vertices without an edge are a pair below this distance; automatic: from the
                              ///< distances between the parts of the mesh.
  Length feature_tolerance{5e-4, true};  ///< Largest distance of a feature line from its original.
  std::optional<Length> prune;           ///< Parts whose bounding box has a smaller diagonal are dropped.
  SelfIntersections self_intersections = SelfIntersections::allow;
  bool is_per_mesh = false;                  ///< Whether the targets are for each mesh of a scene.
  bool keeps_attributes = true;              ///< False: positions alone.
  CategoryNames categories;                  ///< Names of vertex attributes that are never blended.
  bool certify = false;                      ///< Whether to find the largest distance also without a limit.
  std::optional<std::string> tolerance_map;  ///< A file with the largest distance per vertex, a line each.
  bool makes_certificate = false;            ///< Whether to return the steps of the proof.
  bool keeps_steps = false;                  ///< Whether to return `Decimation::steps`.

  /// The file of the result. Proofs are about the mesh as read from there.
  SceneOutput output;
  SceneReadOptions reading;  ///< options with which the scene was read, and threads
  Decimater decimater{};     ///< replaces ours; or empty

  /// Whether the largest distance is to be proven.
  bool proves() const { return targets.max_error || certify || makes_certificate; }
  /// Whether proofs are about the file's own vertices and faces, of a document those of the scene as it is shown: with
  /// a certificate, and where glTF's `WriteOptions` round them.
  bool proves_file() const { return makes_certificate || (output.gltf.rounds() && proves()); }
  bool has_threshold() const { return threshold.is_automatic || threshold.length.value > 0; }
};

/// A row per option of a request, in the order of help.
OptionRows option_rows(Request& request);

/// Rows for commands that simplify with fewer options.
OptionRow effort_row(Effort& effort);
OptionRow fit_row(Fit& fit);

/// The help text of --effort.
extern const char effort_meaning[];
inline constexpr std::array<Choice<Effort>, 3> efforts{
    {{"fast", Effort::fast}, {"normal", Effort::normal}, {"best", Effort::best}}};

}  // namespace whittle
