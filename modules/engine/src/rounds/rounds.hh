#pragma once

#include <optional>
#include <span>
#include <vector>

#include "complex/link.hh"
#include "cost/sparse_quadrics.hh"
#include "loop/stage_context.hh"
#include "loop/working_surface.hh"
#include "rounds/area_counts.hh"
#include "rounds/cost_counts.hh"
#include "rounds/held_pairs.hh"
#include "rounds/merged_star.hh"
#include "rounds/pair_costs.hh"
#include "rounds/round_mesh.hh"
#include "rounds/valences.hh"

namespace whittle {

/// Contracts pairs of a part of a surface in rounds, by memoryless quadrics (memoryless_term.hh):
///
///   sum up the planes of the faces at each vertex
///   rank all pairs by these, and by attributes
///   take those that cost little in the order of cost, by its leading bits, and then of their numbers:
///     if one of the two was merged in this round: the pair waits for the next one
///     if the link condition refuses it: count that; the pair waits until the faces at one of the two change
///     if the faces at one of the two have changed: sum up its planes, and rank the pair anew
///     if the pair costs more than a round may: it waits
///     if another guard refuses it: as the link condition
///     if it moves the surface farther than a limit, if there is one: the same, and isn't counted
///     else contract
///
/// A frozen vertex takes part in no contraction. An irregular one, on a border or where the surface isn't manifold,
/// remembers its planes, as MemorylessCost has it.
class Rounds {
 public:
  /// \param surface its cost state is taken away; faces and areas must outlive this
  Rounds(WorkingSurface& surface, const StageContext& context, RoundScratchPool& pool);
  Rounds(const Rounds&) = delete;
  Rounds& operator=(const Rounds&) = delete;
  ~Rounds() { pool_.give_back(std::move(scratch_)); }

  /// \param target with a limit of faces or vertices: nothing is contracted beyond it
  void start(const DecimateTarget& target) { target_ = target; }
  /// Contracts what costs at most so much, round after round, as long as it is worth while. \param cost in the frame
  void run(double cost);

  // Round by round, for several parts that are contracted in step.

  void begin_round();
  /// How many pairs there are of each cost. \pre begin_round
  const CostCounts& cost_counts() const { return scratch_->cost_counts; }
  /// \return how many pairs had their turn. If none is contracted, all these are held, and don't come again
  std::uint64_t contract(const RoundLimit& limit);

  std::uint64_t n_contractions() const { return n_contractions_; }
  std::uint64_t n_vertices() const { return n_inner_ + mesh_.n_frozen() - n_contractions_; }  ///< now, with faces
  std::uint64_t n_faces() const { return n_faces_; }                                          ///< now
  /// Of vertices with faces, at the start: those that aren't frozen by the context, and the others.
  std::size_t n_inner_vertices() const { return n_inner_; }
  std::size_t n_frozen_vertices() const { return mesh_.n_frozen(); }
  /// Frozen vertices, and edges between two of them, are not counted. At the start.
  const NonmanifoldCounts& nonmanifold() const { return nonmanifold_; }
  DecimateResult result() const;

  /// What each vertex has become.
  std::vector<Index> merged_into() const { return mesh_.merged_into(); }
  Vec3 position(Index v) const { return mesh_.point(v); }
  /// \param vertices that are left, ascending
  CostState state(std::span<const Index> vertices) const;

 private:
  /// What is the case with a vertex. Most have none of it.
  enum Flag : std::uint8_t {
    frozen = 1,     ///< it takes part in no contraction
    irregular = 2,  ///< its faces are not one closed fan, or were not once; it remembers its planes
    on_seam = 4,    ///< it has planes of seams besides those of its faces
    locked = 8      ///< it stays where it is
  };
  /// What has become of it in this round.
  enum State : std::uint8_t {
    as_before = 0,
    taken = 1,    ///< it is one of a pair that was contracted
    outdated = 2  ///< its faces have changed, and the sums over them are those before
  };

