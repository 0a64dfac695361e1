#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/quadric_term.hh"
#include "whittle/engine/threshold_pairs.hh"

// Decimation of an indexed triangle mesh by contracting vertex pairs in order of cost:
//
//   for each vertex v: Q_v = the quadric of its faces and border edges
//   queue every pair (edge) under the least cost it can ever have
//   while no target is reached:
//     take the pair of least cost; ties by (lower, higher) original vertex number
//     if a guard refuses it: count the reason, let it wait until something it looked at changes
//     else contract: the vertex of the higher original number survives, moves to v̄ and takes Q₀ + Q₁
//       (a locked vertex survives in any case)
//
// The order is exact, that of an algorithm which re-evaluates every pair after each contraction, unless `Order` says
// otherwise. Costs other than Garland–Heckbert's keep other things than Q.

namespace whittle {

/// What ends a run: the first one reached. Unset ones don't count; none set reduces as far as the guards allow.
struct DecimateTarget {
  std::optional<std::uint64_t> faces{};     ///< Stop once at most this many faces are left.
  std::optional<std::uint64_t> vertices{};  ///< Stop once at most this many vertices are left.
  std::optional<double> max_cost{};  ///< Contract only what costs at most this, in the unit of the cost (`Cost`), by
                                     ///< model units. [0, inf).
};

/// What ranks and places contractions.
enum class Cost {
  quadric,     ///< Garland–Heckbert (quadric_term.hh): distance to all planes merged so far. Unit: distance² · area
               ///< (distance² with uniform weights)
  memoryless,  ///< quadrics of the faces as they are, the volume kept (memoryless_term.hh). Unit: length⁵
  lindstrom_turk,  ///< Lindstrom–Turk (lindstrom_turk.hh): change of volume against the faces as they are. Unit:
                   ///< length⁶
  midpoint         ///< the edge's length, to its middle. Unit: length
};

/// How far contractions may turn faces for a cost to do best, degrees: Lindstrom–Turk is more accurate where they may
/// turn them further, memoryless quadrics where they turn them less.
constexpr double best_max_normal_flip_deg(Cost cost) {
  switch (cost) {
    case Cost::lindstrom_turk:
      return 110;
    case Cost::memoryless:
      return 60;
    case Cost::quadric:
    case Cost::midpoint:
      break;
  }
  return 75;
}

/// In which order a cost that has no lower bounds is followed.
enum class Order {
  automatic,   ///< approximate for `Cost::memoryless`, else exact
  exact,       ///< that of an algorithm which evaluates every pair anew after each contraction
  approximate  ///< faster: a pair that gets cheaper than it was is noticed only when its old place is reached. When
               ///< that is differs a little between units that differ by no power of two
};

/// What happens to edges with one face, and to their vertices.
enum class Boundary {
  weighted,  ///< held in place by planes of weight `QuadricOptions::boundary_weight`
  locked,    ///< border vertices don't move by a bit, nor vanish
  free       ///< nothing holds them
};

/// What an edge contraction may do to the topology. Threshold pairs join parts under both.
enum class Topology {
  keep,  ///< nothing: it closes no tunnel, opens no hole, joins nothing, and no part vanishes
  free   ///< anything but taking the last face: tunnels close, closed parts vanish. What coincides then is left out.
};

/// Which vertices are pairs though no face joins them. \cite garland_1997_surface (section 3.2: valid pairs)
struct PairOptions {
  double threshold = 0;          ///< those closer than this, model units. [0, inf]; 0 = none
  std::uint32_t max_pairs = 32;  ///< only the so many nearest of a vertex; a pair stays if it is among those of either.
                                 ///< 0 = all
  bool across_walls = false;     ///< also those across the inside of a thin wall, their normals facing away
};

/// How far a run has come.
struct Progress {
  std::uint64_t n_vertices;  ///< left now
  std::uint64_t n_faces;     ///< left now
  double fraction;           ///< of the way to the nearest target, [0, 1]
};

/// One contraction, in the input's vertex numbers.
struct Contraction {
  Index survivor;
  Index removed;
  Vec3 position;  ///< of the survivor from now on, model units
  double cost;    ///< as `DecimateTarget::max_cost`
};

struct DecimateOptions {
  Cost cost = Cost::quadric;
  QuadricOptions quadric;  ///< of `Cost::quadric`; memoryless ones have weights by area
  double isotropy = 0;     ///< W of the blend of `Cost::quadric` with the edge's length (edge_length_term.hh). [0, 1]
  double valence_weight = 0;  ///< W of the penalty for valences, times any cost (valence_term.hh). [0, inf)
  Order order = Order::automatic;
  PairOptions pairs;
  Topology topology = Topology::keep;
  Boundary boundary = Boundary::weighted;

  /// A contraction that turns the normal of a remaining face further than this is refused, degrees. (0, 180]; 180 =
  /// off. What is best depends on the cost: `best_max_normal_flip_deg`.
  double max_normal_flip_deg = best_max_normal_flip_deg(Cost::quadric);

