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

/// What happens where faces come to intersect that didn't before.
enum class SelfIntersections {
  allow,  ///< a warning if parts are concerned
  count,  ///< also, all are counted before and after
  refuse  ///< also, contractions that would make them are refused
};

/// Decimates in place of `decimate`. It counts no refusals, and needs the cost to be settled.
using Decimater = std::function<Decimation(const Scene&, const DecimateTarget&, const DecimateOptions&)>;

/// What a run is asked for, before the mesh is known.
struct Request {
  Targets targets;
  Effort effort = Effort::normal;
  SimplifyOptions simplify;   ///< Fields that depend on the mesh are set when it is known.
  AutomaticLength threshold;  ///< Below which two vertices without an edge are a pair; automatic: from the distances
                              ///< between the parts of the mesh.
  Length feature_tolerance{5e-4, true};  ///< How far a feature line may come to lie from where it was.
  std::optional<Length> prune;           ///< Parts whose bounding box has a smaller diagonal are dropped.
  SelfIntersections self_intersections = SelfIntersections::allow;
  bool is_per_mesh = false;                  ///< Whether each mesh of a scene has the targets on its own.
  bool keeps_attributes = true;              ///< Or positions alone.
  CategoryNames categories;                  ///< Numbers of vertices that are never blended.
  bool certify = false;                      ///< Whether the largest distance is found without a limit, too.
  std::optional<std::string> tolerance_map;  ///< A file with how far the surface may be from each vertex, a line each.
  bool makes_certificate = false;            ///< Whether the steps of the proof are wanted.
  bool keeps_steps = false;                  ///< Whether `Decimation::steps` is wanted.

  /// The file that the result is written to. Proofs are of what is read again from there.
  SceneOutput output;
  SceneReadOptions reading;  ///< how the scene was read, and threads to use
  Decimater decimater{};     ///< in place of ours; or empty

  bool has_threshold() const { return threshold.is_automatic || threshold.length.value > 0; }
};

/// The options of a request: a row each, in the order of help.
OptionRows option_rows(Request& request);

/// Of commands that simplify with fewer options.
OptionRow effort_row(Effort& effort);
OptionRow fit_row(Fit& fit);

/// What help says of --effort.
extern const char effort_meaning[];
inline constexpr std::array<Choice<Effort>, 3> efforts{
    {{"fast", Effort::fast}, {"normal", Effort::normal}, {"best", Effort::best}}};

}  // namespace whittle
