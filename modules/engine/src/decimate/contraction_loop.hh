#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "complex/triangle_complex.hh"
#include "guard/restraints.hh"
#include "guard/sharp_edges.hh"
#include "pairs/threshold_pair_sieve.hh"
#include "queue/pair_order.hh"
#include "queue/waiting_pairs.hh"
#include "whittle/core/frame.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/flip_limit.hh"

namespace whittle {

/// Contracts pairs in order of cost until a target is reached.
///
/// A pair whose turn comes and that a guard refuses leaves the order, and waits at its vertices until one of these or
/// of their neighbours changes. Another kind waits, too: threshold pairs that an edge decides (`ThresholdPairSieve`).
class ContractionLoop {
 public:
  ContractionLoop(TriangleComplex& complex, const DecimateOptions& options, const DecimateTarget& target,
                  const Frame& frame, Restraints restraints);

  DecimateResult run();

  /// By vertices of the complex.
  std::vector<VertexPair> feature_edges() const { return restraints_.feature_edges(complex_); }

 private:
  enum class Refusal { none, link, flip, shape, feature, locked, is_edge };

  bool target_reached() const;
  bool report_progress() const;
  std::optional<StopReason> take(Turn turn);

  Refusal place(Turn& turn);
  Refusal find_refusal_of(const Vec3& position, const Pair& pair);
  Refusal find_topological_refusal(const Pair& pair);
  bool turns_a_face(const Vec3& position, const Pair& pair);
  bool makes_thin(const Wings& wings, const Vec3& from, const Vec3& to) const;
  void refuse(const Pair& pair, Refusal refusal);

  void contract(const Turn& turn);
  void list_changed(Index survivor);
  void wake_refused_around(Index survivor, Index removed);
  void wake_refused_at(Index v);
  void reveal_at(Index v);

  TriangleComplex& complex_;
  const DecimateOptions& options_;
  DecimateTarget target_;
  Frame frame_;
  Restraints restraints_;
  SharpEdges sharp_edges_;
  FlipLimit flip_limit_;
  std::uint64_t n_initial_vertices_;
  std::uint64_t n_initial_faces_;

  ThresholdPairSieve sieve_;
  std::unique_ptr<PairCost> cost_;
  std::unique_ptr<PairOrder> order_;
  Reach listed_;  ///< which vertices are listed as changed
  WaitingPairs refused_;
  std::vector<bool> is_refused_;  ///< per pair
  std::vector<Index> woken_;      ///< scratch
  std::vector<Index> changed_;    ///< scratch: as `PairCost::note_contraction` says

  PairStar star_;
  DecimateResult result_;
};

}  // namespace whittle
