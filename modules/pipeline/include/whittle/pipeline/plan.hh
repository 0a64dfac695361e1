#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/engine/decimate_target.hh"
#include "whittle/pipeline/request.hh"
#include "whittle/scene/scene.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle {

/// How far a run has come.
struct RunProgress {
  std::string_view stage;                  ///< "decimating", "polishing", "certifying", "counting intersections"
  double fraction = 0;                     ///< of the stage, [0, 1]
  std::uint64_t n_faces = 0;               ///< that are left; 0 where the stage has none
  std::function<IndexedMesh()> surface{};  ///< as `Progress::surface`
};
/// What a run tells of the progress of `simplify`.
RunProgress run_progress(const Progress& progress);
/// Called now and then from the calling thread. Returns false to end the run, which then throws `Cancelled`.
using RunObserver = std::function<bool(const RunProgress&)>;

/// A request for a scene: all of it is settled.
struct Plan {
  Scene scene{};              ///< to be simplified: pruned, without what isn't kept
  Request request{};          ///< as it was made
  SimplifyOptions options{};  ///< settled: the cost, passes, flips, pauses, and all lengths
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  std::vector<DecimateTarget> targets_per_mesh{};  ///< with `Request::is_per_mesh`; `target` is their sum then
  double diagonal = 0;                             ///< of the scene's bounding box, before it was pruned; model units
  std::size_t n_pruned_parts = 0;
  std::optional<IndexedMesh> shown{};   ///< the scene of a document as it is shown, if proofs are about it
  double stretch = 1;                   ///< of lengths where the scene is shown (`widest_stretch`)
  std::vector<std::string> notes{};     ///< what was done with the scene: a line each, with its name in front
  std::vector<std::string> warnings{};  ///< likewise

  /// Of threshold pairs, model units; 0 = none.
  double threshold() const { return options.decimate.pairs.threshold.value_or(0); }
  unsigned threads() const { return request.reading.threads; }
  /// The surface that proofs are about.
  const IndexedMesh& proven_surface() const { return shown ? *shown : scene.read.mesh; }
  bool has_faces() const { return !scene.read.mesh.faces.empty(); }
};

/// What a request's options come to where no scene is known: cost, passes and flips by effort. For checks that come
/// before anything is read.
SimplifyOptions options_by_effort(const Request& request);

/// Settles a request for a scene. The one place where costs, targets and defaults are settled.
/// \throw UnsupportedMesh if nothing is left of the scene, or it has none of the attributes that the request names
/// \throw io::ReadError if the tolerance map can't be read, or isn't of the scene's file
Plan plan(Scene scene, const Request& request);

}  // namespace whittle
