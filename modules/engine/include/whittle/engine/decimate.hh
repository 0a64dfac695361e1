#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/decimate_target.hh"
#include "whittle/engine/formula/quadric.hh"
#include "whittle/engine/options.hh"
#include "whittle/engine/refusals.hh"

// Decimation of an indexed triangle mesh by contracting vertex pairs in order of cost:
//
//   for each vertex v: Q_v = the quadric of its faces and border edges
//   queue every pair (edge) under the least cost it can ever have
//   while no target is reached:
//     take the pair of least cost; ties by (lower, higher) original vertex number
//     if a guard refuses it: count the reason; the pair waits until something the guard looked at changes
//     else contract: the vertex of the higher original number survives, moves to v̄ and takes Q₀ + Q₁
//       (a locked vertex survives in any case; under Placement::endpoint the one that lies at v̄ does)
//
// The order is exact, that of an algorithm which evaluates every pair again after each contraction, unless `Order` says
// otherwise. Costs other than Garland–Heckbert's keep other things than Q.

namespace whittle {

enum class StopReason {
  target,     ///< A count was reached.
  cost,       ///< Every contraction left costs more than `max_cost`.
  error,      ///< Guards refuse every contraction left, some because of `max_error`.
  exhausted,  ///< Guards refuse every contraction left, or none is left.
  cancelled   ///< The progress callback said so.
};
/// "target", "cost", "error", "exhausted", "cancelled".
std::string_view to_string(StopReason reason);

/// Pairs beside the edges.
struct ThresholdPairCounts {
  std::uint64_t considered = 0;  ///< at the start
  std::uint64_t contracted = 0;
  double threshold = 0;  ///< as asked for, model units; 0 if none was
  bool capped = false;   ///< whether `PairOptions::max_pairs` left some out

  ThresholdPairCounts& operator+=(const ThresholdPairCounts& other);
};

/// How a surface hangs together.
struct SurfaceCounts {
  std::uint64_t components = 0;            ///< sets of faces connected over vertices
  std::uint64_t nonmanifold_edges = 0;     ///< with three faces or more
  std::uint64_t nonmanifold_vertices = 0;  ///< whose faces, connected over edges at it, are two sets or more

  SurfaceCounts& operator+=(const SurfaceCounts& other);
};

/// What a caller should know of a run that did what was asked.
enum class WarningKind {
  pairs_capped  ///< `PairOptions::max_pairs` left some threshold pairs out.
};
struct Warning {
  WarningKind kind;
  std::string text;  ///< one sentence, without a full stop
};

/// What a run did. Counts are those of the mesh after it; vertices without a face don't count.
struct DecimateResult {
  std::uint64_t n_contractions = 0;
  std::uint64_t n_vertices = 0;
  std::uint64_t n_faces = 0;
  double max_cost = 0;  ///< greatest cost of a contraction made; unit as `DecimateTarget::max_cost`
  /// Model units: each point of the mesh is proven to be within it of the input, and each point of the input of the
  /// mesh. `max_error`, if that was asked for; empty if it wasn't, or if the run was cancelled.
  std::optional<double> proven_error{};
  StopReason stop = StopReason::exhausted;
  /// Why it took one pass over the whole mesh, and no blocks (docs/dev/blocks.md); empty if it went in blocks. It
  /// depends on the number of threads: with one, plain quadrics take one pass. So may a count of refusals, where costs
  /// are equal up to rounding. The mesh doesn't.
  std::string_view why_in_one_pass;
  RefusalCounts refusals;  ///< of guards; a pair refused, woken and refused again counts twice
  /// What stands in the way of going on, if `stop` is `exhausted`: the pairs that are left, each once.
  RefusalCounts refused_at_end;
  std::uint64_t n_degenerate_faces = 0;  ///< faces of the input with two equal corners, left out from the start
  std::uint64_t n_coincident_faces = 0;  ///< vanished where joining vertices laid them on others
  ThresholdPairCounts threshold_pairs;
  SurfaceCounts before;  ///< the input's surface
  SurfaceCounts after;
  std::uint64_t n_vanished_components = 0;  ///< of the input, those of which nothing is left
  std::vector<Warning> warnings;            ///< a kind at most once

  /// Adds a run of another part. Counts are sums, `max_cost` and `stop` are the greatest: `stop` is that of a part that
  /// missed its target, if there is one. `proven_error` stays as it is.
  DecimateResult& operator+=(const DecimateResult& other);
};

/// The decimated mesh and where the input's vertices went.
struct Decimation {
  /// Vertices by ascending origin, faces in the input's order; unmoved vertices keep every bit. Under
  /// Placement::endpoint each vertex has the position of its origin.
  IndexedMesh mesh;
  DecimateResult result;
  /// Those of the vertices of `mesh`, in the frame of the input's bounding box, if asked for: to go on from.
  std::vector<PlacedQuadric> quadrics;
  std::vector<Index> face_origins;  ///< faces of `mesh` → faces of the input, ascending
  /// Of `mesh`: what has become of the input's, and of its seams if these hold their vertices
  /// (`DecimateOptions::holds_seams`); lower vertex first, ascending.
  std::vector<VertexPair> feature_edges;
  std::vector<Index> vertex_map;  ///< input vertices → vertices of `mesh`; `invalid_index` where it was in no face
  RunSteps steps;                 ///< if asked for
  /// What stands in the way of going on, if `result.stop` is `exhausted` or `error`: the pairs of
  /// `result.refused_at_end`, by vertex of `mesh`.
  std::vector<RefusedPair> refused_pairs;
};

/// Decimates `mesh`, with all its attributes (`carry_attributes`). Seams (`seam_edges`) stay closed, and where
/// `DecimateOptions::seams` says. Works on any triangle set. Results don't depend on the unit, on where the mesh lies,
/// or on the number of threads.
///
/// \throw std::invalid_argument for a face number out of range, a coordinate that isn't finite or is above 3e150, an
///        attribute of a wrong length, one that is not finite (scalars and categories may be NaN), an option out of its
///        range, an option that the cost doesn't take (`CostTraits`), `locked` or `tolerances` of another length than
///        the vertices, or feature edges of vertices that aren't there.
/// \throw std::length_error for more than 2³¹ faces or 2³² − 2 vertices, for more than 2³² − 2 edges and threshold
///        pairs together, and with `feature_angle_deg` for 2³² / 3 faces or more.
Decimation decimate(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options = {});

/// Whether `decimate` makes most contractions in blocks, on all threads: so it does with memoryless quadrics on meshes
/// of 20,000 faces and more, or of 140,000 if contractions are told, unless something needs one pass over the whole
/// (docs/dev/blocks.md).
bool goes_in_blocks(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options);

/// Fewer faces on the input's own vertices.
struct IndexOnlyDecimation {
  std::vector<Triangle> faces;  ///< by the *input's* vertices, in the order of the input's faces
  DecimateResult result;
  std::vector<Index> face_origins;  ///< `faces` → faces of the input, ascending
  std::vector<Index> vertex_map;  ///< input vertices → those that stand for them; `invalid_index` where it was in no
                                  ///< face
};

/// Decimates to faces over a subset of the input's vertices, which stay where they are: the positions and all other
/// attributes of vertices can be used as they are.
/// \param options with `Placement::endpoint`, whatever `options.quadric.placement` says
/// \throw as `decimate`; std::invalid_argument for a cost with a placement of its own
IndexOnlyDecimation decimate_index_only(const IndexedMesh& mesh, const DecimateTarget& target,
                                        const DecimateOptions& options = {});

}  // namespace whittle
