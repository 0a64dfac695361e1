#pragma once

#include <optional>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/polish/polish.hh"

// What `whittle simplify` does, in one call: decimation by the cost that an effort stands for, then polish, which fits
// the result to the input.

namespace whittle {

/// How much time accuracy may take. Figures: docs/user/simplify.md.
enum class Effort {
  fast,    ///< no polish; plain quadrics, or memoryless ones where these go in blocks (`goes_in_blocks`)
  normal,  ///< memoryless quadrics, a pass of polish at 1.1 times the count and one at the end
  best  ///< memoryless quadrics, two passes of polish each at 1.2, 1.1 and 1.03 times the count and at the end; those
        ///< at the end also flip edges
};

struct SimplifyOptions {
  /// An empty `cost` is by effort; plain quadrics where another option needs them (`with_effort`). `progress` is asked
  /// during polish, too. `locked` vertices also stay in polish. `keep_quadrics`
  /// gives those before polish.
  DecimateOptions decimate{};

  /// At most so many passes of polish, at each pause and at the end; one that doesn't help is taken back and ends them.
  /// 0 = no polish. Empty = by effort, and two at least with `Fit::max`; none where the placement isn't optimal, as
  /// polish would move the vertices from there.
  std::optional<unsigned> polish_passes{};

  Fit fit = Fit::balanced;  ///< which distance polish brings down

  /// Whether polish at the end also flips edges. Empty = by effort. Not with a limit of the error.
  std::optional<bool> flips{};

  /// Where decimation pauses for polish on its way to a count: multiples of that count, each above 1,
  /// descending. What is contracted after a pause fits the input already, so the result comes nearer to it. Empty = by
  /// effort, none with `Placement::endpoint`; there are no pauses without polish, with a limit of the error, and where
  /// `decimate` has pauses of the caller's own. `Simplification::polish` is the polish at the end.
  std::optional<std::vector<double>> pauses{};

  /// Whether plain quadrics are tried, too, where the mesh is small (20,000 faces at most), or where much of it is
  /// flat, so that the result may be nearly exact (100,000 faces at most). There is no trial with a limit of cost or
  /// error. The result that is nearer to the input is taken. Takes two to three times as long there. Cancelled in the
  /// second run, `simplify` gives the first one's result. Empty = if the cost is by effort, and memoryless, and there
  /// are no callbacks of the caller's that a second run would call anew (a listener, pauses of `decimate`).
  std::optional<bool> tries_plain_quadrics{};
};

/// Fills in what is empty in `options` and depends on the effort: cost, passes, flips, pauses, trial. `simplify` does
/// this.
SimplifyOptions with_effort(Effort effort, SimplifyOptions options, const IndexedMesh& mesh,
                            const DecimateTarget& target);
/// The same for a mesh that doesn't go in blocks.
SimplifyOptions with_effort(Effort effort, SimplifyOptions options);

/// A decimation whose mesh is polished.
struct Simplification : Decimation {
  Cost cost = Cost::memoryless;  ///< that was used
  PolishResult polish;
  /// Faces that lie on a texture the other way round than the input does there (`fit_attributes`). Not counted without
  /// polish.
  std::size_t n_folded_texture_faces = 0;
  double decimate_seconds = 0;
  double polish_seconds = 0;
};

/// The second half of `simplify`: polishes a decimation of `original`, wherever it was made.
/// \pre `options` as `with_effort` gives them
PolishResult polish_decimation(const IndexedMesh& original, const SimplifyOptions& options, Decimation& decimation);

/// Simplifies `mesh`. Unless there is no polish, attributes are fitted to those of `mesh` in the end
/// (`fit_attributes`): so are normals with `Normals::keep`. A run that is cancelled while contracting is not polished.
/// \throw as `decimate`
Simplification simplify(const IndexedMesh& mesh, const DecimateTarget& target, Effort effort = Effort::normal,
                        const SimplifyOptions& options = {});

/// Levels of detail out of one run, each polished as the effort says; the run goes on from the polished surface. No
/// trial of plain quadrics is made.
/// \param targets a count each, all of faces or all of vertices, descending
/// \return a level a target, in their order; fewer if no pair is left to contract, or if the run is cancelled. The
///         last one says why it stopped, and has the time of all
/// \throw as `simplify`; std::invalid_argument for other targets, for one that the mesh has reached, and for pauses
std::vector<Simplification> simplify_to_levels(const IndexedMesh& mesh, const std::vector<DecimateTarget>& targets,
                                               Effort effort = Effort::normal, const SimplifyOptions& options = {});

}  // namespace whittle
