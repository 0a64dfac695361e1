#pragma once

#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "oracle/areas/brute_force_areas.hh"
#include "oracle/brute_force_attributes.hh"
#include "oracle/brute_force_constraints.hh"
#include "oracle/brute_force_costs.hh"
#include "oracle/brute_force_memoryless.hh"
#include "oracle/sides/brute_force_sides.hh"
#include "whittle/core/frame.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/formula/point_quadric.hh"

namespace whittle::test {

/// Decimation by its definition, one contraction after the other. It evaluates every edge of the current mesh, and
/// every threshold pair whose vertices share no face. Then it contracts the allowed pair with the least (cost, lower,
/// higher vertex number). It has no queue, no bounds and no memory of refusals. Topology, costs and feature lines are
/// evaluated from their definitions, the topology by links. Takes O(F²) or worse.
///
/// Shares with the engine only the frame and the arithmetic of one pair: `evaluate_pair`, `merged`, `with_points` and
/// the corresponding functions of other costs.
class BruteForceDecimater {
 public:
  BruteForceDecimater(const IndexedMesh& mesh, const DecimateOptions& options);

  /// Contracts until `target`, or until no pair is allowed. \return the contractions, positions in model units
  std::vector<Contraction> run(const DecimateTarget& target);

  /// With both sides of sheets.
  std::uint64_t n_faces() const;
  std::vector<Triangle> faces() const;  ///< of the current mesh, with both sides, in the input's numbers
  std::size_t n_threshold_pairs() const { return threshold_pairs_.size(); }
  std::uint64_t n_vertices() const;
  /// Of the current mesh, in the input's numbers, ascending.
  std::vector<std::pair<Index, Index>> feature_edges() const;

 private:
  struct Choice {
    double cost;
    Index low, high;
    bool is_edge;
    Vec3 cheapest;  ///< the position with that cost
    bool is_minimum;
    Vec3 position;  ///< position of the merged vertex: `cheapest`, or a better one

    bool is_before(const Choice& o) const { return std::tie(cost, low, high) < std::tie(o.cost, o.low, o.high); }
  };
  void find_threshold_pairs(const PairOptions& options);
  PlacedQuadric placed(Index v, bool is_edge) const;
  std::vector<Choice> choices() const;
  Choice choice(Index a, Index b, bool is_edge, const SurfaceNow& surface) const;
  void sum_planes(const QuadricOptions& options);
  PairEvaluation evaluate(Index a, Index b, bool is_edge, const SurfaceNow& surface) const;
  std::optional<Choice> next_choice() const;
  std::optional<Choice> resolve(Choice choice) const;
  bool is_nonmanifold(Index a, Index b, bool is_edge) const { return !is_edge || !keeps_topology(a, b); }
  bool forgets(const Choice& choice) const;
  bool is_allowed(const Choice& choice) const;
  bool keeps_topology(Index a, Index b) const;
  bool is_no_less_manifold(Index a, Index b) const;
  void settle_topology(std::size_t n_input_faces);
  bool opens_closed_manifold(Index a, Index b) const;
  double vanishing_cost(const Choice& choice) const;
  bool keeps_normals(const Triangle& face, Index v, const Vec3& to) const;
  bool keeps_shape(const Triangle& face, Index v, const Vec3& to) const;
  std::vector<bool> faces_left(Index a, Index b) const;
  std::vector<Triangle> faces_after(Index survivor, Index removed) const;
  void contract(const Choice& choice, Index survivor, Index removed);
  std::pair<Index, Index> stand_ins(const Choice& choice, Index survivor, Index removed) const;
  Quadric merge_seams(const Choice& choice);
  Quadric merge_quadrics(const Choice& choice);

  DecimateOptions options_;
  Frame frame_;
  std::vector<Vec3> positions_;
  std::vector<Index> stands_for_;  ///< per vertex, the input vertex that results name
  std::vector<Quadric> quadrics_;
  std::vector<Quadric> seams_;  ///< the planes of seams and folds, of vertices that forget all other planes
  std::vector<PointQuadric> points_;
  std::set<std::pair<Index, Index>> threshold_pairs_;  ///< lower vertex first; some may share a face
  bool stays_closed_ = false;                          ///< where parts may vanish
  bool had_threshold_pairs_ = false;                   ///< at the start
  BruteForceConstraints constraints_;
  std::optional<BruteForceMemory> memory_;  ///< of memoryless quadrics
  BruteForceAttributes attributes_;
  BruteForceAreas areas_;
  std::vector<Triangle> faces_;  ///< of the current mesh; those of sheets once
  BruteForceSides sides_;
};

}  // namespace whittle::test
