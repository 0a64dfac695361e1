#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/regions.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/engine/cost_traits.hh"
#include "whittle/engine/formula/quadric_term.hh"
#include "whittle/engine/run_steps.hh"

namespace whittle {

/// What happens to edges with one face, and to their vertices.
enum class Boundary {
  weighted,  ///< Planes of weight `QuadricOptions::boundary_weight` hold them in place.
  locked,    ///< Border vertices neither move nor vanish.
  free       ///< Nothing holds them.
};

/// What an edge contraction may do to the topology. Threshold pairs join parts under all.
enum class Topology {
  keep,       ///< Nothing: it closes no tunnel, opens no hole, joins nothing, and no part vanishes.
  automatic,  ///< As `keep` on a mesh of one part, on one whose parts have less than four faces in the mean, and where
              ///< a tetrahedron for each part takes less than a 100th of the faces wanted. Else parts and thin sheets
              ///< may vanish, in the order of cost: faces that nothing covers afterwards cost their area times the
              ///< square of their length (`vanishing_cost`). A mesh that is a closed manifold stays one.
  free        ///< Anything but taking the last face: tunnels close, closed parts vanish. Faces that coincide then are
              ///< left out. What vanishes costs nothing more.
};

/// What happens to vertices on seams (`seam_edges`).
enum class Seams {
  weighted,  ///< Planes of weight `AttributeWeights::seam` hold them in place, where the cost is of quadrics alone;
             ///< else seams are kept (`DecimateOptions::holds_seams`).
  keep       ///< They go along their seam only; where seams meet or end they stay.
};

/// What becomes of the vertex normals of a mesh that has some.
enum class Normals {
  keep,       ///< Those of the input around where each vertex goes (`carry_attributes`); `simplify` then fits them.
  recompute,  ///< Those of the faces of the result, weighted by area. They break at creases (`recompute_normals`).
  drop        ///< The result has none.
};

/// Which vertices are pairs though no face joins them. \cite garland_1997_surface (section 3.2: valid pairs)
struct PairOptions {
  std::optional<double> threshold{};            ///< Those closer than this, model units. [0, inf]; empty = none.
  std::optional<std::uint32_t> max_pairs = 32;  ///< Only so many of each vertex, the nearest; a pair stays if it is
                                                ///< among those of either vertex. At least 1; empty = all.
  bool across_walls = false;  ///< Also those across the inside of a thin wall, whose normals face away.
};

/// What the library is doing.
enum class Stage {
  decimate,  ///< contracting pairs, and preparing that
  polish     ///< fitting the result to the input (`simplify` alone)
};

/// How far a run has come.
struct Progress {
  std::uint64_t n_vertices;  ///< left now
  std::uint64_t n_faces;     ///< left now
  double fraction;  ///< of the stage, [0, 1]; while contracting, of the way to the nearest count asked for, if one is
  Stage stage = Stage::decimate;
  /// Makes the surface as it is at this moment: positions and faces alone, model units, in any order. Empty where there
  /// is none. Only the callback may call it; it takes time in proportion to the surface, and changes no result. While
  /// blocks are contracted, it has what those leave that are done. It lacks the backs of two-sided sheets.
  std::function<IndexedMesh()> surface{};
};

/// How much attributes count in costs with quadrics (docs/dev/attributes.md), by kind: an error of one is a length,
/// times this, and counts as if the surface were so far off. [0, inf); 0 = not at all. Other kinds don't count.
struct AttributeWeights {
  double texcoord = 0.03;      ///< Of the way over which a texture changes by so much, in the mean.
  double normal = 1;           ///< Of 0.05 % of the root of the surface's area for a radian.
  double color = 1;            ///< Of 0.3 % of that root for the range of a component.
  double displacement = 0.3;   ///< Of what a morph target moves.
  double joint_weights = 0.1;  ///< Of the way between the centres of what joints move.
  double seam = 0.05;  ///< Of planes through seams (`seam_edges`), as `QuadricOptions::boundary_weight` is of borders.
};

struct Decimation;

/// Where a run pauses on its way to the counts of its target, and what is done there. It pauses the same way on any
/// number of threads.
struct Pauses {
  std::vector<double> at{};  ///< multiples of the target's counts, each above 1, descending
  /// May move vertices of the mesh, and flip edges: give faces other corners. No more may change. The mesh has its
  /// positions, faces and origins; vertex map, face origins and feature edges are filled in, too. Returns whether to go
  /// on; false cancels the run.
  std::function<bool(Decimation&)> adjust{};
};

/// Options own what they are given. An empty optional is off, or "by the cost" where the comment says so.
struct DecimateOptions {
  std::optional<Cost> cost{};      ///< Empty = quadric in `decimate`, by effort in `simplify`.
  QuadricOptions quadric{};        ///< Of the costs that have quadrics.
  double isotropy = 0;             ///< W of the blend of `Cost::quadric` with the edge's length (edge_length_term.hh).
                                   ///< [0, 1]
  double valence_weight = 0;       ///< W of the penalty for valences, times any cost (valence_term.hh). [0, inf)
  Order order = Order::automatic;  ///< Automatic = by the cost.
  PairOptions pairs{};
  Topology topology = Topology::keep;
  Boundary boundary = Boundary::weighted;
  /// Whether costs of quadrics hold the fold edges of two-sided sheets as weighted borders are held: edges whose two
  /// faces lie on each other, front and back, as around a leaf. Empty: no, but `simplify` does. OpenMesh's decimaters
  /// never do.
  std::optional<bool> hold_folds{};