  /// A contraction that leaves a face with a smaller radius ratio (radius_ratio.hh) is refused, unless the face was
  /// thinner before. [0, 1]; 0 = off.
  double min_radius_ratio = 0;

  /// V or empty; vertices with a non-zero entry neither move nor vanish. Their other neighbours may merge into them.
  std::span<const std::uint8_t> locked;

  /// Edges of two faces whose normals differ by more than this are sharp, and features, degrees. (0, 180]; 180 = none.
  /// Vertices on a line of feature edges move along it only; where lines meet, end, or turn further than this, they
  /// stay. Feature edges stay sharp, and no others get so.
  double feature_angle_deg = 180;

  /// How far a feature line may come to lie from what it was, of the diagonal of the input's bounding box. [0, inf]
  double feature_tolerance = 5e-4;

  /// Edges that are features whatever their angle; what is no edge of the mesh doesn't count.
  std::span<const VertexPair> feature_edges;

  /// Whether `Decimation::quadrics` is wanted.
  bool keep_quadrics = false;

  /// Threads to use, 0 = all cores. No result depends on it.
  unsigned threads = 0;

  /// Called now and then from the calling thread; false ends the run with what is reached.
  std::function<bool(const Progress&)> progress;

  /// Called after each contraction, in order.
  std::function<void(const Contraction&)> listener;
};

enum class StopReason {
  target,     ///< a count was reached
  cost,       ///< every contraction left costs more than `max_cost`
  exhausted,  ///< every contraction left is refused by a guard, or none is left
  cancelled   ///< the progress callback said so
};
/// "target", "cost", "exhausted", "cancelled".
std::string_view to_string(StopReason reason);

/// Why guards refused contractions. A pair refused, woken and refused again counts twice.
struct Rejections {
  std::uint64_t link = 0;     ///< it would change the topology (link condition)
  std::uint64_t flip = 0;     ///< it would turn a face over, or make one without area
  std::uint64_t shape = 0;    ///< it would make a face thinner than allowed
  std::uint64_t feature = 0;  ///< it would take a vertex off its feature line, or a line away
  std::uint64_t locked = 0;   ///< both vertices are locked
};

/// Pairs beside the edges.
struct ThresholdPairCounts {
  std::uint64_t considered = 0;  ///< at the start
  std::uint64_t contracted = 0;
  double threshold = 0;  ///< as asked for, model units
  bool capped = false;   ///< whether `PairOptions::max_pairs` left some out
};

/// How a surface hangs together.
struct SurfaceCounts {
  std::uint64_t components = 0;            ///< sets of faces connected over vertices
  std::uint64_t nonmanifold_edges = 0;     ///< with three faces or more
  std::uint64_t nonmanifold_vertices = 0;  ///< whose faces, connected over edges at it, are two sets or more
};

/// What a run did. Counts are those of the mesh after it; vertices without a face don't count.
struct DecimateResult {
  std::uint64_t n_contractions = 0;
  std::uint64_t n_vertices = 0;
  std::uint64_t n_faces = 0;
  double max_cost = 0;  ///< greatest cost of a contraction made; unit as `DecimateTarget::max_cost`
  StopReason stop = StopReason::exhausted;
  Rejections rejections;
  std::uint64_t n_degenerate_faces = 0;  ///< faces of the input with two equal corners, left out from the start
  std::uint64_t n_coincident_faces = 0;  ///< vanished where joining vertices laid them on others
  ThresholdPairCounts threshold_pairs;
  SurfaceCounts before;  ///< the input's surface
  SurfaceCounts after;
  std::uint64_t n_vanished_components = 0;  ///< of the input, those of which nothing is left
};

/// The decimated mesh and where the input's vertices went.
struct Decimation {
  IndexedMesh mesh;  ///< vertices by ascending origin, faces in the input's order; unmoved vertices keep every bit
  DecimateResult result;
  /// Those of the vertices of `mesh`, in the frame of the input's bounding box, if asked for: to go on from.
  std::vector<PlacedQuadric> quadrics;
  std::vector<Index> face_origins;        ///< faces of `mesh` → faces of the input, ascending
  std::vector<VertexPair> feature_edges;  ///< of `mesh`: what has become of the input's, lower vertex first, ascending
  std::vector<Index> vertex_map;  ///< input vertices → vertices of `mesh`; `invalid_index` where it was in no face
};

/// Decimates `mesh`. Colours are averaged over the vertices merged, normals computed anew where the input has them;
/// texture coordinates and groups are not carried.
/// Works on any triangle set. Results don't depend on the unit, on where the mesh lies, or on the number of threads.
/// \throw std::invalid_argument for a face number out of range, a coordinate that isn't finite, an option out of its
///        range, or `locked` of another length than the vertices.
/// \throw std::length_error for more than 2³¹ faces or 2³² − 2 edges.
Decimation decimate(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options = {});

}  // namespace whittle