  // rounds_start.cc
  void look_at_vertices(const StageContext& context);
  void look_at_irregular(Index v, Link& link, std::span<const std::uint8_t> frozen_by_context);
  SymmetricMatrix planes_of_borders(Index v) const;
  void take_over(const CostState& before);

  void sum_up();
  void list_pairs();
  std::size_t divide_places();
  void list_pairs_at(std::span<const Index> vertices, PairChunk& chunk);
  void list_pairs_at(Index v);
  void sort_candidates(float most);
  bool goes_on();
  IndexedMesh surface_now() const;
  bool is_target_reached() const;
  void take(const VertexPair& pair, float most);
  void refresh(Index v, std::size_t end);
  void penalize(std::span<const VertexPair> pairs, std::span<float> costs) const;
  PairEvaluation rank(const VertexPair& pair) const;
  Index survivor(const VertexPair& pair, const Vec3& position) const;
  PlacedQuadric placed(Index v) const;
  SymmetricMatrix matrix(Index v) const;
  Index now() const { return static_cast<Index>(n_contractions_); }
  void note_change(Index v) {
    states_[v] |= outdated;
    held_.note_change(v, now());
  }
  bool is_special(const VertexPair& pair) const { return (flags_[pair.a] | flags_[pair.b]) != 0; }
  bool has(Index v, Flag flag) const { return (flags_[v] & flag) != 0; }
  bool forgets(const VertexPair& pair) const { return !has(pair.a, irregular) && !has(pair.b, irregular); }
  std::optional<Refusal> refusal_at(const Vec3& position);
  bool makes_thin(const Vec3& position) const;
  double displacement_limit(const VertexPair& pair) const;
  bool moves_far(const VertexPair& pair, const Vec3& position);
  void refuse(const VertexPair& pair, Refusal why) {
    ++refusals_[why];
    held_.add_refused(pair, now());
  }
  std::span<const Index> vanishing_faces(Index a);
  void merge(const VertexPair& pair, const PairEvaluation& ranked, const Vec3& position, double cost);
  void merge_knowledge(const VertexPair& pair, Index survivor, Index removed, const PairEvaluation& ranked,
                       const Vec3& position);

  const DecimateOptions& options_;
  QuadricOptions quadric_;
  Frame frame_;                ///< of the model
  Frame::CostUnit cost_unit_;  ///< of the model
  ContractionLog* log_;
  FlipLimit flip_limit_;
  MeanFaceArea face_area_;
  std::optional<double> displacement_;  ///< of the surface by one contraction, at most
  std::vector<double> displacements_;   ///< in place of that, per vertex; or empty
  DecimateTarget target_ = DecimateTarget::as_far_as_possible();

  RoundScratchPool& pool_;
  std::unique_ptr<RoundScratch> scratch_;
  RoundMesh mesh_;
  std::vector<std::uint8_t> flags_;  ///< per vertex
  SparseQuadrics remembered_;        ///< of vertices on borders
  SparseQuadrics seams_;
  AttributeQuadrics attributes_;
  std::vector<Index> special_;  ///< vertices with flags that are left, but for frozen ones
  AreaCounts areas_;
  Valences valences_;
  std::size_t n_inner_ = 0;
  std::uint64_t n_degenerate_faces_ = 0;
  NonmanifoldCounts nonmanifold_;

  // Of a round
  std::vector<std::uint8_t> states_;  ///< per vertex
  std::span<StarPlanes> stars_;       ///< per vertex
  bool has_begun_ = false;            ///< the first round, of which the sums are those of the start
  std::size_t n_candidates_ = 0;
  HeldPairs held_;
  PairCosts pair_costs_;
  MergedStar star_;
  std::vector<Index> vanishing_;  ///< scratch
  BorderMotion border_motion_;

  std::size_t n_faces_ = 0;  ///< now
  std::uint64_t n_contractions_ = 0;
  double max_cost_ = 0;
  RefusalCounts refusals_;
  bool is_cancelled_ = false;
};

}  // namespace whittle
