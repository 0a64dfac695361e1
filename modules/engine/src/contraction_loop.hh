#pragma once

#include <memory>
#include <optional>
#include <queue>
#include <vector>

#include "threshold_pair_sieve.hh"
#include "whittle/engine/bucket_queue.hh"
#include "whittle/engine/crew.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/flip_limit.hh"
#include "whittle/engine/frame.hh"
#include "whittle/engine/pair_evaluation.hh"
#include "whittle/engine/triangle_complex.hh"
#include "whittle/engine/waiting_pairs.hh"

namespace whittle {

/// What the loop works with, all in the frame and in the complex's numbering.
struct LoopSettings {
  DecimateTarget target;
  Frame frame;
  std::vector<std::uint8_t> locked;  ///< per vertex, or empty
};

/// Contracts pairs in order of cost until a target is reached.
///
/// A pair's place in the queue is a lower bound of its cost (see `PairEvaluation::bound`), so a contraction touches no
/// neighbour's entry. Pairs are evaluated when their bucket is opened, all of them in one go, and once more when their
/// turn comes if one of their vertices has changed. Two kinds of pair can get cheaper, and wait at their vertices to be
/// looked at again:
/// - raised: its cost is above its bound (pinned, or placed elsewhere than at the minimum). It is queued under its
///   cost, until one of its vertices merges.
/// - refused: a guard refused it. It is in no queue, until one of its vertices or of their neighbours changes.
/// A third kind waits in no queue, too: threshold pairs that an edge decides (`ThresholdPairSieve`).
class ContractionLoop {
 public:
  ContractionLoop(TriangleComplex& complex, const DecimateOptions& options, LoopSettings settings);

  DecimateResult run();

 private:
  static constexpr std::size_t pairs_per_parcel = 64;

  /// A pair under its true cost.
  struct Candidate {
    double cost;
    std::uint64_t tie;  ///< the lower, then the higher original number of the two vertices
    Pair pair;
    Index placement = invalid_index;  ///< its number among `placements_`, if there
  };
  static bool is_before(const Candidate& x, const Candidate& y) {
    return x.cost != y.cost ? x.cost < y.cost : x.tie < y.tie;
  }
  /// Where a pair would go.
  struct Placed {
    Vec3 position;
    bool is_minimum;
  };
  /// Pairs that are evaluated together, edges first: some microseconds, and all of it stays in the nearest cache.
  struct Parcel {
    std::size_t n = 0;
    std::array<Pair, pairs_per_parcel> pairs;
    std::array<PairEvaluation, pairs_per_parcel> evaluations;
  };
  struct IsAfter {
    bool operator()(const Candidate& x, const Candidate& y) const { return is_before(y, x); }
  };
  enum class Refusal { none, link, flip, locked, is_edge };

  void fill_queue();
  bool target_reached() const;
  bool report_progress() const;

  std::optional<Candidate> next_candidate();
  void open_bucket();
  void drop_duplicates();
  void evaluate_members();
  void evaluate_members_on_all_threads();
  void find_pairs(std::size_t begin, std::size_t end, Parcel& parcel);
  void sort_in(const Parcel& parcel);
  void sort_in(const Pair& pair, const PairEvaluation& evaluation);
  void prefetch_turns();
  void enqueue(const Candidate& candidate);

  /// The vertex of the lower original number first.
  Pair in_order(const Pair& pair) const;
  Pair pair_now(Index id) const;
  Candidate candidate(const Pair& pair, double cost) const;
  Pinned pinned(const Pair& pair) const;
  PlacedQuadric placed(const Pair& pair, Index v) const;
  PairEvaluation evaluate(const Pair& pair) const;
  Parcel& evaluate(Parcel& parcel) const;
  bool is_unchanged(const Candidate& candidate) const;
  std::optional<StopReason> take_turn(const Candidate& then);
  Refusal find_refusal(const Pair& pair, const Vec3& position);
  Refusal find_topological_refusal(const Pair& pair);
  void contract(const Pair& pair, double cost, const Placed& placement);

  void note_raised(const Pair& pair, const PairEvaluation& evaluation) {
    if (evaluation.cost > evaluation.bound || is_raised_[pair.id]) add_raised(pair, evaluation.cost);
  }
  void add_raised(const Pair& pair, double cost);
  void wake_raised(Index survivor, Index removed);
  void refuse(const Pair& pair, Refusal refusal);
  void wake_refused_around(Index survivor, Index removed);
  void wake_refused_at(Index v);
  void reveal_at(Index v);
  void queue_anew(const Pair& pair);
  bool is_locked(Index v) const { return !settings_.locked.empty() && settings_.locked[v] != 0; }

  TriangleComplex& complex_;
  const DecimateOptions& options_;
  LoopSettings settings_;
  FlipLimit flip_limit_;
  bool cost_times_area_;
  Crew crew_;
  std::uint64_t n_initial_vertices_;
  std::uint64_t n_initial_faces_;

  BucketQueue queue_;
  std::vector<Index> members_;      ///< of the bucket being opened
  std::vector<Parcel> parcels_;     ///< scratch: a thread works on one at a time
  LargeArray<Candidate> batch_;     ///< candidates of the open bucket, in order
  std::vector<Placed> placements_;  ///< where they would go
  Index n_done_at_opening_ = 0;     ///< contractions before it was opened
  std::size_t n_taken_ = 0;         ///< how many of the batch have had their turn
  /// Those for the open bucket, or one before it, that turned up after it was opened.
  std::priority_queue<Candidate, std::vector<Candidate>, IsAfter> late_;

  WaitingPairs raised_;
  std::vector<bool> is_raised_;            ///< per pair
  std::unique_ptr<float[]> raised_costs_;  ///< per pair, what a raised one is queued under; undefined for others
  WaitingPairs refused_;
  std::vector<bool> is_refused_;  ///< per pair
  std::vector<Index> woken_;      ///< scratch
  ThresholdPairSieve sieve_;

  PairStar star_;
  DecimateResult result_;
};

}  // namespace whittle