  /// A contraction that turns the normal of a remaining face further than this is refused, degrees. (0, 180]; at 180
  /// only a face that loses its area is refused. Empty = by the cost: `CostTraits::default_max_normal_flip_deg`.
  std::optional<double> max_normal_flip_deg{};

  /// A contraction that leaves a face with a smaller radius ratio (radius_ratio.hh) is refused, unless the face was
  /// thinner before. [0, 1]; empty = off.
  std::optional<double> min_radius_ratio{};

  /// Whether a contraction is refused that would make faces intersect that didn't before. Faces of one part count like
  /// those of different parts. Faces with a common edge are not compared.
  bool refuse_intersections = false;

  /// V or empty; vertices with a non-zero entry neither move nor vanish. Their other neighbours may merge into them.
  std::vector<std::uint8_t> locked{};

  /// V or empty; with `DecimateTarget::max_error`: how far the surface may be from the input at each vertex, model
  /// units. (0, inf]. Each point of a face of the input is within the least tolerance of its corners of the result, and
  /// each point of the result within that of some face of the input, and within `max_error` in any case.
  std::vector<double> tolerances{};

  /// Edges of two faces whose normals differ by more than this are sharp, and features, degrees. (0, 180]; empty = no
  /// edges are. Vertices on a line of feature edges move along it only; where lines meet, end, or turn further than
  /// this, they stay. Feature edges stay sharp, and no others get so.
  std::optional<double> feature_angle_deg{};

  /// How far a feature line may come to lie from where it was, of the diagonal of the input's bounding box. [0, inf]
  double feature_tolerance = 5e-4;

  /// Edges that are features whatever their angle. Other pairs of vertices of the mesh don't count.
  std::vector<VertexPair> feature_edges{};

  Seams seams = Seams::weighted;
  /// Which face attributes name regions, whose borders are seams. Groups do in any case. A name that no attribute has
  /// names none. Empty = those that name things by themselves (`names_regions`).
  RegionNames regions{};
  Normals normals = Normals::keep;

  /// With `Normals::recompute`: edges whose faces turn by this angle or more are creases, where normals break, degrees.
  /// (0, 180]; 180: each vertex has one normal.
  double crease_angle_deg = default_crease_angle_deg;

  /// With weights by area alone (`QuadricOptions::weights`), and without `isotropy`; other costs look at positions.
  AttributeWeights attribute_weights{};

  /// Whether `Decimation::quadrics` is wanted.
  bool keep_quadrics = false;

  /// Whether `Decimation::steps` is wanted.
  bool keep_steps = false;

  /// Threads to use, 0 = all cores. No result depends on it.
  unsigned threads = 0;

  /// Called now and then from the calling thread; false ends the run with what is reached.
  std::function<bool(const Progress&)> progress{};

  /// Called after each contraction, in order. Not told of what is done in `pauses`. With a limit of the error it is
  /// called at the end, as contractions may be taken back.
  std::function<void(const Contraction&)> listener{};

  /// Only with a count as target, and without a limit of the error. Not with `Placement::endpoint`, and not with a
  /// host.
  Pauses pauses{};

  // What the fields above come to in `decimate` where they are empty.
  Cost effective_cost() const { return cost.value_or(Cost::quadric); }
  /// Whether vertices on seams go along them only: with `Seams::keep`, with costs without quadrics, and with a share of
  /// `isotropy`, which knows of no seams.
  bool holds_seams() const {
    return seams == Seams::keep || !cost_traits(effective_cost()).has_quadrics || isotropy > 0;
  }
  Order effective_order() const {
    return order == Order::automatic ? cost_traits(effective_cost()).default_order : order;
  }
  double effective_max_normal_flip_deg() const {
    return max_normal_flip_deg.value_or(cost_traits(effective_cost()).default_max_normal_flip_deg);
  }
};

}  // namespace whittle
