#pragma once

#include <optional>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/polish/polish.hh"

// Simplification in one call, as `whittle simplify` does it: decimation with a cost by effort, then polish, which fits
// the result to the input.

namespace whittle {

/// Time spent on accuracy. Figures: docs/user/simplify.md.
enum class Effort {
  fast,    ///< no polish; plain quadrics, or memoryless ones where these go in blocks (`goes_in_blocks`)
  normal,  ///< memoryless quadrics; one pass of polish at 1.1 times the count, one at the end
  /// Memoryless quadrics; two passes of polish each at 1.2, 1.1 and 1.03 times the count, and at the end. Passes at the
  /// end also flip edges.
  best
};

struct SimplifyOptions {
  /// An empty `cost` is by effort; plain quadrics if another option needs them (`with_effort`). `progress` is also
  /// called during polish. `locked` vertices also stay in polish. `keep_quadrics` returns the quadrics before polish.
  DecimateOptions decimate{.topology = Topology::automatic};

  /// Largest number of passes of polish, at each pause and at the end. A pass that doesn't reduce the error is undone,
  /// and is the last. 0 = no polish. Empty = by effort, at least two with `Fit::max`, none unless the placement is
  /// optimal: polish would move the vertices from their placement.
  std::optional<unsigned> polish_passes{};

  Fit fit = Fit::balanced;  ///< the distance that polish reduces

  /// Whether polish at the end also flips edges. Empty = by effort. Not with a limit of the error.
  std::optional<bool> flips{};

  /// Counts at which decimation pauses for polish: multiples of the target count, above 1, descending. After a pause
  /// decimation goes on with a surface that fits the input, so the result comes nearer to it. Empty = by effort, none
  /// with `Placement::endpoint`. There are no pauses without polish, without a count, with a limit of the error, or if
  /// `decimate` has pauses of its own. `Simplification::polish` is the polish at the end.
  std::optional<std::vector<double>> pauses{};

  /// Cost comparison: whether to run with plain quadrics, too, and take the result nearer to the input. It is done for
  /// small meshes (at most 20,000 faces) and mostly flat ones, whose result may be nearly exact (at most 100,000
  /// faces); never with a limit of cost or error. With two threads and more both runs go at once, each on half of them,
  /// and `progress` is that of the run with the cost given. With one thread it takes two to three times as long; if
  /// the second run is cancelled, `simplify` returns the first result. Empty = if the cost is by effort and
  /// memoryless, and no callback of the caller would be called again (a listener, pauses of `decimate`).
  std::optional<bool> tries_plain_quadrics{};
};

/// Fills in the empty options that depend on the effort: cost, passes, flips, pauses, cost comparison. Takes out those
/// that don't go with the target. `simplify` calls it.
SimplifyOptions with_effort(Effort effort, SimplifyOptions options, const IndexedMesh& mesh,
                            const DecimateTarget& target);
/// The same for a mesh that isn't simplified in blocks.
SimplifyOptions with_effort(Effort effort, SimplifyOptions options);

/// A decimation whose mesh is polished.
struct Simplification : Decimation {
  Cost cost = Cost::memoryless;  ///< the cost used
  PolishResult polish;
  /// Number of faces whose orientation on a texture differs from the input's there (`fit_attributes`). 0 without
  /// polish.
  std::size_t n_folded_texture_faces = 0;
  double decimate_seconds = 0;
  double polish_seconds = 0;
};

/// The second half of `simplify`: polishes a decimation of `original`. \pre `options` come from `with_effort`
PolishResult polish_decimation(const IndexedMesh& original, const SimplifyOptions& options, Decimation& decimation);

/// Fits the attributes of a result of `original` to those of `original` (`fit_attributes`), unless it has no polish or
/// is cancelled. \pre `options` come from `with_effort`
void fit_attributes_of(const IndexedMesh& original, const SimplifyOptions& options, Simplification& result);

/// Simplifies `mesh`. With polish, attributes are fitted to those of `mesh` in the end (`fit_attributes`), including
/// normals with `Normals::keep`. A run cancelled while contracting is not polished. \throw as `decimate`
Simplification simplify(const IndexedMesh& mesh, const DecimateTarget& target, Effort effort = Effort::normal,
                        const SimplifyOptions& options = {});

/// Levels of detail from one run, each polished by effort; the run goes on from the polished surface. Without cost
/// comparison.
/// \param targets counts, all of faces or all of vertices, descending; 0 is as far as possible
/// \return a level per target, in their order; fewer if no pair is left to contract, or if the run is cancelled. The
///        last level has the reason for the stop, and the time of all
/// \throw as `simplify`; std::invalid_argument for other targets, for a target that the mesh has reached, and for
///        pauses
std::vector<Simplification> simplify_to_levels(const IndexedMesh& mesh, const std::vector<DecimateTarget>& targets,
                                               Effort effort = Effort::normal, const SimplifyOptions& options = {});

}  // namespace whittle
